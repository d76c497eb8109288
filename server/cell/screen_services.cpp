#include "server/cell/screen_services.h"

#include "services/audio/audio.h"
#include "services/display/display.h"

namespace race::server {

std::vector<FurtherService> screen_services(display::Screens& screens, const std::string& folder) {
  const auto make_display = [&screens, folder](services::ServiceHost& host) {
    return std::make_unique<display::Display>(screens, folder, host);
  };
  const auto make_audio = [&screens](services::ServiceHost& host) {
    return std::make_unique<audio::Audio>(screens, host);
  };
  return {{"display", "display", make_display}, {"audio", "audio", make_audio}};
}

}  // namespace race::server
