#include "server/wire/version.h"

namespace race::server {

std::string_view version() { return RACE_VERSION; }

std::string_view compiler() { return RACE_COMPILER; }

}  // namespace race::server
