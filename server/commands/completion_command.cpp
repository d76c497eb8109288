// race completion bash: the completion of command lines for bash, which asks `race completion words -- WORD...` each
// time: so it knows what this program knows.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>

#include "core/value/fields.h"
#include "server/commands/ask_server.h"
#include "server/commands/completion.h"
#include "server/commands/core_line.h"
#include "server/commands/table.h"

namespace race::server {
namespace {

using namespace std::chrono_literals;

// A person waits: who does not answer at once is not asked for long.
constexpr HttpClient::Timeouts kSoon{300ms, 700ms};

// COMP_WORDS has URLs and --name=value in pieces, at `:` and `=`.
constexpr const char* kBash = R"(# Completion of race(1) for bash: race itself says what may stand there.
_race() {
  local word glue='' words=() reply=()
  for word in "${COMP_WORDS[@]:1:COMP_CWORD}"; do
    if [[ ${#words[@]} -gt 0 && ($glue || $word =~ ^[:=]+$) ]]; then
      words[-1]+=$word
      glue=''
      [[ $word =~ ^[:=]+$ ]] && glue=1
    else
      words+=("$word")
    fi
  done
  mapfile -t reply < <("${COMP_WORDS[0]/#\~/$HOME}" completion words -- "${words[@]}" 2>/dev/null)
  COMPREPLY=("${reply[@]:1}")
  case ${reply[0]-} in
    files) compopt -o default ;;
    folders) compopt -o dirnames ;;
  esac
}
complete -F _race race
)";

// What a shell would read otherwise is not offered.
bool is_plain(const std::string& word) {
  return !word.empty() && std::ranges::all_of(word, [](char c) {
    return is_name(std::string(1, c)) || (c >= '0' && c <= '9') || c == '-' || c == '.';
  });
}

// The value of an option among words that are not complete.
std::optional<std::string> value_of(const std::vector<std::string>& words, const std::string& option) {
  for (std::size_t at = 0; at < words.size(); ++at) {
    if (words[at].starts_with(option + '=')) return words[at].substr(option.size() + 1);
    if (words[at] == option && at + 2 < words.size()) return words[at + 1];
  }
  return std::nullopt;
}

// What is no answer to this is nothing.
std::vector<std::string> texts(const Value& answer, const char* list, const char* key) {
  std::vector<Error> ignored;
  std::vector<std::string> found;
  Fields fields(answer, "", "the answer", ignored);
  for (const Value& each : fields.list(list))
    if (const auto text = Fields(each, "", "one", ignored).text(key)) found.push_back(*text);
  return found;
}

std::vector<std::string> operations(const Value& answer) {
  std::vector<Error> ignored;
  std::vector<std::string> found;
  Fields fields(answer, "", "the answer", ignored);
  for (const Value& service : fields.list("services")) {
    const Value* rsm = service.find("rsm");
    const auto key = Fields(service, "", "the service", ignored).text("key");
    if (!rsm || !key) continue;
    for (const std::string& operation : texts(*rsm, "operations", "name")) found.push_back(*key + '.' + operation);
  }
  return found;
}

// Asks the server of the command line, without a word of what is wrong there.
std::vector<std::string> names_at_server(const std::vector<std::string>& words, std::string_view placeholder) {
  ServerOptions server;
  server.url = value_of(words, "--server").value_or(kDefaultServer);
  server.authority = value_of(words, "--ca");
  server.token_file = value_of(words, "--token-file");
  const auto client = client_of(server, kSoon);
  if (!client) return {};
  const bool documents = placeholder == "DOCUMENT", cores = placeholder == "ID";
  const auto answer = client->request("GET", documents ? "/api/v1/documents" : cores ? kCores : "/api/v1/services");
  if (!answer || !is_fine(*answer)) return {};
  std::vector<std::string> names = documents ? texts(answer->body, "documents", "name")
                                   : cores   ? texts(answer->body, "cores", "id")
                                             : operations(answer->body);
  std::erase_if(names, [](const std::string& name) { return !is_plain(name); });
  return names;
}

int print(const Completion& completion) {
  constexpr std::array kKinds = {"words", "files", "folders"};
  std::printf("%s\n", kKinds.at(static_cast<std::size_t>(completion.kind)));
  for (const std::string& word : completion.words) std::printf("%s\n", word.c_str());
  return kExitOk;
}

struct Options {
  std::string shell;
  std::vector<std::string> words;
};

int run(const Options& options) {
  if (options.shell == "bash" && options.words.empty()) {
    std::fputs(kBash, stdout);
    return kExitOk;
  }
  if (options.shell != "words" || options.words.empty())
    return refuse(
        Error{ErrorCode::syntax, "the form is `race completion bash`, or `race completion words -- WORD...`", "SHELL"});
  return print(complete(all_commands(), options.words, [&options](std::string_view placeholder) {
    return names_at_server(options.words, placeholder);
  }));
}

std::function<int()> declare(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  arguments.positional("SHELL", options->shell,
                       "bash: its completion; words: what may stand for the last WORD, for it");
  arguments.suggest("SHELL", {"bash"});
  arguments.positionals("WORD", options->words, false);
  return [options] { return run(*options); };
}

}  // namespace

const Command kCompletion = {
    "completion", "prints the completion of `race` for a shell: `eval \"$(race completion bash)\"`", declare};

}  // namespace race::server
