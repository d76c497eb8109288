// Display: the service `display`: shows text, images and questions to people and answers what they say. Operations,
// events, limits: README.md.
//
// Threads: its group's. People act elsewhere, through Screens; step() takes what they did.
#pragma once

#include <optional>
#include <string>

#include "services/display/stage.h"
#include "services/table_component.h"

namespace race::display {

/// The RSM of every display.
const rsm::Service& model();

class Display final : public services::TableComponent {
 public:
  /// How long a question waits for its last display to come back [s]: a page that is reloaded loses nothing.
  static constexpr services::Time kPatience = 5.0;

  /// Shows on `stage`, which outlives the component. Images that are no data URLs are files of `folder`.
  Display(Stage& stage, std::string folder, services::ServiceHost& host);

  static const services::OperationTable& operations();
  void call(const services::Call& call) override;
  void step() override;

 private:
  /// The question that waits.
  struct Waiting {
    services::CallId call = 0;
    std::uint64_t question = 0;
    bool answer_alone = false;  // of `choose`
    std::optional<services::Time> alone_since;
  };

  void show(const services::Call& call, const Dict& arguments);
  void ask(const services::Call& call, const Dict& arguments);
  void clear(const services::Call& call, const Dict& arguments);
  void refuse_arguments(const services::Call& call, const Error& error) override;
  void take_happenings();
  void answered(const Happening& happening);
  void drop(std::string_view transition, std::string_view code, std::string_view message);

  Stage& stage_;
  std::string folder_;
  std::optional<Waiting> waiting_;
};

}  // namespace race::display
