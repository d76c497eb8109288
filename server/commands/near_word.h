// The word of a list that a misspelled one probably means, for messages of the command line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace race::server {

/// The only candidate that `word` is the beginning of, or else the one that it comes to with the fewest slips (a letter
/// too many, missing, wrong, or two exchanged; two at most, and one of three letters at most). Empty: none, or several
/// alike.
std::string near_word(std::string_view word, const std::vector<std::string>& candidates);

/// "; did you mean `--seed`?" or nothing, to end a message.
std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace race::server
