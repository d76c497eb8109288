#include "tests/client_cpp/asks.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "api/cpp/client/calls.h"
#include "api/cpp/client/cores.h"
#include "api/cpp/client/documents.h"
#include "api/cpp/client/runs.h"
#include "api/cpp/client/services.h"
#include "tests/client_cpp/values.h"

namespace race::client {
namespace {

using Ask = Answered<Value> (*)(Client& race, const Given& given);

Answered<Value> as_value(Answered<List> list) {
  if (!list) return tl::unexpected(std::move(list.error()));
  return Value(std::move(*list));
}

// A field of an answer.
Answered<Value> part_of(Answered<Value> answer, std::string_view pointer) {
  return answer ? Answered<Value>(part_at(*answer, pointer)) : answer;
}

std::chrono::milliseconds timeout_of(const Given& given) {
  return std::chrono::milliseconds(static_cast<std::int64_t>(1000 * given.number_if("timeout").value_or(0)));
}

Answered<Value> get_document(Client& race, const Given& given) {
  const auto revision = given.integer_if("revision");
  return race.send(revision ? calls::get_revision(given.text_at(0), *revision) : calls::get_document(given.text_at(0)));
}

std::optional<std::string> tag_of(std::optional<std::int64_t> revision) {
  return revision ? std::optional(tag(*revision)) : std::nullopt;
}

Answered<Value> put_document(Client& race, const Given& given) {
  calls::PutDocumentOptions options{.draft = given.flag_if("draft"),
                                    .author = given.text_if("author"),
                                    .message = given.text_if("message"),
                                    .if_match = tag_of(given.integer_if("if_revision"))};
  if (given.flag_if("is_new").value_or(false)) options.if_none_match = "*";
  return race.send(calls::put_document(given.text_at(0), given.at(1), options));
}

Answered<Value> edit_document(Client& race, const Given& given) {
  Dict edit{{"revision", given.integer("revision")}, {"operations", given.at(1)}};
  for (const char* const name : {"request", "author", "message"})
    if (auto text = given.text_if(name)) edit.set(name, std::move(*text));
  return race.send(calls::edit_document(given.text_at(0), std::move(edit)));
}

Answered<Value> create_core(Client& race, const Given& given) {
  const Dict core{{"document", given.at(0)}, {"arguments", given.at(1)}};
  return race.send(calls::create_core(core, {.idempotency_key = given.text_if("key")}));
}

Answered<Value> start_core(Client& race, const Given& given) {
  std::optional<Value> body;
  if (auto arguments = given.at_if(1)) body = Dict{{"arguments", std::move(*arguments)}};
  return race.send(calls::start_core(given.text_at(0), body));
}

Answered<Value> call_operation(Client& race, const Given& given) {
  const auto arguments = given.at_if(2), named = given.at_if(3);
  return call_service(race, given.text_at(0), given.text_at(1), arguments ? arguments->as_list() : List(),
                      named ? named->as_dict() : Dict());
}

// A method that is one call, of what the first argument names.
template <Call (*Make)(std::string_view name)>
Answered<Value> send_of(Client& race, const Given& given) {
  return race.send(Make(given.text_at(0)));
}

template <Call (*Make)()>
Answered<Value> send(Client& race, const Given&) {
  return race.send(Make());
}

struct NamedAsk {
  std::string_view method;
  Ask ask;
};

constexpr NamedAsk kAsks[] = {
    {"documents.all", [](Client& race, const Given&) { return as_value(all_documents(race)); }},
    {"documents.get", get_document},
    {"documents.put", put_document},
    {"documents.check",
     [](Client& race, const Given& given) {
       return as_value(check_document(race, given.at(0), given.text_if("name").value_or("check")));
     }},
    {"documents.edit", edit_document},
    {"documents.revisions",
     [](Client& race, const Given& given) { return race.send(calls::list_revisions(given.text_at(0))); }},
    {"documents.delete",
     [](Client& race, const Given& given) {
       return race.send(
           calls::delete_document(given.text_at(0), {.if_match = tag_of(given.integer_if("if_revision"))}));
     }},
    {"cores.all", [](Client& race, const Given&) { return part_of(race.send(calls::list_cores()), "/cores"); }},
    {"cores.get", send_of<calls::get_core>},
    {"cores.create", create_core},
    {"cores.start", start_core},
    {"cores.abort", send_of<calls::stop_core>},
    {"cores.delete", send_of<calls::delete_core>},
    {"cores.state", send_of<calls::get_core_state>},
    {"cores.wait",
     [](Client& race, const Given& given) { return wait_for_end(race, given.text_at(0), timeout_of(given)); }},
    {"cores.run",
     [](Client& race, const Given& given) {
       return run_document(race, given.text_at(0), given.at(1), timeout_of(given));
     }},
    {"runs.all", [](Client& race, const Given& given) { return as_value(all_runs(race, given.text_if("document"))); }},
    {"runs.get", send_of<calls::get_run>},
    {"runs.journal", send_of<calls::get_run_journal>},
    {"runs.derivations",
     [](Client& race, const Given& given) { return as_value(run_derivations(race, given.text_at(0))); }},
    {"runs.export", send_of<calls::export_run>},
    {"runs.delete", send_of<calls::delete_run>},
    {"services.all",
     [](Client& race, const Given&) { return part_of(race.send(calls::list_services()), "/services"); }},
    {"services.call", call_operation},
    {"me", send<calls::get_me>},
    {"health", send<calls::get_health>},
    {"log_in", [](Client& race, const Given& given) { return race.log_in(given.text_at(0), given.text_at(1)); }},
    {"log_out", [](Client& race, const Given&) { return race.log_out(); }},
    {"stop_cell", send<calls::stop_cell>},
    {"reset_stop", send<calls::reset_stop>},
};

}  // namespace

Answered<Value> ask(std::string_view method, Client& client, const Given& given) {
  const auto* const found = std::ranges::find(kAsks, method, &NamedAsk::method);
  if (found == std::end(kAsks)) throw std::invalid_argument("no method is named " + std::string(method));
  return found->ask(client, given);
}

}  // namespace race::client
