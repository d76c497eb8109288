// Attempt: what a rule records before it is known whether it applies.
#pragma once

#include "core/semantics/recorder.h"

namespace race::semantics {

/// Discards what is recorded in its scope, unless the rule applies. Requires that nodes opened after it are closed
/// before it goes out of scope.
template <Recorder R>
class Attempt {
 public:
  explicit Attempt(R& recorder) : recorder_(recorder), mark_(recorder.mark()) {}
  Attempt(const Attempt&) = delete;
  Attempt& operator=(const Attempt&) = delete;
  ~Attempt() {
    if (!applies_) recorder_.discard(mark_);
  }

  void set_applies() { applies_ = true; }

 private:
  R& recorder_;
  typename R::Mark mark_;
  bool applies_ = false;
};

}  // namespace race::semantics
