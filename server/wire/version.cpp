#include "server/wire/version.h"

namespace race::server {

std::string_view version() { return RACE_VERSION; }

}  // namespace race::server
