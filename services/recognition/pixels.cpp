#include "services/recognition/pixels.h"

#include <numbers>
#include <opencv2/imgproc.hpp>

namespace race::recognition {
namespace {

// OpenCV's full range: 256 steps of hue around the circle.
constexpr int kHueTolerance = 7;       // 10 degrees
constexpr int kLeastSaturation = 100;  // of 255: the table and the floor have less
constexpr int kLeastValue = 30;        // of 255: darker ones have no certain hue

cv::Mat to_hsv(const cv::Mat& rgb) {
  cv::Mat hsv;
  cv::cvtColor(rgb, hsv, cv::COLOR_RGB2HSV_FULL);
  return hsv;
}

int hue_of(const Colour& colour) {
  return to_hsv(cv::Mat(1, 1, CV_8UC3, cv::Scalar(colour[0], colour[1], colour[2]))).at<cv::Vec3b>(0, 0)[0];
}

/// For each hue the colour of the palette that it belongs to.
std::array<std::uint8_t, 256> colour_of_hue(const std::vector<Colour>& palette) {
  std::array<std::uint8_t, 256> table;
  std::array<int, 256> nearest;
  table.fill(kNoColour);
  nearest.fill(kHueTolerance + 1);
  for (std::size_t i = 0; i < palette.size(); ++i) {
    const int hue = hue_of(palette[i]);
    for (int h = 0; h < 256; ++h) {
      const int apart = std::min((h - hue) & 255, (hue - h) & 255);
      if (apart >= nearest[static_cast<std::size_t>(h)]) continue;
      nearest[static_cast<std::size_t>(h)] = apart;
      table[static_cast<std::size_t>(h)] = static_cast<std::uint8_t>(i);
    }
  }
  return table;
}

}  // namespace

std::vector<std::uint8_t> classify(const RgbdImage& image, const std::vector<Colour>& palette) {
  const auto table = colour_of_hue(palette);
  // OpenCV reads through a pointer that is not const; it does not write.
  const cv::Mat rgb(image.height, image.width, CV_8UC3, const_cast<Colour*>(image.colour.data()));
  const cv::Mat hsv = to_hsv(rgb);
  std::vector<std::uint8_t> out(image.colour.size(), kNoColour);
  for (int v = 0; v < image.height; ++v) {
    const cv::Vec3b* row = hsv.ptr<cv::Vec3b>(v);
    for (int u = 0; u < image.width; ++u)
      if (row[u][1] >= kLeastSaturation && row[u][2] >= kLeastValue) out[image.index(u, v)] = table[row[u][0]];
  }
  return out;
}

Rectangle smallest_rectangle(const std::vector<std::array<double, 2>>& points) {
  std::vector<cv::Point2f> contour;
  for (const auto& point : points) contour.emplace_back(static_cast<float>(point[0]), static_cast<float>(point[1]));
  const cv::RotatedRect r = cv::minAreaRect(contour);
  return {static_cast<double>(r.center.x), static_cast<double>(r.center.y),
          static_cast<double>(r.angle) * std::numbers::pi / 180, static_cast<double>(r.size.width),
          static_cast<double>(r.size.height)};
}

}  // namespace race::recognition
