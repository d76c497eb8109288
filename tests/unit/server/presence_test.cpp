// Who is at a document: what is told of them and when, how many there may be, and what a client may say.
#include "server/editing/presence.h"

#include <gmock/gmock.h>

#include "core/value/json.h"
#include "server/editing/presence_request.h"

namespace race::server {
namespace {

using std::chrono::milliseconds;
using testing::ElementsAre;
using testing::IsEmpty;

Value person(const std::string& name, std::int64_t offset = 0) {
  return Dict{{"name", name}, {"text", Dict{{"field", "when"}, {"offset", offset}}}};
}

class PresenceTest : public testing::Test {
 protected:
  /// Somebody of this number says something.
  Expected<Presence::Shown> show(int who, const std::string& document, Value what) {
    return presence_.show(places_.data() + who, document, std::move(what), now_);
  }
  void leave(int who) { presence_.leave(places_.data() + who); }
  /// What is told now, "doc: Ada 3, -2": name and offset of those who changed, ids of those who left.
  std::vector<std::string> told() {
    std::vector<std::string> out;
    for (const auto& [document, data] : presence_.take_due(now_)) {
      std::string line = document + ":";
      for (const Value& each : data.find("people")->as_list()) line += " " + text_of(each);
      for (const Value& id : data.find("left")->as_list()) line += " -" + std::to_string(id.as_integer());
      out.push_back(std::move(line));
    }
    return out;
  }
  std::vector<std::string> there(const std::string& document) {
    std::vector<std::string> out;
    const Value snapshot = presence_.snapshot(document);
    for (const Value& each : snapshot.find("people")->as_list()) out.push_back(text_of(each));
    return out;
  }
  static std::string text_of(const Value& each) {
    return each.find("name")->as_string() + "/" + std::to_string(each.find("id")->as_integer()) + "@" +
           std::to_string(each.find("text")->find("offset")->as_integer());
  }

