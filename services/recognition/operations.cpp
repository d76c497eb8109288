#include "services/recognition/object_recognition.h"
#include "services/types.h"

namespace race::recognition {

namespace types = services::types;

// A refused `start` ends the recognition that was running: its caller wants other labels. `start` and `stop` leave
// every state, so they end the looks that wait.
const services::OperationTable& ObjectRecognition::operations() {
  static const Value picture = types::record(
      {{"time", "number"},
       {"objects", types::list(types::record({{"label", "string"}, {"pose", "pose"}, {"confidence", "number"}}))}});
  static const services::OperationTable table({
      .name = "ObjectRecognition",
      .operations =
          {
              {.name = "start",
               .handler = &ObjectRecognition::start,
               .parameters = {{.name = "labels",
                               .type = types::optional(types::list("string")),
                               .doc = "of the parts to look for; without, all"}},
               .error =
                   types::record({{"code", "string"}, {"message", "string"}, {"argument", types::optional("string")}}),
               .doc = "Looks for parts until it is stopped, or started with other labels."},
              {.name = "stop", .handler = &ObjectRecognition::stop_looking, .safe = true, .doc = "Looks no longer."},
              {.name = "look",
               .handler = &ObjectRecognition::look,
               .result = picture,
               .error = types::record({{"code", "string"}, {"message", "string"}}),
               .reads = true,
               .doc = "What the next picture shows, as the event tells it: of all parts, or of those that a `start` "
                      "looks for; error `no_picture`: none has come; `interrupted`: it was started or stopped."},
              {.name = "labels",
               .handler = &ObjectRecognition::list_labels,
               .result = types::list("string"),
               .reads = true,
               .doc = "The labels of all parts that it can find."},
          },
      .events = {{.name = "recognized_objects",
                  .data = picture,
                  .sampled = true,
                  .rate_hz = 5,
                  .doc = "What a picture shows, by confidence; pose is c_t_x. time: of the picture [s]."}},
      .subscribes = {{"camera", "frame"}},
      .states = {{"Idle", {}}, {"Starting", {}}, {"Recognizing", {"recognized_objects"}}},
      .init = "Idle",
      .transitions =
          {
              {.id = "start",
               .dst = "Starting",
               .operation = "start",
               .defer = {"started", "refused"},
               .refused = "refused"},
              {.id = "started", .src = "Starting", .dst = "Recognizing"},
              {.id = "refused", .src = "Starting", .dst = "Idle"},
              {.id = "stop", .dst = "Idle", .operation = "stop"},
              {.id = "look_idle",
               .src = "Idle",
               .dst = "Idle",
               .operation = "look",
               .defer = {"seen_idle"},
               .concurrent = true,
               .refused = "seen_idle"},
              {.id = "look_recognizing",
               .src = "Recognizing",
               .dst = "Recognizing",
               .operation = "look",
               .defer = {"seen_recognizing"},
               .concurrent = true,
               .refused = "seen_recognizing"},
              {.id = "seen_idle", .src = "Idle", .dst = "Idle"},
              {.id = "seen_recognizing", .src = "Recognizing", .dst = "Recognizing"},
              {.id = "labels_idle", .src = "Idle", .dst = "Idle", .operation = "labels"},
              {.id = "labels_recognizing", .src = "Recognizing", .dst = "Recognizing", .operation = "labels"},
          },
  });
  return table;
}

const rsm::Service& model() { return ObjectRecognition::operations().model(); }

}  // namespace race::recognition
