#include "services/recognition/object_recognition.h"

#include <algorithm>

namespace race::recognition {
namespace {

// From a picture to its event, in world time: what a picture takes here, with some to spare.
constexpr services::Time kLatency = 0.15;

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

/// The labels that a call asks for. Errors: `not_found` for a label of no part, `out_of_range` for none.
Expected<std::vector<std::string>> asked_labels(const Dict& arguments, const std::vector<std::string>& known) {
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

ObjectRecognition::ObjectRecognition(services::ServiceHost& host, std::vector<Part> parts)
    : TableComponent(operations(), host), recognizer_(std::move(parts)) {}

void ObjectRecognition::start(const services::Call& call, const Dict& arguments) {
  auto labels = asked_labels(arguments, recognizer_.labels());
  if (!labels) return refuse_arguments(call, labels.error());
  labels_ = std::move(*labels);
  take("started");
  listen(true);
  host().result(call.id, nullptr);
}

void ObjectRecognition::refuse_arguments(const services::Call& call, const Error& error) {
  listen(false);
  TableComponent::refuse_arguments(call, error);
}

void ObjectRecognition::stop_looking(const services::Call& call) {
  listen(false);
  host().result(call.id, nullptr);
}

void ObjectRecognition::listen(bool on) {
  ++session_;
  if (!on) labels_.clear();
  if (on && !worker_) worker_ = std::make_unique<services::Worker>(host());
  host().subscribe("camera", "frame", on);
}

void ObjectRecognition::packet(std::string_view, std::string_view, const services::PacketPtr& packet) {
  if (busy_ || labels_.empty()) return;
  auto image = read_rgbd_image(*packet);
  if (!image) return host().log("a frame that cannot be read: " + to_string(image.error()));
  busy_ = true;
  worker_->submit(host().now() + kLatency, [this, session = session_, labels = labels_, image = std::move(*image)] {
    auto detections = recognizer_.recognize(image, labels);
    return [this, session, time = image.time, detections = std::move(detections)] {
      busy_ = false;
      if (session == session_) report(time, detections);
    };
  });
}

void ObjectRecognition::report(services::Time time, const std::vector<Detection>& detections) {
  List objects;
  for (const Detection& detection : detections) objects.push_back(to_value(detection));
  host().event("recognized_objects", Dict{{"time", time}, {"objects", std::move(objects)}});
}

}  // namespace race::recognition
