// KeptTokens: the tokens that `race login` keeps, one for each server, each in a file that its user alone may read.
//
// Threads: any; processes: the last one to keep a token of a server wins, and no file is ever half written.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/value/expected.h"

namespace race::server {

struct KeptToken {
  std::string account, token;
  std::int64_t expires = 0;  // [ms] since 1970, UTC
};

/// Scheme, host and port of a URL, however it is written: "http://127.0.0.1:8080", "https://cell:443". Errors: those of
/// remote::read_address.
Expected<std::string> origin_of(std::string_view url);

class KeptTokens {
 public:
  /// In this folder, which need not be there yet; empty: nowhere.
  explicit KeptTokens(std::string folder) : folder_(std::move(folder)) {}
  /// $XDG_STATE_HOME/race, else ~/.local/state/race.
  static KeptTokens of_user();

  /// That of exactly this server; nothing: there is none. Errors: of origin_of; with the path of the file `io` and
  /// `not_accepted` (others may read it, or it is no token of this server).
  Expected<std::optional<KeptToken>> find(const std::string& url) const;
  /// In place of the one before. Errors: of origin_of; `io`, with the path.
  Expected<void> keep(const std::string& url, const KeptToken& token) const;
  /// Whether there was one. Errors: of origin_of; `io`, with the path.
  Expected<bool> remove(const std::string& url) const;

 private:
  Expected<std::string> path_of(const std::string& url) const;
  std::string folder_;
};

}  // namespace race::server
