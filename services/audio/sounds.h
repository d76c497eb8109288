// The sounds of api/sounds.json, which the pages synthesise and the server only has to know by name and length. Part of
// the program: what it plays is what its pages know.
#pragma once

#include <map>
#include <string>

namespace race::audio {

/// Name -> length [s], from the start to the end of the last note.
const std::map<std::string, double>& sounds();

}  // namespace race::audio
