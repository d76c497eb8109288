// ObjectRecognition: the service `obj_rec` (thesis, appendix A): while it is started, it reports the poses of
// parts, from the pictures of the service `camera` alone; asked by `look`, those of one picture. Operations, events and
// limits: README.md.
//
// Threads: its group's; pictures are processed on a thread of its own.
#pragma once

#include <cstdint>
#include <deque>
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
  void abandoned(services::CallId call) override;
  void step() override;
  void stop() override { worker_.reset(); }

 private:
  /// A call of `look` that waits for what a picture shows.
  struct Look {
    services::CallId call = 0;
    services::Time asked = 0;  // a picture that was taken before is none for it
  };
  void start(const services::Call& call, const Dict& arguments);
  void stop_looking(const services::Call& call);
  void look(const services::Call& call);
  void list_labels(const services::Call& call);
  void refuse_arguments(const services::Call& call, const Error& error) override;
  void listen(bool on);
  /// Somebody wants to know what the pictures show.
  bool is_wanted() const { return started_ || !looks_.empty(); }
  /// Gets pictures from now on, or none any more, as it is wanted.
  void subscribe();
  void unsubscribe_if_unwanted();
  /// The RSM has it that this look has its response now.
  void end_look(services::CallId call);
  void report(services::Time time, const std::vector<Detection>& detections);

  const Recognizer recognizer_;
  bool started_ = false;
  std::vector<std::string> labels_;  // that the last start asks for
  std::deque<Look> looks_;           // in the order in which they were asked
  std::uint64_t session_ = 0;        // counts starts and stops: an answer of an earlier one is dropped
  bool busy_ = false;
  std::unique_ptr<services::Worker> worker_;
};

}  // namespace race::recognition
