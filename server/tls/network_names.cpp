#include "server/tls/network_names.h"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <memory>

#include "server/tls/authority.h"

namespace race::server {
namespace {

struct FreeInterfaces {
  void operator()(ifaddrs* all) const { ::freeifaddrs(all); }
};

// The address as text; empty: it is of another family, or of one interface alone (fe80:: needs its name).
std::string text_of(const sockaddr& address) {
  std::array<char, INET6_ADDRSTRLEN> text{};
  const void* bytes = nullptr;
  if (address.sa_family == AF_INET) bytes = &reinterpret_cast<const sockaddr_in&>(address).sin_addr;
  if (address.sa_family == AF_INET6) bytes = &reinterpret_cast<const sockaddr_in6&>(address).sin6_addr;
  if (!bytes || !::inet_ntop(address.sa_family, bytes, text.data(), text.size())) return "";
  const std::string name = text.data();
  return name.starts_with("fe80:") ? "" : name;
}

std::string name_of_machine() {
  std::array<char, 256> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0) return "";
  const std::string full = name.data();
  return full.substr(0, full.find('.'));
}

}  // namespace

std::vector<std::string> network_names() {
  ifaddrs* first = nullptr;
  if (::getifaddrs(&first) != 0) first = nullptr;
  const std::unique_ptr<ifaddrs, FreeInterfaces> all(first);
  std::vector<std::string> names;
  for (const ifaddrs* each = first; each; each = each->ifa_next) {
    if (!each->ifa_addr || (each->ifa_flags & IFF_UP) == 0 || (each->ifa_flags & IFF_LOOPBACK) != 0) continue;
    const std::string name = text_of(*each->ifa_addr);
    if (is_local_name(name) && std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  std::ranges::stable_partition(names, [](const std::string& name) { return name.find(':') == std::string::npos; });
  if (const std::string machine = name_of_machine(); !machine.empty() && machine != "localhost")
    names.push_back(machine + ".local");
  return names;
}

}  // namespace race::server
