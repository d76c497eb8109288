// race_conversations: holds a conversation of api/conversations by the C++ client, or tries the examples of patterns.
//
//   race_conversations URL FILE TITLE [ACCOUNT=TOKEN...]
//   race_conversations
//
// FILE is a name in api/conversations. Prints what does not come to what a step says, or which examples do not hold,
// and ends with 1.
#include <cstdio>
#include <exception>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/value/json.h"
#include "tests/client_cpp/conversation.h"
#include "tests/client_cpp/patterns.h"
#include "tests/client_cpp/values.h"

namespace race::client {
namespace {

TestServer server_of(std::string url, std::span<char* const> tokens) {
  TestServer server{.url = std::move(url)};
  for (const std::string word : tokens) {
    const auto equals = word.find('=');
    if (equals == std::string::npos) throw std::invalid_argument(word + " is no ACCOUNT=TOKEN");
    server.tokens[word.substr(0, equals)] = word.substr(equals + 1);
  }
  return server;
}

void hold(const std::string& file, const std::string& title, TestServer server) {
  const Value all = read_file("api/conversations/" + file);
  for (const Value& each : all.find("conversations")->as_list())
    if (*each.find("title") == Value(title)) return Conversation(std::move(server)).hold(each.find("steps")->as_list());
  throw std::invalid_argument("no conversation is named " + title);
}

// How many examples do not hold.
int try_patterns() {
  const Value examples = read_file("api/conversations/format/patterns.json");
  Values saved;
  for (const auto& [name, value] : examples.find("saved")->as_dict()) saved.set(name.as_string(), value);
  int failed = 0;
  for (const Value& example : examples.find("patterns")->as_list()) {
    const List& parts = example.as_list();
    if (mismatch(parts.at(0), parts.at(1), saved).has_value() != parts.at(2).as_bool()) continue;
    std::printf("%s\n", to_json(example).c_str());
    ++failed;
  }
  return failed;
}

int run(std::span<char* const> words) {
  if (words.empty()) return try_patterns() == 0 ? 0 : 1;
  if (words.size() < 3) throw std::invalid_argument("usage: race_conversations [URL FILE TITLE [ACCOUNT=TOKEN...]]");
  hold(words[1], words[2], server_of(words[0], words.subspan(3)));
  return 0;
}

}  // namespace
}  // namespace race::client

int main(int argc, char** argv) {
  try {
    return race::client::run(std::span(argv, static_cast<std::size_t>(argc)).subspan(1));
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
    return 1;
  }
}
