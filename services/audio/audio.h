// Audio: the service `audio`: plays named sounds on the displays that may make sounds and answers when they are over.
// Operations, events, limits: README.md.
//
// Threads: its group's. Displays report on other threads, through Screens; step() polls their progress.
#pragma once

#include <optional>
#include <string>

#include "services/display/display_backend.h"
#include "services/table_component.h"

namespace race::audio {

/// The RSM of every audio.
const rsm::Service& model();

class Audio final : public services::TableComponent {
 public:
  /// How long after the end of a sound a report may still arrive [s]: the round trip to the browser.
  static constexpr services::Time kMargin = 2.0;

  /// Plays on `speakers`, which outlive the component.
  Audio(display::Speakers& speakers, services::ServiceHost& host);

  static const services::OperationTable& operations();
  void step() override;

 private:
  struct Playing {
    services::CallId call = 0;
    std::string sound;
    services::Time started = 0;
    double length = 0;  // [s] with all repetitions
  };

  void play(const services::Call& call, const Dict& arguments);
  void stop(const services::Call& call);
  void finish(const display::Playback& playback);
  void drop(std::string_view transition, std::string_view code, std::string_view message);

  display::Speakers& speakers_;
  std::optional<Playing> playing_;
};

}  // namespace race::audio
