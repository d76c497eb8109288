// The word of a list that a misspelled one probably means, for messages of the command line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace race::server {

/// The candidate that `word` comes to with the fewest slips (a letter too many, missing, wrong, or two exchanged; two
/// at most, and one of three letters at most), or the only one that it is the beginning of. Empty: none, or several
/// alike.
std::string near_word(std::string_view word, const std::vector<std::string>& candidates);

/// "; did you mean `--seed`?" or nothing, to end a message.
std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace race::server
