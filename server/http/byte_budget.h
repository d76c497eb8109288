// ByteBudget: memory that clients may make the server hold: bodies that have not come yet, first messages of processes
// that nobody knows yet, answers that are not taken yet. Each takes its share, or is refused: bodies and first
// messages before their memory is used, answers before their text is made, and then the text.
//
// Threads: one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace race::server {

class ByteBudget {
 public:
  /// What is not larger takes no share: the number of connections bounds it.
  static constexpr std::size_t kFreeBytes = 16 * 1024;

  explicit ByteBudget(std::size_t bytes) : bytes_(bytes), left_(bytes) {}
  ByteBudget(const ByteBudget&) = delete;
  ByteBudget& operator=(const ByteBudget&) = delete;

  /// Given back when it is destroyed; the budget outlives it.
  class Share {
   public:
    Share() = default;
    Share(Share&& other) noexcept { swap(other); }
    Share& operator=(Share&& other) noexcept {
      Share(std::move(other)).swap(*this);
      return *this;
    }
    ~Share() {
      if (budget_) budget_->left_ += bytes_;
    }

   private:
    friend class ByteBudget;
    Share(ByteBudget& budget, std::size_t bytes) : budget_(&budget), bytes_(bytes) { budget.left_ -= bytes; }
    void swap(Share& other) noexcept {
      std::swap(budget_, other.budget_);
      std::swap(bytes_, other.bytes_);
    }
    ByteBudget* budget_ = nullptr;
    std::size_t bytes_ = 0;
  };

  /// Nothing: so much is not left. What is larger than the whole budget takes the whole: it may be there alone.
  std::optional<Share> take(std::size_t bytes) {
    if (bytes <= kFreeBytes) return Share();
    const std::size_t share = std::min(bytes, bytes_);
    if (share > left_) return std::nullopt;
    return Share(*this, share);
  }
  std::size_t left() const { return left_; }

 private:
  const std::size_t bytes_;
  std::size_t left_;
};

}  // namespace race::server
