#include "services/remote/address.h"

#include <gtest/gtest.h>

namespace race::remote {
namespace {

TEST(Address, IsHostAndPortOfAUrl) {
  const auto address = read_address("http://127.0.0.1:8080/");
  ASSERT_TRUE(address);
  EXPECT_EQ(address->host, "127.0.0.1");
  EXPECT_EQ(address->port, 8080);
  EXPECT_FALSE(address->tls);
  EXPECT_EQ(read_address("http://localhost")->port, 80);
  EXPECT_EQ(read_address("https://localhost")->port, 443);
  EXPECT_EQ(read_address("https://localhost:8443")->port, 8443);
  EXPECT_TRUE(read_address("https://localhost/")->tls);
}

TEST(Address, ThatIsNoneIsRefused) {
  for (const char* url :
       {"", "127.0.0.1:8080", "ftp://a:1", "http://", "https://", "https://a:0", "http://:1", "http://a:", "http://a:0",
        "http://a:65536", "http://a:1x", "http://a:1/b", "http://a/b", "http://u@a:1", "http://[::1]:1"}) {
    const auto address = read_address(url);
    ASSERT_FALSE(address) << url;
    EXPECT_EQ(address.error().code, ErrorCode::syntax);
  }
}

}  // namespace
}  // namespace race::remote
