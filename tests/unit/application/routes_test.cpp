#include "server/handlers/routes.h"

#include <gmock/gmock.h>

#include <fstream>
#include <set>

namespace race::server {
namespace {

using Names = std::set<std::pair<std::string, std::string>>;  // method, path

// The paths and methods of api/openapi.yaml, by its indentation.
Names interface() {
  std::ifstream file(RACE_SOURCE_DIR "/api/openapi.yaml");
  Names names;
  std::string path;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("  /") && line.ends_with(":")) path = line.substr(2, line.size() - 3);
    for (std::string method : {"get", "put", "post", "delete", "patch"}) {
      if (line != "    " + method + ":") continue;
      for (char& c : method) c = static_cast<char>(c - 32);
      names.emplace(method, path);
    }
  }
  return names;
}

TEST(Routes, AreThoseOfTheInterface) {
  Names ours = {{"GET", "/api/v1/stream"}, {"GET", "/api/v1/components"}};  // served by the listener
  for (const Route& route : routes()) ours.emplace(route.method, route.pattern);
  EXPECT_EQ(ours, interface());
  EXPECT_EQ(ours.size(), routes().size() + 2) << "a route stands twice";
}

}  // namespace
}  // namespace race::server
