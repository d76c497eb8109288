#include "server/channels/channels.h"

#include <gmock/gmock.h>

#include <set>

namespace race::server {
namespace {

TEST(Channels, HaveOnePatternEach) {
  std::set<std::string_view> patterns;
  for (const ChannelKind& channel : channels()) patterns.insert(channel.pattern);
  EXPECT_EQ(patterns.size(), channels().size());
  EXPECT_THAT(patterns,
              testing::UnorderedElementsAre("cores", "services", "log", "cell/pose", "display/{name}",
                                            "flow/{service}/{flow}", "document/{name}", "presence/{name}", "proposals",
                                            "control", "core/{id}/state", "core/{id}/derivation"));
}

}  // namespace
}  // namespace race::server
