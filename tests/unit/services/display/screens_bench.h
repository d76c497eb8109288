// A service whose Screens are in the same process, or behind a remote backend: then requests and answers pass as JSON,
// and the backend is invalidated when the Screens change.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>

#include "core/value/json.h"
#include "services/display/screens.h"
#include "tests/unit/services/host/bench.h"

namespace race::display {

/// `Remote`: RemoteDisplayBackend or audio's RemoteSpeakers.
template <typename Remote>
struct ScreensBench : testing::Test {
  using Answer = std::function<Expected<Value>(Screens&, std::string_view function, const Dict& arguments)>;

  /// `key`: the service's; `its_answer`: how the server answers its requests.
  ScreensBench(std::string key, Answer its_answer)
      : service(std::move(key)), call_host_function(std::move(its_answer)) {}

  void call(const std::string& operation, List args = {}, Dict kwargs = {}) {
    refresh();
    bench.call(service, operation, std::move(args), std::move(kwargs));
  }
  void pass(double seconds) {
    refresh();
    bench.pass(seconds);
  }
  void refresh() {
    const auto revision = screens.revision();
    if (std::exchange(seen, revision) != revision) remote.invalidate();
  }

  std::string service;
  Answer call_host_function;
  Screens screens;
  Remote remote{[this](std::string_view function, const Dict& arguments) -> Expected<Value> {
    ASSIGN_OR_RETURN(const Value asked, parse_json(to_json(arguments)));
    ASSIGN_OR_RETURN(const Value answer, call_host_function(screens, function, asked.as_dict()));
    return parse_json(to_json(answer));
  }};
  std::uint64_t seen = 0;
  services::Bench bench;
};

}  // namespace race::display
