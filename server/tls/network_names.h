// The names by which a local network knows this machine.
//
// Threads: any.
#pragma once

#include <string>
#include <vector>

namespace race::server {

/// The private addresses of its interfaces that are up, IPv4 first, without loopback: what a phone in the same network
/// can use. Then `NAME.local` (mDNS), if the machine has a name. Public addresses are left out.
std::vector<std::string> network_names();

}  // namespace race::server
