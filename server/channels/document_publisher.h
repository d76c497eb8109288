// DocumentPublisher: the edits of documents go to their channels.
//
// Threads: any.
#pragma once

#include <string>
#include <vector>

#include "server/editing/editing.h"
#include "server/stream/hub.h"

namespace race::server {

class DocumentPublisher final : public EditPublisher {
 public:
  /// Outlives this.
  explicit DocumentPublisher(Hub& hub) : hub_(hub) {}

  void edited(const std::string& document, Value accepted) override;
  void replaced(const std::string& document, Value snapshot) override;
  void shown(const std::string& document, Value snapshot) override;
  void ended(const std::string& document, std::vector<Error> errors) override;
  void all_replaced() override;

 private:
  Hub& hub_;
};

}  // namespace race::server
