#include "server/control/mode_mark.h"

#include <filesystem>
#include <system_error>

#include "server/store/files.h"

namespace race::server {

Mode ModeMark::read() const {
  if (std::error_code unknown; !std::filesystem::exists(path_, unknown) && !unknown) return Mode::execution;
  const auto text = read_file(path_);
  return text ? mode_of(*text).value_or(Mode::programming) : Mode::programming;
}

Expected<void> ModeMark::write(Mode mode) const { return write_file(path_, std::string(name(mode)), kOwnerAlone); }

}  // namespace race::server
