// LocalKey: the token of processes of services that the user of the server starts on the same machine, in a file of the
// data folder that only that user may read. Others on the machine cannot be a service, also where there are no
// accounts.
//
// Threads: any.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/value/expected.h"
#include "server/accounts/role.h"

namespace race::server {

class LocalKey {
 public:
  /// Reads the file, or makes it. `groups`: all component groups. Errors, with the path: `io`; `not_accepted`: others
  /// may read it.
  static Expected<LocalKey> open(const std::string& path, std::vector<std::string> groups);

  bool is(std::string_view secret) const;
  /// Who has it: a process that may bring all groups.
  Identity identity() const;

 private:
  LocalKey(std::string digest, std::vector<std::string> groups)
      : digest_(std::move(digest)), groups_(std::move(groups)) {}
  std::string digest_;
  std::vector<std::string> groups_;
};

/// The text of a small file (1000 bytes) that holds a secret. Errors, with the path: `io`; `too_large`; `not_accepted`:
/// others than its owner may read it.
Expected<std::string> read_private_file(const std::string& path);

/// The secret in a file, without white space around it. Errors, with the path: `io`; `not_accepted`: others than its
/// owner may read it, or it holds no token.
Expected<std::string> read_token_file(const std::string& path);

}  // namespace race::server
