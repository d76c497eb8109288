#include <gtest/gtest.h>

#include "core/value/json.h"
#include "server/mcp/skills.h"

namespace race::server::mcp {
namespace {

List skills_in(const std::string& library) {
  return skills_of("d", parse_json(R"({"library": )" + library + "}").value());
}

TEST(Skills, AreTheLibraryStatesWithTheMark) {
  EXPECT_TRUE(
      skills_in(
          R"([{"state": "A"}, {"state": "B", "meta": {"skill": false}}, {"state": "C", "meta": {"support": true}}])")
          .empty());
  const List skills =
      skills_in(R"([{"state": "A", "doc": "Does.", "meta": {"skill": true, "title": "Do", "category": "flow"}}])");
  EXPECT_EQ(to_json(skills), R"([{"document":"d","skill":"A","description":"Does.","title":"Do","category":"flow",)"
                             R"("parameters":[],"results":[],"ports":[]}])");
}

TEST(Skills, TellParametersWithTheirRangesAndErrorsWithTheirAdvice) {
  const List skills = skills_in(R"([{"state": "A", "meta": {"skill": true},
      "parameters": [{"name": "w", "unit": "m", "value": 0.1, "type": "number", "from": "x", "doc": "Wide",
                      "meta": {"id": "i", "title": "Width", "domain": "distance", "min": 0, "max": 1, "step": 0.1}},
                     {"name": "hidden", "meta": {"internal": true}}],
      "results": [{"name": "r", "type": "pose", "meta": {"domain": "found"}}],
      "ports": [{"name": "lost", "when": "x", "meta": {"title": "It is lost", "advice": "Search."}}]}])");
  const Value& skill = skills.front();
  EXPECT_EQ(to_json(*skill.find("parameters")),
            R"([{"name":"w","type":"number","unit":"m","value":0.1,"description":"Wide","title":"Width",)"
            R"("domain":"distance","min":0,"max":1,"step":0.1}])");
  EXPECT_EQ(to_json(*skill.find("results")), R"([{"name":"r","type":"pose","domain":"found"}])");
  EXPECT_EQ(to_json(*skill.find("ports")), R"([{"name":"lost","title":"It is lost","advice":"Search."}])");
}

TEST(Skills, OfADraftOfAnyShapeAreReadAsFarAsTheyGo) {
  for (const char* library : {"null", "7", "{}", "[7, null, []]", R"([{"meta": 7}, {"meta": {"skill": "yes"}}])"})
    EXPECT_TRUE(skills_in(library).empty()) << library;
  EXPECT_EQ(skills_in(R"([{"meta": {"skill": true}, "parameters": 7, "ports": [7], "results": [null]}])").size(), 1U);
  EXPECT_TRUE(skills_of("d", Value()).empty());
}

}  // namespace
}  // namespace race::server::mcp
