// The write-ahead log that a process left which did not close its file. SQLite reads it up to the first frame that does
// not fit and takes the rest for what a crash tore; so damage in the middle would undo, in silence, every commit after
// it.
//
// Threads: any; nobody writes to the file meanwhile.
#pragma once

#include <string>

#include "core/value/expected.h"

namespace race::sqlite {

/// Whether the log of the file at `path`, if there is one, ends as a crash may leave it: what does not fit is of its
/// last transaction. Errors: `corrupt`: there are whole commits behind a frame that does not fit, or its header is
/// damaged; `storage`: it cannot be read. Damage to the last transaction itself looks like a crash before it was
/// durable.
Expected<void> check_log(const std::string& path);

}  // namespace race::sqlite
