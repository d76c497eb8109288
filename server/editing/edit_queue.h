// EditQueue: the edits that clients send on the stream, and the documents that they want to see, done one after the
// other on a thread of its own: the sockets and the hub do not wait for the disk. The edits of one sender keep their
// order. It is bounded.
//
// Threads: any.
#pragma once

#include <cstddef>
#include <memory>
#include <set>
#include <string>

#include "server/editing/editing.h"
#include "server/stream/hub.h"
#include "server/stream/requests.h"
#include "server/threads/strand.h"
#include "services/mutex.h"

namespace race::server {

class EditQueue final : public EditRequests {
 public:
  static constexpr std::size_t kMost = 256;  // edits that wait; and as many documents

  /// All outlive this.
  EditQueue(Editing& editing, Hub& hub, ClientRecords& records, std::size_t most = kMost)
      : editing_(editing), hub_(hub), records_(records), most_(most) {}
  ~EditQueue() override { stop(); }

  /// Does what a message `edit` asks for, and tells its sender. Beyond the bound: `unavailable`.
  void request_edit(const std::shared_ptr<Subscriber>& sender, const Value& message) override EXCLUDES(mutex_);

  /// Publishes the document soon. If too many wait, its channel ends with `unavailable`: who wants it subscribes again.
  void request_snapshot(const std::string& document) EXCLUDES(mutex_);

  /// What waits is dropped, and nothing is accepted any more.
  void stop() EXCLUDES(mutex_);

 private:
  using Sender = std::weak_ptr<Subscriber>;
  struct Message;
  /// False: there is no room for it.
  bool post(const Sender& sender, std::shared_ptr<const Message> message) EXCLUDES(mutex_);
  bool post_snapshot(const std::string& document) EXCLUDES(mutex_);
  void execute(const Sender& sender, const Message& message);
  void show(const std::string& document) EXCLUDES(mutex_);
  bool begin_edit() EXCLUDES(mutex_);

  Editing& editing_;
  Hub& hub_;
  ClientRecords& records_;
  const std::size_t most_;
  services::Mutex mutex_;
  std::size_t edits_ GUARDED_BY(mutex_) = 0;                      // that wait
  std::set<std::string, std::less<>> wanted_ GUARDED_BY(mutex_);  // documents
  bool stopped_ GUARDED_BY(mutex_) = false;
  Pool pool_{1, 0, "edits"};
};

}  // namespace race::server
