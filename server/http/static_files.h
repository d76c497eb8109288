// The files of the browser pages: everything below one folder, read when it is asked for, sent compressed if it was
// built so.
#pragma once

#include <optional>
#include <string>

#include "server/http/message.h"

namespace race::server {

/// The file of the request's path below `folder`; "/" and folders are their index.html. Nothing: no such file, one
/// outside of the folder, or no folder (empty). Files whose names carry a hash (below /assets/) may be kept for ever.
///
/// A file NAME may have compressed copies NAME.br and NAME.gz, which have no paths of their own: the one that the
/// client's Accept-Encoding prefers is sent. 406 (`not_acceptable`): it accepts none, nor the file itself. Each has a
/// strong ETag of its own; 304 without a body if If-None-Match names it. 500 (`io`): it cannot be read.
std::optional<Reply> static_file(const std::string& folder, const Request& request);

}  // namespace race::server
