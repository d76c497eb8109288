// What a display shows: a message, a question on top of it, a sound. Values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace race::display {

/// Stays until another message or `clear` takes its place. Each press of a button is an event.
struct Message {
  std::string text;
  std::string image;  // a data URL; empty: none
  std::vector<std::string> buttons;
  std::optional<double> progress = {};  // 0..1, a bar below the text
  bool operator==(const Message&) const = default;
};

/// What a number must be, ends included; `value` is proposed.
struct NumberEntry {
  std::string unit;
  double min = 0, max = 0;
  std::optional<double> value;
  bool operator==(const NumberEntry&) const = default;
};

/// Waits for one answer, of whichever display that shows it is first.
struct Question {
  std::uint64_t id = 0;  // given by Screens
  std::string text;
  std::vector<std::string> buttons;   // one of them is the answer
  std::optional<NumberEntry> number;  // else a number is
  bool operator==(const Question&) const = default;
};

/// To be played once by each display that may make sounds.
struct Sound {
  std::uint64_t id = 0;  // given by Screens
  std::string name;      // of api/sounds.json
  double volume = 1;     // 0..1
  int repeat = 1;        // times
  bool operator==(const Sound&) const = default;
};

/// All that one display shows.
struct Content {
  std::string display;
  std::optional<Message> message;
  std::optional<Question> question;
  std::optional<Sound> sound;
  bool operator==(const Content&) const = default;
};

}  // namespace race::display
