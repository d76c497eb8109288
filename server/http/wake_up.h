// WakeUp: what other threads want of a session.
//
// Threads: any.
#pragma once

#include <atomic>
#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/post.hpp>
#include <memory>
#include <utility>

namespace race::server {

/// Work on the executor of a session for those on other threads; copies are one. However often it is asked for, one
/// piece at most is on its way.
class WakeUp {
 public:
  explicit WakeUp(boost::asio::any_io_executor executor) : executor_(std::move(executor)) {}

  /// `work` is done soon, unless some is on its way.
  template <typename Work>
  void post(Work work) const {
    if (on_its_way_->exchange(true)) return;
    try {
      boost::asio::post(executor_, [on_its_way = on_its_way_, work = std::move(work)]() mutable {
        *on_its_way = false;
        work();
      });
    } catch (...) {
      *on_its_way_ = false;
      throw;
    }
  }

 private:
  boost::asio::any_io_executor executor_;
  std::shared_ptr<std::atomic<bool>> on_its_way_ = std::make_shared<std::atomic<bool>>(false);
};

}  // namespace race::server
