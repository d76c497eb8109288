#include "server/cell/screen_services.h"

#include "services/audio/audio.h"
#include "services/audio/remote_speakers.h"
#include "services/display/display.h"
#include "services/display/remote_display_backend.h"

namespace race::server {

std::vector<ExtraService> screen_services(display::Screens& screens, const std::string& folder) {
  const auto make_display = [&screens, folder](services::ServiceHost& host) {
    return std::make_unique<display::Display>(screens, folder, host);
  };
  const auto make_audio = [&screens](services::ServiceHost& host) {
    return std::make_unique<audio::Audio>(screens, host);
  };
  const auto revision = [&screens] { return screens.revision(); };
  const remote::HostFunctions backend{[&screens](const std::string& function, const Dict& arguments) {
                                        return display::answer_display_request(screens, function, arguments);
                                      },
                                      revision,
                                      [&screens] {
                                        screens.withdraw();
                                        screens.take();
                                      }};
  const remote::HostFunctions speakers{[&screens](const std::string& function, const Dict& arguments) {
                                         return audio::answer_audio_request(screens, function, arguments);
                                       },
                                       revision, [&screens] { screens.silence(); }};
  return {{"display", "display", make_display, backend}, {"audio", "audio", make_audio, speakers}};
}

}  // namespace race::server
