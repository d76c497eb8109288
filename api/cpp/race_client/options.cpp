#include "api/cpp/race_client/options.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace race::client {
namespace {

// What goes into a header holds no end of a line.
Expected<std::string> checked_token(std::string_view text, const std::string& path) {
  constexpr std::string_view kSpace = " \t\r\n";
  const auto begin = text.find_first_not_of(kSpace);
  if (begin != std::string_view::npos) text = text.substr(begin, text.find_last_not_of(kSpace) + 1 - begin);
  const bool is_token = std::ranges::all_of(text, [](char c) { return c > ' ' && c < '\x7F'; });
  if (begin == std::string_view::npos || !is_token)
    return unexpected(ErrorCode::not_accepted, "it holds no token", path);
  return std::string(text);
}

}  // namespace

Expected<Options> read_options(const std::vector<std::string>& arguments) {
  Options options;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const auto equals = arguments[i].find('=');
    const std::string option = arguments[i].substr(0, equals);
    if (option == "--help") {
      options.help = true;
      continue;
    }
    if (option != "--server" && option != "--token-file")
      return unexpected(ErrorCode::syntax, "there is no such option", option);
    const bool is_next = equals == std::string::npos;
    if (is_next && i + 1 == arguments.size()) return unexpected(ErrorCode::missing, "it needs a value", option);
    const std::string value = is_next ? arguments[++i] : arguments[i].substr(equals + 1);
    if (option == "--server")
      options.server = value;
    else
      options.token_file = value;
  }
  ASSIGN_OR_RETURN(options.address, remote::read_address(options.server));
  if (options.address.tls)
    return unexpected(ErrorCode::not_accepted,
                      "a service connects without TLS: to a server of its own machine, or by a tunnel", options.server);
  return options;
}

Expected<std::string> find_token(const std::optional<std::string>& file) {
  constexpr const char* kUsual = "data/processes.token";
  constexpr std::size_t kMostBytes = 1000;
  if (!file) {
    const char* given = std::getenv("RACE_TOKEN");
    if (given && *given) return checked_token(given, "RACE_TOKEN");
    std::error_code ignored;
    if (!std::filesystem::exists(kUsual, ignored)) return std::string();
  }
  const std::string path = file.value_or(kUsual);
  std::ifstream stream(path, std::ios::binary);
  std::array<char, kMostBytes> text{};
  stream.read(text.data(), text.size());
  if (stream.bad() || !stream.is_open()) return unexpected(ErrorCode::io, "it cannot be read", path);
  return checked_token({text.data(), static_cast<std::size_t>(stream.gcount())}, path);
}

}  // namespace race::client
