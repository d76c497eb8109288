#include "services/display/arguments.h"

#include <algorithm>
#include <set>

#include "services/display/image.h"
#include "services/display/screens.h"

namespace race::display {
namespace {

Expected<std::string> read_text(const Dict& arguments, const char* name, std::size_t limit) {
  const std::string& text = arguments.find(name)->as_string();
  if (text.size() > limit)
    return unexpected(ErrorCode::too_large,
                      "argument `" + std::string(name) + "` has at most " + std::to_string(limit) + " bytes", name);
  return text;
}

Expected<std::vector<std::string>> read_buttons(const Value& list, const char* name, std::size_t least) {
  std::vector<std::string> buttons;
  for (const Value& item : list.as_list()) buttons.push_back(item.as_string());
  if (buttons.size() < least || buttons.size() > kButtons)
    return unexpected(ErrorCode::out_of_range,
                      "argument `" + std::string(name) + "` has " + std::to_string(least) + " to " +
                          std::to_string(kButtons) + " buttons",
                      name);
  for (const std::string& text : buttons)
    if (text.empty() || text.size() > kButtonBytes)
      return unexpected(
          ErrorCode::out_of_range,
          "argument `" + std::string(name) + "`: a button has 1 to " + std::to_string(kButtonBytes) + " bytes", name);
  if (std::set(buttons.begin(), buttons.end()).size() != buttons.size())
    return unexpected(ErrorCode::duplicate, "argument `" + std::string(name) + "`: two buttons are the same", name);
  return buttons;
}

Expected<NumberEntry> read_number(const Dict& arguments) {
  NumberEntry entry;
  ASSIGN_OR_RETURN(entry.unit, read_text(arguments, "unit", kUnitBytes));
  entry.min = arguments.find("min")->to_double();
  entry.max = arguments.find("max")->to_double();
  if (entry.min > entry.max) return unexpected(ErrorCode::out_of_range, "argument `max` must be at least `min`", "max");
  const Value* initial = arguments.find("initial");
  if (!initial || !initial->is_numeric()) return entry;
  entry.value = initial->to_double();
  if (!(*entry.value >= entry.min && *entry.value <= entry.max))
    return unexpected(ErrorCode::out_of_range, "argument `initial` must be within `min` and `max`", "initial");
  return entry;
}

}  // namespace

Expected<Message> read_message(const Dict& arguments, const std::string& folder) {
  Message message;
  ASSIGN_OR_RETURN(message.text, read_text(arguments, "text", kTextBytes));
  if (const Value* buttons = arguments.find("buttons")) {
    ASSIGN_OR_RETURN(message.buttons, read_buttons(*buttons, "buttons", 0));
  }
  if (const Value* progress = arguments.find("progress")) message.progress = progress->to_double();
  if (const Value* image = arguments.find("image")) {
    ASSIGN_OR_RETURN(message.image, image_url(image->as_string(), folder));
  }
  return message;
}

Expected<Question> read_question(const Dict& arguments) {
  Question question;
  ASSIGN_OR_RETURN(question.text, read_text(arguments, "question", kTextBytes));
  for (const char* name : {"buttons", "choices"}) {
    if (const Value* list = arguments.find(name)) {
      ASSIGN_OR_RETURN(question.buttons, read_buttons(*list, name, 1));
    }
  }
  if (arguments.find("min")) {
    ASSIGN_OR_RETURN(question.number, read_number(arguments));
  }
  return question;
}

Expected<std::string> read_target(const Dict& arguments) {
  const std::string& target = arguments.find("display")->as_string();
  if (is_display_target(target)) return target;
  return unexpected(ErrorCode::name,
                    "argument `display` is `all`, or 1 to 32 letters, digits, `_` or `-`, with an `@` before a place",
                    "display");
}

}  // namespace race::display
