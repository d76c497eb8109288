// RemoteDisplayBackend: the DisplayBackend of a `display` component that runs in its own process. It sends requests to
// the server, which answers them with answer_display_request(). The Screens stay in the server: it alone decides what
// is shown and whose answer was first.
//
// A request names a function of DisplayBackend: show_text, show_image, show_progress, ask, ask_number and clear with
// the parameters of the operations (an image is a data URL by then); withdraw, asking and take without arguments
// (api/schemas/component_request.json).
//
// Threads: the component's; answer_display_request() any.
#pragma once

#include <optional>
#include <string_view>

#include "services/display/display_backend.h"

namespace race::display {

class RemoteDisplayBackend final : public DisplayBackend {
 public:
  explicit RemoteDisplayBackend(ServerRequest server) : server_(std::move(server)) {}

  /// Discards what is cached: something has happened at the displays.
  void invalidate();

  Expected<void> show(const std::string& target, Message message) override;
  Expected<std::uint64_t> ask(const std::string& target, Question question) override;
  Expected<bool> clear(const std::string& target) override;
  void withdraw() override;
  bool asking() override;
  std::vector<DisplayEvent> take() override;

 private:
  Expected<Value> command(std::string_view function, Dict arguments);

  ServerRequest server_;
  bool taken_ = false;          // no events since the last take()
  std::optional<bool> asking_;  // cached; nothing: to be requested
};

/// Answers a request by `backend`. Its refusal (`not_found`) is an answer; errors: a request that no component makes.
Expected<Value> answer_display_request(DisplayBackend& backend, std::string_view function, const Dict& arguments);

}  // namespace race::display
