#include "services/audio/sounds.h"

#include <algorithm>

#include "core/value/json.h"
#include "services/audio/sounds_json.h"

namespace race::audio {
namespace {

std::map<std::string, double> read() {
  std::map<std::string, double> lengths;
  const Value json = parse_json(kSoundsJson).value();
  for (const Value& sound : json.find("sounds")->as_list()) {
    double& length = lengths[sound.find("name")->as_string()];
    for (const Value& note : sound.find("notes")->as_list())
      length = std::max(length, note.find("at")->to_double() + note.find("for")->to_double());
  }
  return lengths;
}

}  // namespace

const std::map<std::string, double>& sounds() {
  static const std::map<std::string, double> lengths = read();
  return lengths;
}

}  // namespace race::audio
