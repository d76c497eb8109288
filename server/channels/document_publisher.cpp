#include "server/channels/document_publisher.h"

#include <utility>

#include "server/wire/channel_names.h"
#include "server/wire/path_pattern.h"

namespace race::server {

void DocumentPublisher::edited(const std::string& document, Value accepted) {
  hub_.publish_delta(fill(kDocumentChannel, {document}), std::move(accepted));
}

void DocumentPublisher::replaced(const std::string& document, Value snapshot) {
  hub_.publish_replacement(fill(kDocumentChannel, {document}), std::move(snapshot));
}

void DocumentPublisher::shown(const std::string& document, Value snapshot) {
  hub_.publish_snapshot(fill(kDocumentChannel, {document}), std::move(snapshot));
}

void DocumentPublisher::ended(const std::string& document, std::vector<Error> errors) {
  hub_.close(fill(kDocumentChannel, {document}), std::move(errors));
}

void DocumentPublisher::all_replaced() { hub_.restart(fill(kDocumentChannel, {""})); }

}  // namespace race::server
