// ObjectRecognition: the service `obj_rec` (thesis, appendix A): while it is started, it reports the poses of
// parts, from the pictures of the service `camera` alone. Operations, events and limits: README.md.
//
// Threads: its group's; pictures are processed on a thread of its own.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "services/host/worker.h"
#include "services/recognition/recognize.h"
#include "services/table_component.h"

namespace race::recognition {

/// The RSM of every recognition.
const rsm::Service& model();

class ObjectRecognition final : public services::TableComponent {
 public:
  ObjectRecognition(services::ServiceHost& host, std::vector<Part> parts);

  static const services::OperationTable& operations();
  void packet(std::string_view key, std::string_view flow, const services::PacketPtr& packet) override;
  void stop() override { worker_.reset(); }

 private:
  void start(const services::Call& call, const Dict& arguments);
  void stop_looking(const services::Call& call);
  void refuse_arguments(const services::Call& call, const Error& error) override;
  void listen(bool on);
  void report(services::Time time, const std::vector<Detection>& detections);

  const Recognizer recognizer_;
  std::vector<std::string> labels_;  // looked for now; none: idle
  std::uint64_t session_ = 0;        // counts starts and stops: an answer of an earlier one is dropped
  bool busy_ = false;
  std::unique_ptr<services::Worker> worker_;
};

}  // namespace race::recognition
