#include "services/recognition/object_recognition.h"

#include <algorithm>

#include "core/rsm/document.h"
#include "services/arguments.h"

namespace race::recognition {
namespace {

// From a picture to its event, in world time: what a picture takes here, with some to spare.
constexpr services::Time kLatency = 0.15;

// A start that is refused ends what was going on: whoever starts anew wants other labels.
constexpr std::string_view kModel = R"json({
  "rsm": 1, "name": "ObjectRecognition",
  "operations": [
    {"name": "start", "parameters": [
       {"name": "labels", "type": {"optional": {"list": "string"}}, "doc": "of the parts to look for; without, all"}],
     "error": {"record": {"code": "string", "message": "string", "argument": {"optional": "string"}}},
     "doc": "Looks for parts until it is stopped, or started with other labels."},
    {"name": "stop", "safe": true, "doc": "Looks no longer."}
  ],
  "events": [
    {"name": "recognized_objects", "sampled": true, "rate_hz": 5,
     "data": {"record": {"time": "number", "objects": {"list": {"record": {
       "label": "string", "pose": "pose", "confidence": "number"}}}}},
     "doc": "What a picture shows, by confidence; pose is c_t_x. time: of the picture [s]."}
  ],
  "subscribes": [{"service": "camera", "event": "frame"}],
  "states": [{"name": "Idle"}, {"name": "Starting"}, {"name": "Recognizing", "events": ["recognized_objects"]}],
  "init": "Idle",
  "transitions": [
    {"id": "start", "dst": "Starting", "operation": "start", "defer": ["started", "refused"]},
    {"id": "started", "src": "Starting", "dst": "Recognizing"},
    {"id": "refused", "src": "Starting", "dst": "Idle"},
    {"id": "stop", "dst": "Idle", "operation": "stop"}
  ]
})json";

template <std::size_t N>
Value numbers(const std::array<double, N>& values) {
  return List(values.begin(), values.end());
}

Value to_value(const Detection& detection) {
  return Dict{{"label", detection.label},
              {"pose", Dict{{"position", numbers(detection.c_t_x.position)},
                            {"orientation", numbers(detection.c_t_x.orientation)}}},
              {"confidence", detection.confidence}};
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// The labels that a call asks for. Errors: those of bind_arguments, `not_found` for a label of no part.
Expected<std::vector<std::string>> asked_labels(const services::Call& call, const std::vector<std::string>& known) {
  ASSIGN_OR_RETURN(const Dict arguments, services::bind_arguments(*services::find_operation(model(), "start"), call));
  const Value* list = arguments.find("labels");
  if (!list || list->is_null()) return known;
  std::vector<std::string> labels;
  for (const Value& label : list->as_list()) {
    if (std::ranges::find(known, label.as_string()) == known.end())
      return unexpected(ErrorCode::not_found, "there is no part `" + label.as_string() + "`, only " + joined(known),
                        "labels");
    labels.push_back(label.as_string());
  }
  if (labels.empty()) return unexpected(ErrorCode::out_of_range, "argument `labels`: must not be empty", "labels");
  return labels;
}

}  // namespace

const rsm::Service& model() {
  static const rsm::Service service = rsm::read_service_text(kModel, "services/recognition").value();
  return service;
}

ObjectRecognition::ObjectRecognition(services::ServiceHost& host, std::vector<Part> parts)
    : host_(host), recognizer_(std::move(parts)) {}

void ObjectRecognition::call(const services::Call& call) {
  if (call.operation == "start") return start(call);
  host_.transition("stop", call.id);
  listen(false);
  host_.result(call.id, nullptr);
}

void ObjectRecognition::start(const services::Call& call) {
  host_.transition("start", call.id);
  auto labels = asked_labels(call, recognizer_.labels());
  if (!labels) {
    Value error = services::error_value(labels.error());
    if (!labels.error().path.empty()) error.mutable_dict().set("argument", labels.error().path);
    host_.transition("refused");
    listen(false);
    return host_.error(call.id, std::move(error));
  }
  labels_ = std::move(*labels);
  host_.transition("started");
  listen(true);
  host_.result(call.id, nullptr);
}

void ObjectRecognition::listen(bool on) {
  ++session_;
  if (!on) labels_.clear();
  if (on && !worker_) worker_ = std::make_unique<services::Worker>(host_);
  host_.subscribe("camera", "frame", on);
}

void ObjectRecognition::packet(std::string_view, std::string_view, const services::PacketPtr& packet) {
  if (busy_ || labels_.empty()) return;
  auto frame = read_frame(*packet);
  if (!frame) return host_.log("a frame that cannot be read: " + to_string(frame.error()));
  busy_ = true;
  worker_->submit(host_.now() + kLatency, [this, session = session_, labels = labels_, frame = std::move(*frame)] {
    auto detections = recognizer_.recognize(frame, labels);
    return [this, session, time = frame.time, detections = std::move(detections)] {
      busy_ = false;
      if (session == session_) report(time, detections);
    };
  });
}

void ObjectRecognition::report(services::Time time, const std::vector<Detection>& detections) {
  List objects;
  for (const Detection& detection : detections) objects.push_back(to_value(detection));
  host_.event("recognized_objects", Dict{{"time", time}, {"objects", std::move(objects)}});
}

}  // namespace race::recognition
