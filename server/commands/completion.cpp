#include "server/commands/completion.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace race::server {
namespace {

constexpr std::array<std::string_view, 4> kFiles = {"FILE", "MODEL", "SCRIPT", "RUN"};
constexpr std::array<std::string_view, 2> kFolders = {"DIR", "FOLDER"};
constexpr std::array<std::string_view, 3> kOfServer = {"DOCUMENT", "ID", "SERVICE.OPERATION"};

template <std::size_t N>
bool has(const std::array<std::string_view, N>& words, std::string_view word) {
  return std::ranges::find(words, word) != words.end();
}

Completion begun(const std::vector<std::string>& words, const std::string& typed) {
  Completion completion;
  std::ranges::copy_if(words, std::back_inserter(completion.words),
                       [&typed](const std::string& word) { return word.starts_with(typed); });
  return completion;
}

std::vector<std::string> command_names(std::span<const Command* const> commands) {
  std::vector<std::string> names;
  for (const Command* command : commands) names.emplace_back(command->name);
  return names;
}

}  // namespace

Completion complete(std::span<const Command* const> commands, const std::vector<std::string>& words,
                    const NamesAtServer& names) {
  const std::vector<std::string> known = command_names(commands);
  const std::string& typed = words.back();
  if (words.size() == 1) {
    std::vector<std::string> first = known;
    first.insert(first.end(), {"help", "--help", "--version"});
    return begun(first, typed);
  }
  if (words.front() == "help") return words.size() == 2 ? begun(known, typed) : Completion();
  const auto named = std::ranges::find(commands, words.front(), &Command::name);
  if (named == commands.end()) return {};
  Arguments arguments{words.front()};
  (*named)->declare(arguments);
  const Arguments::Place place = arguments.place_of_last({words.begin() + 1, words.end()});
  if (has(kFiles, place.placeholder)) return {Completion::Kind::files};
  if (has(kFolders, place.placeholder)) return {Completion::Kind::folders};
  return begun(has(kOfServer, place.placeholder) ? names(place.placeholder) : place.words, place.typed);
}

}  // namespace race::server
