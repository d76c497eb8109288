// Recognizer: which parts a picture shows, and where. The pipeline: colours (OpenCV), the plane that things stand on
// and clusters of each colour (PCL), first poses by bounding box or by the arrangement of colours, then closest points
// against the part's surface; what no part explains well is left out.
//
// Threads: immutable once made; recognize() on any.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "services/recognition/part.h"
#include "services/recognition/rgbd_image.h"

namespace race::recognition {

struct Detection {
  std::string label;
  Pose c_t_x;             // the part's frame x seen from the camera
  double confidence = 0;  // 0..1
};

class Recognizer {
 public:
  explicit Recognizer(std::vector<Part> parts);
  ~Recognizer();
  Recognizer(const Recognizer&) = delete;
  Recognizer& operator=(const Recognizer&) = delete;

  /// In the order of the parts file.
  const std::vector<std::string>& labels() const;
  /// What is seen of the parts with these labels, by confidence.
  std::vector<Detection> recognize(const RgbdImage& image, const std::vector<std::string>& labels) const;

 private:
  struct Knowledge;
  std::unique_ptr<Knowledge> knowledge_;
};

}  // namespace race::recognition
