// What a client says on the stream, a message a line: each is done or refused, in text that can be read again, and what
// waits for the client stays bounded. Edits are read, and made of a document, where their inverse takes them back.
#include <fstream>
#include <iterator>

#include "core/edit/apply.h"
#include "core/rcm/constraints.h"
#include "core/rcm/document.h"
#include "core/value/fields.h"
#include "core/value/json.h"
#include "server/editing/edit_request.h"
#include "server/editing/presence_channels.h"
#include "server/stream/requests.h"
#include "server/wire/channel_names.h"
#include "server/wire/path_pattern.h"
#include "tests/fuzz/support/expect.h"
#include "tests/fuzz/support/failures.h"
#include "tests/fuzz/support/input.h"
#include "tests/fuzz/support/json_mutator.h"

namespace race::server {
namespace {

// The document that the examples of edits are about.
edit::Tree read_example() {
  std::ifstream file(RACE_SOURCE_DIR "/api/examples/edits/apply.remove.json");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return edit::Tree::read(rcm::read_draft(*parse_json(text).value().find("document")).document).value();
}

// Reads an edit as EditQueue does, and makes it.
class Edits final : public EditRequests {
 public:
  void request_edit(const std::shared_ptr<Subscriber>&, const Value& message) override {
    std::vector<Error> errors;
    Fields fields(message, "", "the message", errors, Fields::Paths::field);
    fields.find("type");
    fields.text("document", Fields::Need::required);
    const EditRequest request = read_edit_request(fields, errors);
    fields.close();
    if (!errors.empty()) return;
    static const edit::Tree example = read_example();
    if (const auto* edit = std::get_if<edit::Edit>(&request.what)) return make(example, *edit);
    if (const auto* compound = std::get_if<CompoundRequest>(&request.what))
      if (const auto edit = make_edit(*compound, example, "seed")) make(example, *edit);
  }

 private:
  static void make(const edit::Tree& before, const edit::Edit& edit) {
    edit::Tree tree = before;
    const auto inverse = edit::apply(tree, edit);
    if (!inverse) return FUZZ_EXPECT(tree.document() == before.document());
    (void)rcm::violations(tree.document());
    FUZZ_EXPECT(edit::apply(tree, *inverse));
    FUZZ_EXPECT(tree.document() == before.document());
  }
};

class Records final : public ClientRecords {
 public:
  bool is_current(const Identity&) const override { return true; }
  void record(const Identity&, std::string, std::string) override {}
  void refused(const Identity&, const Error&) override {}
};

class Client final : public Subscriber {
 public:
  Outbox& outbox() override { return outbox_; }
  const Identity& identity() const override { return identity_; }
  void wake() override {}
  void gather() override {}

 private:
  Outbox outbox_;
  const Identity identity_;
};

// A server with a display, a channel of each kind, and one client.
class Stream {
 public:
  Stream() {
    (void)screens_.connect("main", true);
    (void)screens_.show("all", {.text = "Stand back", .buttons = {"Stop"}});
    (void)screens_.ask("all", {.text = "How wide?", .number = display::NumberEntry{.unit = "m", .min = 0, .max = 1}});
    (void)screens_.play("all", {.name = "done"});
  }

  void say(std::string_view message) {
    handle_stream_request(message, client_, {hub_, displays_, edits_, presence_, records_});
    hub_.after([this] { read(); });
  }
  // The client leaves; what was asked for is done.
  ~Stream() {
    displays_.disconnect(*client_);
    presence_.disconnected(*client_);
    hub_.disconnect(client_);
    hub_.shut_down();
    read();
    deadlines_.close();
  }

 private:
  void read() {
    FUZZ_EXPECT(client_->outbox().size() <= Outbox::kMessages);
    while (const auto text = client_->outbox().pop()) FUZZ_EXPECT(parse_json((*text)->json).has_value());
  }
  std::optional<Source> find(const std::string& name) {
    if (const auto display = match(kDisplayChannel, name)) return displays_.source(display->at("name"));
    if (const auto document = match(kPresenceChannel, name))
      return Source{false, [this, to = document->at("name")] { presence_.publish_snapshot(to); }, {}};
    if (match(kCoreStateChannel, name))
      return Source{false, [this, name] { hub_.publish_snapshot(name, Dict{{"steps", 0}}); }, {}};
    if (name != kCellPoseChannel) return std::nullopt;
    return Source{true, {}, [this](bool on) {
                    if (on) hub_.publish_delta(std::string(kCellPoseChannel), Dict{{"time", 0.5}});
                  }};
  }

  Pool pool_{1};
  Hub hub_{pool_, 1, [this](const std::string& name) { return find(name); }};
  display::Screens screens_;
  Displays displays_{screens_, hub_};
  Edits edits_;
  Records records_;
  Deadlines deadlines_;
  PresenceChannels presence_{hub_, deadlines_, 1};
  std::shared_ptr<Client> client_ = std::make_shared<Client>();
};

}  // namespace
}  // namespace race::server

FUZZ_MUTATE_WITH(race::fuzz::mutate_json_lines)

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  race::fuzz::end_at_failures();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  race::server::Stream stream;
  for (const std::string_view line : race::fuzz::lines_of(data, size)) stream.say(line);
  return 0;
}
