// What tests of the server share: a Host whose news nobody wants, a store.
#pragma once

#include <memory>

#include "server/http/message.h"
#include "server/store/data_folder.h"
#include "server/store/journal_writer.h"
#include "server/store/runs.h"
#include "server/stream/control_requests.h"
#include "server/stream/requests.h"
#include "services/host/host.h"
#include "tests/unit/temporary_folder.h"

namespace race::server {

// No document is edited here.
struct NoEdits final : EditRequests {
  void request_edit(const std::shared_ptr<Subscriber>&, const Value&) override {}
};

// Nobody is at a document here.
struct NoPresence final : PresenceRequests {
  void request_presence(const std::shared_ptr<Subscriber>&, const Value&) override {}
  void unsubscribed(const Subscriber&, const std::string&) override {}
  void disconnected(const Subscriber&) override {}
};

// Everybody stays who they are, and nothing is recorded.
struct NoControls final : ControlRequests {
  void request(const std::shared_ptr<ControlClient>&, std::string_view) override {}
  void disconnected(const ControlClient&) override {}
};

struct NoRecords final : ClientRecords {
  bool is_current(const Identity&) const override { return true; }
  void record(const Identity&, std::string, std::string) override {}
  void refused(const Identity&, const Error&) override {}
};

// Lets everybody in, as an admin.
inline tl::expected<Identity, Reply> admit_all(const Request&) { return Identity(); }

struct NoObserver final : services::HostObserver {
  void delivered(const services::Delivery&) override {}
  void changed(const services::ServiceStatus&) override {}
  void logged(services::Time, const std::string&, const std::string&) override {}
};

/// The store of runs in a folder of its own.
struct TemporaryStore {
  TemporaryFolder place;
  DataFolder folder = DataFolder::open(place.path).value();
  std::unique_ptr<Runs> runs = Runs::open(folder.store()).value();
  std::unique_ptr<JournalWriter> writer = JournalWriter::open(folder.store()).value();
};

}  // namespace race::server
