// What a process of components says, and what it is told, a message a line (`#`: binary). Each is refused or read; what
// is read can be written and read again. Then both ends of a connection handle them all: the server's, with a lamp, a
// world and screens behind it, and a process'. The first message of a connection is its hello; the lines `!lamp` and
// `!screens` stand for good ones.
#include <chrono>
#include <string>
#include <thread>

#include "core/language/primitives/utf8.h"
#include "core/value/json.h"
#include "server/cell/remote_world_proxy.h"
#include "services/audio/audio.h"
#include "services/audio/remote_speakers.h"
#include "services/display/display.h"
#include "services/display/remote_display_backend.h"
#include "services/display/screens.h"
#include "services/remote/process_host.h"
#include "services/remote/process_link.h"
#include "services/remote/remotes.h"
#include "tests/fuzz/support/expect.h"
#include "tests/fuzz/support/failures.h"
#include "tests/fuzz/support/input.h"
#include "tests/fuzz/support/json_mutator.h"
#include "tests/unit/services/remote/lamp.h"

namespace race::remote {
namespace {

constexpr std::string_view kWorld = R"json({
  "scene": {"robots": [{"name": "r", "urdf": "r.urdf", "pose": {"position": [0, 0, 0], "orientation": [0, 0, 0, 1]}}],
            "bodies": [{"name": "part", "shape": {"box": [1, 1, 1]}, "fixed": false,
                        "pose": {"position": [0, 0, 0], "orientation": [0, 0, 0, 1]}}]},
  "files": {"r.urdf": "<robot name='r'><link name='a'/><link name='b'><inertial><mass value='1'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial></link><joint name='j' type='revolute'><parent link='a'/><child link='b'/><axis xyz='0 0 1'/><limit lower='-1' upper='1' effort='1' velocity='1'/></joint></robot>"}
})json";

Value component(const char* key, const rsm::Service& model) {
  return Dict{{"key", key}, {"type", key}, {"rsm", rsm::write_service(model)}};
}

EncodedMessage make_hello(List components, Value world) {
  Message hello;
  hello.kind = Kind::hello;
  hello.number = kProtocol;
  hello.value = std::move(components);
  hello.world = std::move(world);
  return encode(hello).value();
}

const EncodedMessage& good_hello(bool of_lamp) {
  static const EncodedMessage lamp = make_hello({component("lamp", lamp_model())}, parse_json(kWorld).value());
  static const EncodedMessage screens =
      make_hello({component("display", display::model()), component("audio", audio::model())}, {});
  return of_lamp ? lamp : screens;
}

// `#` begins the JSON of a binary message, a tab its bytes; `%` a binary message as it stands.
EncodedMessage message_of(std::string_view line) {
  if (line.starts_with('%')) return {std::string(line.substr(1)), true};
  if (!line.starts_with('#')) return {std::string(line), false};
  const std::size_t tab = std::min(line.find('\t'), line.size()), length = tab - 1;
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(length >> shift & 0xFFU);
  bytes += line.substr(1, length);
  if (tab < line.size()) bytes += line.substr(tab + 1);
  return {std::move(bytes), true};
}

void hold_codec(const EncodedMessage& encoded) {
  for (const Reader reader : {Reader::server, Reader::process}) {
    const auto message = decode(encoded, reader);
    if (!message) continue;
    FUZZ_EXPECT(reader_of(message->kind) == reader);
    const auto written = encode(*message);
    FUZZ_EXPECT(written && written->binary == encoded.binary);
    const auto again = decode(*written, reader);
    FUZZ_EXPECT(again && encode(*again)->bytes == written->bytes);
  }
}

class Observer final : public services::HostObserver {
 public:
  void delivered(const services::Delivery& delivery) override { (void)to_json(delivery.data); }
  void changed(const services::ServiceStatus&) override {}
  void logged(services::Time, const std::string&, const std::string& text) override {
    FUZZ_EXPECT(language::utf8::valid(text));
  }
};

// A server that waits for two processes, and the connection of one.
class Server {
 public:
  Server() {
    const auto revision = [this] { return screens_.revision(); };
    remotes_.add("cell", {{"lamp", "lamp", &lamp_model()}}, &world_.end());
    remotes_.add("display", {{"display",
                              "display",
                              &display::model(),
                              {[this](const std::string& function, const Dict& arguments) {
                                 return display::answer_display_request(screens_, function, arguments);
                               },
                               revision, [this] { screens_.withdraw(); }}},
                             {"audio",
                              "audio",
                              &audio::model(),
                              {[this](const std::string& function, const Dict& arguments) {
                                 return audio::answer_audio_request(screens_, function, arguments);
                               },
                               revision, [this] { screens_.silence(); }}}});
    screens_.connect("main", true);
    world_.watch_pose(true);
  }
  // What was said is handled; then nobody waits any more.
  ~Server() {
    link_.disconnect("the input is over");
    remotes_.stop();
    host_.stop();
    while (const auto encoded = link_.out().pop()) FUZZ_EXPECT(decode(*encoded, Reader::process));
  }

  void hear(EncodedMessage message) {
    const bool is_hello = !std::exchange(greeted_, true);
    link_.received(std::move(message));
    if (is_hello) make_calls();
  }

 private:
  bool is_connected() const { return host_.service("lamp")->available || host_.service("display")->available; }

  // So that there is something to answer.
  void make_calls() {
    while (!link_.disconnected() && !is_connected()) std::this_thread::yield();
    if (link_.disconnected()) return;
    for (const char* operation : {"blink", "burn", "on"}) host_.call({"1", ++calls_}, "lamp", operation, {}, {});
    host_.call({"1", ++calls_}, "display", "ask", {}, {{"text", "Continue?"}});
    world_.execute(
        std::nullopt, [] { return true; }, [](const Expected<Value>&) {});
    world_.execute(
        std::nullopt, [] { return true; }, [](const Expected<Value>&) {});
  }

  Observer observer_;
  services::WorldClock clock_;
  display::Screens screens_;
  server::RemoteWorldProxy world_{clock_};
  services::Host host_{clock_, observer_};
  Remotes remotes_{host_, clock_, std::chrono::hours(1)};
  ProcessLink link_{remotes_, {"cell", "display"}};
  bool greeted_ = false;
  std::uint64_t calls_ = 0;
};

// A process with a lamp, and a world that does what it is told.
class Process {
 public:
  Process() {
    host_.attach("lamp", std::make_unique<Lamp>(host_.declare("lamp", "lamp")));
    host_.set_world({{}, [](const Value& command) { return Expected<Value>(command); }, [](bool) {}});
    host_.connect(server_);
  }
  void hear(const EncodedMessage& encoded) {
    auto message = decode(encoded, Reader::process);
    if (ended_ || !message) return;
    ended_ = !host_.receive(std::move(*message), encoded.bytes.size()) || !host_.step();
    while (const auto said = server_.pop()) FUZZ_EXPECT(decode(*said, Reader::server));
  }

 private:
  SendQueue server_;
  ProcessHost host_;
  bool ended_ = false;
};

}  // namespace
}  // namespace race::remote

FUZZ_MUTATE_WITH(race::fuzz::mutate_json_lines)

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  race::fuzz::end_at_failures();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  race::remote::Server server;
  race::remote::Process process;
  for (const std::string_view line : race::fuzz::lines_of(data, size)) {
    if (line == "!lamp" || line == "!screens") {
      server.hear(race::remote::good_hello(line == "!lamp"));
      continue;
    }
    const race::remote::EncodedMessage message = race::remote::message_of(line);
    race::remote::hold_codec(message);
    process.hear(message);
    server.hear(message);
  }
  return 0;
}
