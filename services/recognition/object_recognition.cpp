#include "services/recognition/object_recognition.h"

#include <algorithm>
#include <utility>

namespace race::recognition {
namespace {

// From a picture to its event, in world time: what a picture takes here, with some to spare.
constexpr services::Time kLatency = 0.15;
// For a picture to come: cameras give several a second, and a request waits 5 s for its response.
constexpr services::Time kPictureTime = 2;

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

void ObjectRecognition::look(const services::Call& call) {
  looks_.push_back({call.id, host().now()});
  subscribe();
}

void ObjectRecognition::list_labels(const services::Call& call) {
  const std::vector<std::string>& known = recognizer_.labels();
  host().result(call.id, List(known.begin(), known.end()));
}

// What is looked for is something else from now on. By the RSM, the transition that was taken has answered the looks.
void ObjectRecognition::listen(bool on) {
  ++session_;
  started_ = on;
  const Value interrupted =
      services::error_value("interrupted", "recognition was started or stopped before it had seen a picture");
  for (const Look& each : std::exchange(looks_, {})) host().error(each.call, interrupted);
  subscribe();
}

void ObjectRecognition::subscribe() {
  if (is_wanted() && !worker_) worker_ = std::make_unique<services::Worker>(host());
  host().subscribe("camera", "frame", is_wanted());
}

void ObjectRecognition::unsubscribe_if_unwanted() {
  if (!is_wanted()) subscribe();
}

void ObjectRecognition::end_look(services::CallId call) { take(started_ ? "seen_recognizing" : "seen_idle", call); }

void ObjectRecognition::abandoned(services::CallId call) {
  const auto found = std::ranges::find(looks_, call, &Look::call);
  if (found == looks_.end()) return;
  looks_.erase(found);
  end_look(call);
  host().error(call, services::error_value("abandoned", "nobody waits for the response"));
  unsubscribe_if_unwanted();
}

// A picture that is being processed has come in time.
void ObjectRecognition::step() {
  if (busy_ || looks_.empty()) return;
  const services::Time now = host().now();
  while (!looks_.empty() && looks_.front().asked + kPictureTime <= now) {
    const services::CallId late = looks_.front().call;
    looks_.pop_front();
    end_look(late);
    host().error(late, services::error_value("no_picture", "no picture has come from the camera"));
  }
  unsubscribe_if_unwanted();
}

void ObjectRecognition::packet(std::string_view, std::string_view, const services::PacketPtr& packet) {
  if (busy_ || !is_wanted()) return;
  auto image = read_rgbd_image(*packet);
  if (!image) return host().log("a frame that cannot be read: " + to_string(image.error()));
  busy_ = true;
  const std::vector<std::string>& wanted = started_ ? labels_ : recognizer_.labels();
  worker_->submit(host().now() + kLatency, [this, session = session_, labels = wanted, image = std::move(*image)] {
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
  const Value seen = Dict{{"time", time}, {"objects", std::move(objects)}};
  if (started_) host().event("recognized_objects", seen);
  while (!looks_.empty() && looks_.front().asked <= time) {
    const services::CallId call = looks_.front().call;
    looks_.pop_front();
    end_look(call);
    host().result(call, seen);
  }
  unsubscribe_if_unwanted();
}

}  // namespace race::recognition