  std::vector<char> places_ = std::vector<char>(200);
  Presence presence_;
  Presence::Time now_{std::chrono::hours(1)};
};

TEST_F(PresenceTest, TellsTheLastOfWhatIsSaidWithinAPeriod) {
  ASSERT_TRUE(show(0, "task", person("Ada", 1)));
  EXPECT_THAT(told(), ElementsAre("task: Ada/1@1")) << "the first at once";
  for (int i = 2; i < 9; ++i) ASSERT_TRUE(show(0, "task", person("Ada", i)));
  EXPECT_THAT(told(), IsEmpty());
  EXPECT_EQ(presence_.next_due(), now_ + Presence::kPeriod);
  now_ += Presence::kPeriod - milliseconds(1);
  EXPECT_THAT(told(), IsEmpty());
  now_ += milliseconds(1);
  EXPECT_THAT(told(), ElementsAre("task: Ada/1@8"));
  EXPECT_EQ(presence_.next_due(), std::nullopt);
  ASSERT_TRUE(show(0, "task", person("Ada", 8)));
  EXPECT_EQ(presence_.next_due(), std::nullopt) << "nothing has changed";
}

TEST_F(PresenceTest, TellsEachDocumentApart) {
  ASSERT_TRUE(show(0, "task", person("Ada")));
  ASSERT_TRUE(show(1, "other", person("Bob")));
  EXPECT_THAT(told(), ElementsAre("other: Bob/2@0", "task: Ada/1@0"));
  EXPECT_THAT(there("task"), ElementsAre("Ada/1@0"));
  EXPECT_THAT(there("third"), IsEmpty());
}

TEST_F(PresenceTest, KnowsTwoOfOneNameApart) {
  const auto one = show(0, "task", person("Ada")), other = show(1, "task", person("Ada"));
  EXPECT_NE(one->id, other->id);
  EXPECT_NE(presence_.snapshot("task").find("people")->as_list()[0].find("colour")->as_integer(),
            presence_.snapshot("task").find("people")->as_list()[1].find("colour")->as_integer());
}

TEST_F(PresenceTest, TakesNoIdAndNoColourFromAPerson) {
  Value claims = person("Ada");
  claims.mutable_dict().set("id", 77);
  claims.mutable_dict().set("colour", 99);
  ASSERT_TRUE(show(0, "task", claims));
  ASSERT_TRUE(show(0, "task", claims));
  const Value shown = presence_.snapshot("task").find("people")->as_list()[0];
  EXPECT_EQ(shown.find("id")->as_integer(), 1);
  EXPECT_EQ(shown.find("colour")->as_integer(), 0);
}

TEST_F(PresenceTest, GivesTheColourThatFewestHave) {
  const auto colour = [&](int who) {
    EXPECT_TRUE(show(who, "task", person("Ada")));
    const Value snapshot = presence_.snapshot("task");
    return snapshot.find("people")->as_list().back().find("colour")->as_integer();
  };
  for (int i = 0; i < Presence::kColours; ++i) EXPECT_EQ(colour(i), i);
  leave(3);
  EXPECT_EQ(colour(20), 3);
  EXPECT_EQ(colour(21), 0);
}

TEST_F(PresenceTest, TellsThatSomebodyHasLeft) {
  ASSERT_TRUE(show(0, "task", person("Ada")));
  ASSERT_TRUE(show(1, "task", person("Bob")));
  told();
  now_ += Presence::kPeriod;
  leave(0);
  EXPECT_THAT(told(), ElementsAre("task: -1"));
  now_ += Presence::kPeriod;
  leave(0);
  EXPECT_THAT(told(), IsEmpty());
  presence_.leave(places_.data() + 1, "other");
  EXPECT_THAT(there("task"), ElementsAre("Bob/2@0")) << "they are not at that document";
  presence_.leave(places_.data() + 1, "task");
  EXPECT_TRUE(presence_.empty());
  EXPECT_THAT(told(), ElementsAre("task: -2"));
}

TEST_F(PresenceTest, IsAtOneDocumentAtATime) {
  ASSERT_TRUE(show(0, "task", person("Ada")));
  told();
  now_ += Presence::kPeriod;
  const auto shown = show(0, "other", person("Ada"));
  EXPECT_TRUE(shown->is_new);
  EXPECT_THAT(told(), ElementsAre("other: Ada/2@0", "task: -1"));
}

TEST_F(PresenceTest, DropsWhoSaysNothing) {
  ASSERT_TRUE(show(0, "task", person("Ada")));
  now_ += milliseconds(500);
  ASSERT_TRUE(show(1, "task", person("Bob")));
  now_ += milliseconds(500);
  ASSERT_TRUE(show(0, "task", person("Ada"))) << "the same once more is a sign of life";
  presence_.drop_silent(now_ - milliseconds(100));
  EXPECT_THAT(there("task"), ElementsAre("Ada/1@0"));
  const auto back = show(1, "task", person("Bob"));
  EXPECT_TRUE(back->is_new);
  EXPECT_EQ(back->id, 3);
}

TEST_F(PresenceTest, ShowsSoManyPeopleAndTheNextOnceOneLeaves) {
  const int most = Presence::kMostPeople;
  for (int i = 0; i < most; ++i) ASSERT_TRUE(show(i, "task", person("Ada")));
  const auto refused = show(most, "task", person("Bob"));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::too_large);
  EXPECT_EQ(there("task").size(), Presence::kMostPeople);
  EXPECT_TRUE(show(7, "task", person("Ada", 2))) << "who is there goes on";
  EXPECT_TRUE(show(most, "other", person("Bob"))) << "each document has its own";
  leave(7);
  EXPECT_TRUE(show(most, "task", person("Bob")));
}

TEST_F(PresenceTest, KeepsNothingOfDocumentsWhereNobodyIs) {
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(show(0, "task-" + std::to_string(i), person("Ada")));
  leave(0);
  told();
  now_ += Presence::kPeriod;
  EXPECT_THAT(told(), IsEmpty());
  EXPECT_EQ(presence_.next_due(), std::nullopt);
  EXPECT_EQ(presence_.documents(), 0U);
}

// What a client may say

std::vector<std::string> errors_of(const std::string& json) {
  std::vector<Error> errors;
  read_presence_request(parse_json(json).value(), errors);
  std::vector<std::string> out;
  for (const Error& error : errors) out.push_back(error.path + " " + std::string(name(error.code)));
  return out;
}

std::vector<std::string> errors_with(const std::string& more, const std::string& name = "Ada") {
  return errors_of(R"({"type": "presence", "document": "task", "name": ")" + name + "\"" + more + "}");
}

