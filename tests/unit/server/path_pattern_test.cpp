#include "server/wire/path_pattern.h"

#include <gmock/gmock.h>

namespace race::server {
namespace {

TEST(PathPattern, BindsAPartToAName) {
  const auto parameters = match("/api/v1/cores/{id}/start", "/api/v1/cores/17/start");
  ASSERT_TRUE(parameters);
  EXPECT_THAT(*parameters, testing::ElementsAre(testing::Pair("id", "17")));
}

TEST(PathPattern, MatchesTheWholePathAlone) {
  for (const char* path : {"/api/v1/cores", "/api/v1/cores/", "/api/v1/cores/1/", "/api/v1/cores/1/2", "/api/v1/cor/1",
                           "/", "", "//", "/api/v1//cores/1"})
    EXPECT_FALSE(match("/api/v1/cores/{id}", path)) << path;
}

TEST(PathPattern, MatchesNamesWithoutALeadingSlash) {
  EXPECT_TRUE(match("cores", "cores"));
  EXPECT_EQ(match("core/{id}/state", "core/17/state").value().at("id"), "17");
  for (const char* name : {"core/17", "core//state", "core/17/state/", "core/1/7/state", "/core/17/state"})
    EXPECT_FALSE(match("core/{id}/state", name)) << name;
}

TEST(PathPattern, FillsInWhatItMatches) {
  EXPECT_EQ(fill("flow/{service}/{flow}", {"camera", "image"}), "flow/camera/image");
  EXPECT_EQ(fill("cores", {}), "cores");
  EXPECT_EQ(match("display/{name}", fill("display/{name}", {"main"})).value().at("name"), "main");
}

}  // namespace
}  // namespace race::server
