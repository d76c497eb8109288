// The arguments of the display's operations, held to their limits.
#pragma once

#include <string>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "services/display/content.h"

namespace race::display {

inline constexpr std::size_t kTextBytes = 2000;
inline constexpr std::size_t kButtons = 8;
inline constexpr std::size_t kButtonBytes = 40;
inline constexpr std::size_t kUnitBytes = 16;

// Each reads what bind_arguments() gave. Errors, with the argument as path: `too_large`, `out_of_range`, `duplicate`,
// and those of image_url().

/// Of show_text, show_image and show_progress.
Expected<Message> read_message(const Dict& arguments, const std::string& folder);
/// Of ask, choose and ask_number.
Expected<Question> read_question(const Dict& arguments);
/// `display`: "all", a name, or `@` and a place. Error `name`.
Expected<std::string> read_target(const Dict& arguments);

}  // namespace race::display
