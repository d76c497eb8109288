// RemoteStage: the Stage of a `display` in a process of its own; answer_stage(): what the server does with its
// questions. The Screens stay in the server: what is shown and who answered first is decided there alone.
//
// A question is a function of Stage with arguments: show_text, show_image, ask, ask_number and clear as the operations
// of the RSM (images are data URLs by then), withdraw, asking and take without any
// (api/schemas/component_request.json). Audio's speakers go the same way.
//
// Threads: the component's; answer_stage() any.
#pragma once

#include <optional>
#include <string_view>

#include "services/display/stage.h"

namespace race::display {

class RemoteStage final : public Stage {
 public:
  explicit RemoteStage(AskServer server) : server_(std::move(server)) {}

  /// People have done something: what was known of it is so no more.
  void news();

  Expected<void> show(const std::string& target, Message message) override;
  Expected<std::uint64_t> ask(const std::string& target, Question question) override;
  Expected<bool> clear(const std::string& target) override;
  void withdraw() override;
  bool asking() override;
  std::vector<Happening> take() override;

 private:
  Expected<Value> command(std::string_view function, Dict arguments);

  AskServer server_;
  bool taken_ = false;          // nothing has happened since
  std::optional<bool> asking_;  // as far as it is known
};

/// Asks `stage`. What it refuses (`not_found`) is a good answer; errors: those of a question that no component asks.
Expected<Value> answer_stage(Stage& stage, std::string_view function, const Dict& arguments);

}  // namespace race::display
