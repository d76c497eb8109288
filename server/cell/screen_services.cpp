#include "server/cell/screen_services.h"

#include "services/audio/audio.h"
#include "services/audio/remote_speakers.h"
#include "services/display/display.h"
#include "services/display/remote_stage.h"

namespace race::server {

std::vector<ExtraService> screen_services(display::Screens& screens, const std::string& folder) {
  const auto make_display = [&screens, folder](services::ServiceHost& host) {
    return std::make_unique<display::Display>(screens, folder, host);
  };
  const auto make_audio = [&screens](services::ServiceHost& host) {
    return std::make_unique<audio::Audio>(screens, host);
  };
  const auto doings = [&screens] { return screens.doings(); };
  const remote::HostFunctions stage{[&screens](const std::string& function, const Dict& arguments) {
                                      return display::answer_stage(screens, function, arguments);
                                    },
                                    doings,
                                    [&screens] {
                                      screens.withdraw();
                                      screens.take();
                                    }};
  const remote::HostFunctions speakers{[&screens](const std::string& function, const Dict& arguments) {
                                         return audio::answer_speakers(screens, function, arguments);
                                       },
                                       doings, [&screens] { screens.silence(); }};
  return {{"display", "display", make_display, stage}, {"audio", "audio", make_audio, speakers}};
}

}  // namespace race::server
