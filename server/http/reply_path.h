// ReplyPath: brings replies from any thread to that of the sockets, while there are sockets.
//
// Threads: any.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <functional>
#include <utility>

#include "services/mutex.h"

namespace race::server {

class ReplyPath {
 public:
  explicit ReplyPath(boost::asio::io_context& io) : io_(&io) {}
  /// `work` is done on the thread of the sockets; never, if there are none any more.
  void post(std::function<void()> work) EXCLUDES(mutex_) {
    const services::MutexLock lock(mutex_);
    if (io_) boost::asio::post(*io_, std::move(work));
  }
  /// The sockets end.
  void close() EXCLUDES(mutex_) {
    const services::MutexLock lock(mutex_);
    io_ = nullptr;
  }

 private:
  services::Mutex mutex_;
  boost::asio::io_context* io_ GUARDED_BY(mutex_);
};

}  // namespace race::server
