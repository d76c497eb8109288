#include "server/commands/kept_token.h"

#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>

#include "core/value/fields.h"
#include "core/value/json.h"
#include "server/accounts/local_key.h"
#include "server/accounts/secret.h"
#include "server/http/encode_part.h"
#include "server/store/files.h"
#include "services/remote/address.h"

namespace race::server {
namespace {

// As the server makes them: what goes into a header holds no end of a line.
bool is_token(const std::string& text) {
  return text.starts_with(kTokenPrefix) && std::ranges::all_of(text, [](char c) {
           return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
         });
}

Expected<KeptToken> read(const std::string& text, const std::string& origin, const std::string& path) {
  const auto no_token = [&] {
    return unexpected(ErrorCode::not_accepted, "is no token of " + quote(origin) + ": `race login` again", path);
  };
  const auto json = parse_json(text);
  if (!json) return no_token();
  std::vector<Error> errors;
  Fields fields(*json, "", "the token", errors);
  const auto server = fields.text("server", kRequired), account = fields.text("account", kRequired),
             token = fields.text("token", kRequired);
  const auto expires = fields.integer("expires", 0, std::numeric_limits<std::int64_t>::max(), kRequired);
  if (!errors.empty() || *server != origin || !is_token(*token)) return no_token();
  return KeptToken{*account, *token, *expires};
}

}  // namespace

Expected<std::string> origin_of(std::string_view url) {
  ASSIGN_OR_RETURN(remote::Address address, remote::read_address(url));
  std::ranges::transform(address.host, address.host.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return (address.tls ? "https://" : "http://") + address.host + ':' + std::to_string(address.port);
}

KeptTokens KeptTokens::of_user() {
  const char* const state = std::getenv("XDG_STATE_HOME");
  if (state && *state == '/') return KeptTokens(std::string(state) + "/race");  // another one does not count there
  const char* const home = std::getenv("HOME");
  return KeptTokens(home && *home == '/' ? std::string(home) + "/.local/state/race" : "");
}

Expected<std::string> KeptTokens::path_of(const std::string& url) const {
  ASSIGN_OR_RETURN(const std::string origin, origin_of(url));
  const remote::Address address = remote::read_address(origin).value();
  return folder_ + (address.tls ? "/https_" : "/http_") + encode_part(address.host) + '_' +
         std::to_string(address.port) + ".json";
}

Expected<std::optional<KeptToken>> KeptTokens::find(const std::string& url) const {
  ASSIGN_OR_RETURN(const std::string origin, origin_of(url));
  ASSIGN_OR_RETURN(const std::string path, path_of(url));
  if (folder_.empty()) return std::optional<KeptToken>();
  ASSIGN_OR_RETURN(const bool is_there, file_exists(path));
  if (!is_there) return std::optional<KeptToken>();
  ASSIGN_OR_RETURN(const std::string text, read_private_file(path));
  ASSIGN_OR_RETURN(KeptToken token, read(text, origin, path));
  return std::optional(std::move(token));
}

Expected<void> KeptTokens::keep(const std::string& url, const KeptToken& token) const {
  ASSIGN_OR_RETURN(const std::string origin, origin_of(url));
  ASSIGN_OR_RETURN(const std::string path, path_of(url));
  if (folder_.empty())
    return unexpected(ErrorCode::io, "no token can be kept: neither HOME nor XDG_STATE_HOME names a folder");
  std::error_code failed;
  std::filesystem::create_directories(std::filesystem::path(folder_).parent_path(), failed);
  if (::mkdir(folder_.c_str(), S_IRWXU) != 0 && errno != EEXIST)
    return unexpected(ErrorCode::io, std::string("cannot be made: ") + std::strerror(errno), folder_);
  const Dict content{
      {"server", origin}, {"account", token.account}, {"expires", token.expires}, {"token", token.token}};
  return write_file(path, to_json(content, 1) + '\n', kOwnerAlone);
}

Expected<bool> KeptTokens::remove(const std::string& url) const {
  ASSIGN_OR_RETURN(const std::string path, path_of(url));
  std::error_code failed;
  const bool removed = !folder_.empty() && std::filesystem::remove(path, failed);
  if (failed) return unexpected(ErrorCode::io, "cannot be removed: " + failed.message(), path);
  return removed;
}

}  // namespace race::server