std::string repeated(const std::string& text, std::size_t count) {
  std::string out;
  while (count-- > 0) out += text;
  return out;
}

std::string selection_of(std::size_t count) {
  std::string ids;
  for (std::size_t i = 0; i < count; ++i) ids += (i == 0 ? "" : ",") + std::string("\"s\"");
  return R"(, "selection": [)" + ids + "]";
}

TEST(PresenceRequest, IsReadWithAllThatAPersonDoes) {
  std::vector<Error> errors;
  const auto read = read_presence_request(
      parse_json(R"({"type": "presence", "document": "task", "name": "Ada", "level": "root", "selection": ["a", "b"],
                     "text": {"element": "a", "field": "meta:key", "offset": 3},
                     "pointer": {"element": "b", "x": 1, "y": -2.5}})")
          .value(),
      errors);
  EXPECT_THAT(errors, IsEmpty());
  EXPECT_EQ(read.document, "task");
  EXPECT_EQ(
      to_json(read.person),
      R"({"name":"Ada","level":"root","selection":["a","b"],"text":{"element":"a","field":"meta:key","offset":3},)"
      R"("pointer":{"element":"b","x":1.0,"y":-2.5}})");
}

TEST(PresenceRequest, IsRefusedBeyondItsBounds) {
  EXPECT_THAT(errors_with("", repeated("ä", PresenceRequest::kMaxName)), IsEmpty());
  EXPECT_THAT(errors_with("", repeated("ä", PresenceRequest::kMaxName + 1)), ElementsAre("name too_large"));
  EXPECT_THAT(errors_with(selection_of(PresenceRequest::kMaxSelection)), IsEmpty());
  EXPECT_THAT(errors_with(selection_of(PresenceRequest::kMaxSelection + 1)), ElementsAre("selection too_large"));
  EXPECT_THAT(errors_with(R"(, "text": {"field": ")" + repeated("f", 129) + R"(", "offset": 0})"),
              ElementsAre("text/field too_large"));
  EXPECT_THAT(errors_with(R"(, "text": {"field": "when", "offset": 1048577})"),
              ElementsAre("text/offset out_of_range"));
  EXPECT_THAT(errors_with(R"(, "text": {"field": "when", "offset": -1})"), ElementsAre("text/offset out_of_range"));
  EXPECT_THAT(errors_with(R"(, "pointer": {"element": "a", "x": 1e7, "y": 0})"), ElementsAre("pointer/x out_of_range"));
  EXPECT_THAT(errors_with(R"(, "pointer": {"element": "a", "x": 0, "y": -1e300})"),
              ElementsAre("pointer/y out_of_range"));
}

TEST(PresenceRequest, IsRefusedIfItHasAnotherShape) {
  EXPECT_THAT(errors_of(R"({"type": "presence"})"), ElementsAre("document missing", "name missing"));
  EXPECT_THAT(errors_with("", "   "), ElementsAre("name name"));
  EXPECT_THAT(errors_with("", R"(A\u0007)"), ElementsAre("name name"));
  EXPECT_THAT(errors_with(R"(, "level": "a b")"), ElementsAre("level name"));
  EXPECT_THAT(errors_with(R"(, "selection": ["a b"])"), ElementsAre("selection name"));
  EXPECT_THAT(errors_with(R"(, "selection": "a")"), ElementsAre("selection type"));
  EXPECT_THAT(errors_with(R"(, "text": 3)"), ElementsAre("text type"));
  EXPECT_THAT(errors_with(R"(, "pointer": {"element": "a", "x": 0})"), ElementsAre("pointer/y missing"));
  EXPECT_THAT(errors_with(R"(, "id": 3, "colour": 1)"), ElementsAre("id unknown_field", "colour unknown_field"));
}

}  // namespace
}  // namespace race::server
