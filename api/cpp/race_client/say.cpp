#include "api/cpp/race_client/say.h"

#include <algorithm>
#include <cstdio>

namespace race::client {

void say(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return c != '\n' && (static_cast<unsigned char>(c) < 0x20 || c == 0x7F); }, ' ');
  text += '\n';
  std::fwrite(text.data(), 1, text.size(), stderr);
}

}  // namespace race::client
