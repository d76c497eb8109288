// What reaches the parser of URDF texts is bounded; texts that hide their depth are refused.
#include "services/world/urdf_limits.h"

#include <gtest/gtest.h>

#include "services/world/robot_model.h"

namespace race::world {
namespace {

std::string repeat(std::size_t times, const std::string& text) {
  std::string all;
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

std::string code(const std::string& text) {
  const auto good = check_urdf_text(text);
  return good ? "" : std::string(name(good.error().code));
}

// A robot with this many links, one after the other.
std::string chain(std::size_t links) {
  std::string text = "<robot name='r'><link name='0'/>";
  for (std::size_t i = 1; i < links; ++i) {
    const std::string child = std::to_string(i), parent = std::to_string(i - 1);
    text += "<link name='" + child + "'/><joint name='j" + child + "' type='fixed'><parent link='" + parent +
            "'/><child link='" + child + "'/></joint>";
  }
  return text + "</robot>";
}

TEST(UrdfLimits, ElementsAreAsDeepAsTheyMayBe) {
  const auto nested = [](std::size_t depth) { return repeat(depth, "<a>") + repeat(depth, "</a>"); };
  EXPECT_EQ(code(nested(kUrdfDepth)), "");
  EXPECT_EQ(code(nested(kUrdfDepth + 1)), "too_deep");
  EXPECT_EQ(code(repeat(1'000'000, "<a>")), "too_deep");
  EXPECT_EQ(code("<r>" + repeat(kUrdfDepth * 2, "<a b=\"1/2\"/><c></c>") + "</r>"), "");
}

TEST(UrdfLimits, ADepthThatIsHiddenIsRefused) {
  for (const char* hidden :
       {"<a b=\"/>\">", "<a b='</a>'>", "<a><![CDATA[</a>]]>", "<a><!DOCTYPE </a>>", "<a><?x </a>?>", "<a b=\">\"/>",
        "<a><?xml version='></a>'?>", "<a><!-- </a>", "</a><a>", "<a", "<a b=\"/>"})
    EXPECT_EQ(code(repeat(kUrdfDepth + 1, hidden)), "syntax") << hidden;
  EXPECT_EQ(code(repeat(kUrdfDepth + 1, "<a><!-- </a> -->")), "too_deep");
  EXPECT_EQ(code(std::string("<a>\0</a>", 8)), "syntax");
}

TEST(UrdfLimits, ADeclarationMayStandAtTheBeginningAlone) {
  const std::string declaration = "<?xml version='1.0'?>";
  EXPECT_EQ(code(declaration + "<!-- an arm --><robot/>"), "");
  for (const char* before : {"<!-- an arm -->", "<a/>", "<?xml version='1.0'?>"})
    EXPECT_EQ(code(before + declaration + "<robot/>"), "syntax") << before;
}

TEST(UrdfLimits, ItsElementsLinksAndJointsAreCounted) {
  EXPECT_EQ(code(repeat(kUrdfElements, "<a/>")), "");
  EXPECT_EQ(code(repeat(kUrdfElements + 1, "<a/>")), "too_large");
  EXPECT_EQ(code(repeat(kUrdfElements + 1, "<!---->")), "too_large");
  EXPECT_EQ(code(repeat(kUrdfLinks, "<link/><joint/>")), "");
  EXPECT_EQ(code(repeat(kUrdfLinks + 1, "<link name='a'/>")), "too_large");
  EXPECT_EQ(code(repeat(kUrdfLinks + 1, "<joint>\n</joint>")), "too_large");
  EXPECT_EQ(code(repeat(kUrdfLinks + 1, "<linked/>")), "");
}

TEST(UrdfLimits, AChainOfLinksEnds) {
  EXPECT_TRUE(read_urdf(chain(kUrdfChain)));
  const auto longer = read_urdf(chain(kUrdfChain + 1));
  ASSERT_FALSE(longer);
  EXPECT_EQ(longer.error().code, ErrorCode::too_deep);
}

}  // namespace
}  // namespace race::world
