// Which requests of a display process the server answers, and which it refuses.
#include "services/display/remote_display_backend.h"

#include <gmock/gmock.h>

#include "core/value/json.h"
#include "services/display/screens.h"

namespace race::display {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Asked {
  std::string function, arguments, error;  // the path and the code
};

struct AnswerDisplayRequest : testing::TestWithParam<Asked> {
  AnswerDisplayRequest() { (void)screens.connect("main", true); }
  std::string error(const std::string& function, const std::string& arguments) {
    const Value json = parse_json(arguments).value();
    const auto answer = answer_display_request(screens, function, json.as_dict());
    return answer ? "none" : answer.error().path + ": " + std::string(name(answer.error().code));
  }
  Screens screens;
};

TEST_P(AnswerDisplayRequest, RefusesWhatNoDisplayAsks) {
  EXPECT_EQ(error(GetParam().function, GetParam().arguments), GetParam().error);
  EXPECT_EQ(screens.content("main"), (Content{"main", {}, {}, {}}));
}

INSTANTIATE_TEST_SUITE_P(
    Wrong, AnswerDisplayRequest,
    testing::Values(Asked{"sing", "{}", "sing: not_found"}, Asked{"choose", "{}", "choose: not_found"},
                    Asked{"play", R"({"sound": "beep"})", "play: not_found"},
                    Asked{"take", R"({"all": true})", "arguments: unknown_field"},
                    Asked{"show_text", "{}", "text: missing"}, Asked{"show_text", R"({"text": 1})", "text: type"},
                    Asked{"show_text", R"({"text": "x", "loud": 1})", ": type"},
                    Asked{"show_text", R"({"text": "x", "display": "a/b"})", "display: name"},
                    Asked{"show_progress", R"({"text": "x", "progress": 2})", "progress: out_of_range"},
                    Asked{"show_progress", R"({"text": "x", "progress": 1, "buttons": []})", ": type"},
                    Asked{"show_image", R"({"image": "secret.png"})", "image: not_found"},
                    Asked{"show_image", R"({"image": "data:text/html;base64,AAAA"})", "image: type"},
                    Asked{"ask", R"({"question": "Go?", "buttons": []})", "buttons: out_of_range"},
                    Asked{"ask", R"({"question": "Go?", "buttons": ["x", "x"]})", "buttons: duplicate"},
                    Asked{"ask_number", R"({"question": "n?", "min": 2, "max": 1})", "max: out_of_range"},
                    Asked{"clear", R"({"display": ""})", "display: name"}));

TEST_F(AnswerDisplayRequest, AnswersWhatIsNotConnectedAsTheScreensDo) {
  RemoteDisplayBackend remote{[this](std::string_view function, const Dict& arguments) {
    return answer_display_request(screens, function, arguments);
  }};
  const auto there = remote.ask("nobody", {0, "Go?", {"OK"}, {}}), here = screens.ask("nobody", {0, "Go?", {"OK"}, {}});
  ASSERT_FALSE(there);
  EXPECT_EQ(there.error(), here.error());
  EXPECT_EQ(remote.show("nobody", {"x", "", {}}).error(), screens.show("nobody", {"x", "", {}}).error());
  EXPECT_EQ(remote.clear("nobody").error(), screens.clear("nobody").error());
}

// Requests are sent only when something may have changed: a display steps 1000 times a second.
TEST_F(AnswerDisplayRequest, IsAskedOnceUntilThereIsNews) {
  std::vector<std::string> asked;
  RemoteDisplayBackend remote{[&](std::string_view function, const Dict& arguments) {
    asked.emplace_back(function);
    return answer_display_request(screens, function, arguments);
  }};
  for (int i = 0; i < 3; ++i) EXPECT_EQ(remote.take().size(), i == 0 ? 1U : 0U) << "the one that is connected";
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(remote.asking());
  EXPECT_THAT(asked, ElementsAre("take", "asking"));
  ASSERT_TRUE(remote.ask("all", {0, "Go?", {"OK"}, {}}));
  EXPECT_TRUE(remote.asking());
  ASSERT_TRUE(screens.answer("main", "OK"));
  remote.invalidate();
  EXPECT_FALSE(remote.asking());
  EXPECT_THAT(remote.take(), ElementsAre(DisplayEvent{DisplayEvent::Kind::answered, "main", "OK", 2}));
}

TEST_F(AnswerDisplayRequest, WithoutAServerNothingHappens) {
  RemoteDisplayBackend remote{
      [](std::string_view, const Dict&) -> Expected<Value> { return unexpected(ErrorCode::unavailable, "gone"); }};
  EXPECT_THAT(remote.take(), IsEmpty());
  EXPECT_FALSE(remote.asking());
  EXPECT_EQ(remote.ask("all", {0, "Go?", {"OK"}, {}}).error().code, ErrorCode::unavailable);
  remote.withdraw();
}

}  // namespace
}  // namespace race::display
