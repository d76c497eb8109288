#include "server/store/read_file.h"

#include <fstream>
#include <iterator>

namespace race::server {

Expected<std::string> read_file(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.is_open() || stream.bad()) return unexpected(ErrorCode::io, "cannot be read", path);
  return text;
}

}  // namespace race::server
