#include "server/editing/edit_queue.h"

#include <utility>

#include "core/rcm/ids.h"
#include "core/value/fields.h"
#include "server/accounts/gate.h"
#include "server/wire/channel_names.h"
#include "server/wire/path_pattern.h"

namespace race::server {

struct EditQueue::Message {
  std::string document;
  EditRequest request;
  Identity identity;  // whose it is
};

void EditQueue::request_edit(const std::shared_ptr<Subscriber>& sender, const Value& message) {
  std::vector<Error> errors;
  Fields fields(message, "", "the message", errors, Fields::Paths::field);
  fields.find("type");
  const std::string document = fields.text("document", Fields::Need::required).value_or("");
  if (!rcm::is_id(document))
    fields.violation(ErrorCode::name, "a document's name is 1 to 64 of A-Z a-z 0-9 _ -", "document");
  fields.find("request", Fields::Need::required);
  fields.find("revision", Fields::Need::required);
  auto read = std::make_shared<Message>(Message{document, read_edit_request(fields, errors), sender->identity()});
  fields.close();
  if (auto author = author_for(read->identity, std::move(read->request.author)))
    read->request.author = std::move(*author);
  else
    errors.push_back(std::move(author).error());
  const std::string& token = read->request.token;
  if (!rcm::is_id(document) || !rcm::is_id(token)) return hub_.refuse(sender, "", std::move(errors));
  if (errors.empty() && !post(sender, read))
    errors.push_back({ErrorCode::unavailable, "too many edits wait; send it again", "request"});
  if (errors.empty()) return;
  hub_.send(sender, fill(kDocumentChannel, {document}), "edit_refused",
            edit_refusal_json(document, token, {EditRefusal::Of::edit, std::move(errors)}));
}

bool EditQueue::post(const Sender& sender, std::shared_ptr<const Message> message) {
  const services::MutexLock lock(mutex_);
  if (stopped_ || edits_ >= most_) return false;
  pool_.post([this, sender, message = std::move(message)] {
    if (begin_edit()) execute(sender, *message);
  });
  ++edits_;  // under the lock: before it begins
  return true;
}

bool EditQueue::begin_edit() {
  const services::MutexLock lock(mutex_);
  --edits_;
  return !stopped_;
}

void EditQueue::execute(const Sender& sender, const Message& message) {
  const auto& [document, request, identity] = message;
  const std::string channel = fill(kDocumentChannel, {document});
  auto edited = editing_.edit(document, request);
  const std::string outcome = edited ? "accepted" : std::string(name(edited.error().errors.front().code));
  records_.record(identity, "edit " + document, outcome);
  if (!edited)
    hub_.send(sender, channel, "edit_refused", edit_refusal_json(document, request.token, edited.error()));
  else if (edited->was_there)
    hub_.send(sender, channel, "edit_accepted", std::move(edited->edit));
  else
    hub_.send(sender, channel, "edit_accepted", std::move(edited->edit), Hub::To::those_not_subscribed);
}

void EditQueue::request_snapshot(const std::string& document) {
  if (post_snapshot(document)) return;
  hub_.close(fill(kDocumentChannel, {document}),
             {{ErrorCode::unavailable, "too many documents are wanted; subscribe again", document}});
}

bool EditQueue::post_snapshot(const std::string& document) {
  const services::MutexLock lock(mutex_);
  if (stopped_) return true;
  if (wanted_.contains(document)) return true;
  if (wanted_.size() >= most_) return false;
  wanted_.insert(document);
  pool_.post([this, document] { show(document); });
  return true;
}

void EditQueue::show(const std::string& document) {
  {
    const services::MutexLock lock(mutex_);
    wanted_.erase(document);
    if (stopped_) return;
  }
  if (!editing_.publish_snapshot(document)) request_snapshot(document);
}

void EditQueue::stop() {
  const services::MutexLock lock(mutex_);
  stopped_ = true;
}

}  // namespace race::server
