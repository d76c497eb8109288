#include "services/recognition/object_recognition.h"
#include "services/types.h"

namespace race::recognition {

namespace types = services::types;

// A refused `start` ends the recognition that was running: its caller wants other labels.
const services::OperationTable& ObjectRecognition::operations() {
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
          },
      .events = {{.name = "recognized_objects",
                  .data = types::record(
                      {{"time", "number"},
                       {"objects", types::list(types::record(
                                       {{"label", "string"}, {"pose", "pose"}, {"confidence", "number"}}))}}),
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
          },
  });
  return table;
}

const rsm::Service& model() { return ObjectRecognition::operations().model(); }

}  // namespace race::recognition
