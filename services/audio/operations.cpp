#include "services/audio/audio.h"
#include "services/types.h"

namespace race::audio {

namespace types = services::types;

// One sound plays at a time; a new one replaces it. A refused `play` takes `refused` at once, or `refuse_play` while
// another sound plays, which continues.
const services::OperationTable& Audio::operations() {
  static const services::OperationTable table({
      .name = "audio",
      .operations =
          {
              {.name = "play",
               .handler = &Audio::play,
               .parameters = {{.name = "sound", .type = "string", .doc = "a name of api/sounds.json"},
                              {.name = "volume", .type = "number", .min = 0, .max = 1, .value = 1},
                              {.name = "repeat", .type = "int", .min = 1, .max = 20, .value = 1, .doc = "times"},
                              {.name = "display", .type = "string", .value = "all"}},
               .result = types::record({{"sound", "string"}, {"displays", types::list("string")}}),
               .error =
                   types::record({{"code", "string"}, {"message", "string"}, {"argument", types::optional("string")}}),
               .acceptance = services::Acceptance::by_handler,
               .doc = "Answers when the sound is over, with the displays that have played it to its end."},
              {.name = "stop", .handler = &Audio::stop, .safe = true, .doc = "Silence; a play is answered `stopped`."},
          },
      .events = {{.name = "finished",
                  .data = types::record({{"sound", "string"}, {"displays", types::list("string")}}),
                  .doc = "A sound was played to its end."}},
      .states = {{"Idle", {}}, {"Playing", {}}},
      .init = "Idle",
      .transitions =
          {
              {.id = "play",
               .src = "Idle",
               .dst = "Playing",
               .operation = "play",
               .defer = {"finish", "refused", "fail", "replaced", "stop"},
               .refused = "refused"},
              {.id = "refuse_play", .src = "Playing", .dst = "Playing", .operation = "play"},
              {.id = "finish", .src = "Playing", .dst = "Idle", .events = {"finished"}},
              {.id = "refused", .src = "Playing", .dst = "Idle"},
              {.id = "fail", .src = "Playing", .dst = "Idle", .error = "speaker_lost"},
              {.id = "replaced", .src = "Playing", .dst = "Idle", .error = "replaced"},
              {.id = "stop", .src = "Playing", .dst = "Idle", .operation = "stop", .error = "stopped"},
              {.id = "stop_idle", .src = "Idle", .dst = "Idle", .operation = "stop"},
          },
  });
  return table;
}

const rsm::Service& model() { return Audio::operations().model(); }

}  // namespace race::audio
