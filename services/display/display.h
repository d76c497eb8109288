// Display: the service `display`: shows text, images and questions to people and returns their answers. Operations,
// events, limits: README.md.
//
// Threads: its group's. Input of people arrives on other threads, in Screens; step() takes it.
#pragma once

#include <optional>
#include <string>

#include "services/display/display_backend.h"
#include "services/table_component.h"

namespace race::display {

/// The RSM of every display.
const rsm::Service& model();

class Display final : public services::TableComponent {
 public:
  /// How long a question waits for its last display to reconnect [s]: a page may be reloaded.
  static constexpr services::Time kReconnectTimeout = 5.0;

  /// Shows on `backend`, which outlives the component. Images that are no data URLs are files of `folder`.
  Display(DisplayBackend& backend, std::string folder, services::ServiceHost& host);

  static const services::OperationTable& operations();
  void call(const services::Call& call) override;
  void step() override;

 private:
  /// The question that waits.
  struct PendingQuestion {
    services::CallId call = 0;
    std::uint64_t question = 0;
    bool answer_only = false;  // of `choose`
    std::optional<services::Time> disconnected_since;
  };

  void show(const services::Call& call, const Dict& arguments);
  void ask(const services::Call& call, const Dict& arguments);
  void clear(const services::Call& call, const Dict& arguments);
  void refuse_arguments(const services::Call& call, const Error& error) override;
  void take_events();
  void answered(const DisplayEvent& event);
  void drop(std::string_view transition, std::string_view code, std::string_view message);

  DisplayBackend& backend_;
  std::string folder_;
  std::optional<PendingQuestion> pending_;
};

}  // namespace race::display
