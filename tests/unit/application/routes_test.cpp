#include "server/handlers/routes.h"

#include <gmock/gmock.h>

#include <fstream>
#include <map>
#include <set>
#include <sstream>

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

/// "PUT /api/v1/boot": whether api/openapi.yaml has a body for it, a key, and the parameters of its query,
/// by its indentation.
std::map<std::string, std::string> requests() {
  std::ifstream file(RACE_SOURCE_DIR "/api/openapi.yaml");
  std::map<std::string, std::string> out;
  std::string path, route;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("  /") && line.ends_with(":")) path = line.substr(2, line.size() - 3);
    for (std::string method : {"get", "put", "post", "delete", "patch"}) {
      if (line != "    " + method + ":") continue;
      for (char& c : method) c = static_cast<char>(c - 32);
      route = method + " " + path;
      out[route] = "";
    }
    if (line.starts_with("      requestBody:")) out[route] += " body";
    if (line.find("parameters/IdempotencyKey") != std::string::npos) out[route] += " key";
    if (line.find("parameters/ProposalAuthor") != std::string::npos) out[route] += " author";
    const auto name = line.find("{ name: ");
    if (name != std::string::npos && line.find("in: query") != std::string::npos)
      out[route] += " " + line.substr(name + 8, line.find(',') - name - 8);
  }
  return out;
}

TEST(Routes, HaveTheParametersAndBodiesOfTheInterface) {
  auto listed = requests();
  for (const Route& route : routes()) {
    std::set<std::string> ours, theirs;
    std::istringstream names(std::string(route.query) + (route.has_body ? " body" : "") +
                             (route.creates ? " key" : ""));
    for (std::string name; names >> name;) ours.insert(name);
    std::istringstream others(listed.at(std::string(route.method) + " " + std::string(route.pattern)));
    for (std::string name; others >> name;) theirs.insert(name);
    EXPECT_EQ(ours, theirs) << route.method << " " << route.pattern;
  }
}

TEST(Routes, AreThoseOfTheInterface) {
  Names ours = {{"GET", "/api/v1/stream"},
                {"GET", "/api/v1/control/hold"},
                {"GET", "/api/v1/components"}};  // served by the listener
  for (const Route& route : routes()) ours.emplace(route.method, route.pattern);
  EXPECT_EQ(ours, interface());
  EXPECT_EQ(ours.size(), routes().size() + 3) << "a route stands twice";
}

}  // namespace
}  // namespace race::server
