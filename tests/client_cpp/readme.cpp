#include <chrono>
#include <cstdio>
#include <string>

#include "api/cpp/client/calls.h"
#include "api/cpp/client/client.h"
#include "api/cpp/client/cores.h"
#include "api/cpp/client/documents.h"
#include "core/value/json.h"

using namespace race;
using namespace std::chrono_literals;
namespace calls = client::calls;

constexpr const char* kCounter = R"({"rcm": 1, "name": "counter", "root": {
  "state": "Root", "parameters": [{"name": "last", "value": 3}], "results": [{"name": "n", "initial": 0}],
  "actions": [{"when": "svc.timer.tick", "do": "res.n = res.n + 1"}],
  "ports": [{"name": "done", "when": "res.n >= par.last"}]}})";

int main(int argc, char** argv) {
  // {.token = "..."} of an account; {.authority = "tls/ca.pem"} for https.
  const auto server = client::Client::create(argc > 1 ? argv[1] : "http://127.0.0.1:8080").value();

  // A document is checked and stored; `tag` is for If-Match. What refuses a request is an ApiError.
  const Value counter = parse_json(kCounter).value();
  std::printf("%zu violations\n", client::check_document(server, counter).value().size());
  server.send(calls::put_document("counter", counter, {.if_none_match = "*"})).value();
  const auto late = server.send(calls::put_document("counter", counter, {.if_match = client::tag(7)}));
  std::printf("%d %s %s\n", late.error().status, late.error().code.c_str(), late.error().path.c_str());

  // It is run to its end, within 30 s.
  const Value done = client::run_document(server, "counter", Dict{{"last", 2}}, 30s).value();
  std::printf("%s %s\n", done.find("outcome")->as_string().c_str(), to_json(*done.find("results")).c_str());

  // A core is followed over the stream: a snapshot, then deltas, already folded into `state`.
  const Dict last_is_one{{"document", "counter"}, {"arguments", Dict{{"last", 1}}}};
  const std::string id = server.send(calls::create_core(last_is_one)).value().find("id")->as_string();
  client::Following updates = server.follow(id).value();
  server.send(calls::start_core(id)).value();
  while (const auto update = updates.next(30s).value())
    std::printf("%s\n", to_json(*update->state.find("state")->find("results")).c_str());
}
