#include "services/recognition/markers.h"

#include <algorithm>
#include <opencv2/aruco.hpp>
#include <opencv2/imgproc.hpp>

#include "services/marker.h"

namespace race::recognition {
namespace {

constexpr int kEnlarged = 5;  // a marker of 40 mm has some 20 pixels at 1 m, its cells three: too few for contours

/// The region as brightness: the brightest channel, in which all that is colourful is bright beside black.
cv::Mat brightness(const Frame& frame, const Region& region) {
  cv::Mat out(region.bottom - region.top, region.right - region.left, CV_8UC1);
  for (int v = region.top; v < region.bottom; ++v)
    for (int u = region.left; u < region.right; ++u)
      out.at<std::uint8_t>(v - region.top, u - region.left) = std::ranges::max(frame.colour[frame.index(u, v)]);
  return out;
}

cv::Ptr<cv::aruco::DetectorParameters> parameters() {
  auto parameters = cv::aruco::DetectorParameters::create();
  // In enlarged pixels; what else there is stays as OpenCV has it: no cell of a code may be wrong.
  parameters->adaptiveThreshWinSizeMax = 43;
  parameters->perspectiveRemovePixelPerCell = 8;
  parameters->maxErroneousBitsInBorderRate = 0.1;  // one of the 20 cells of the rim
  parameters->cornerRefinementMethod = cv::aruco::CORNER_REFINE_CONTOUR;
  return parameters;
}

}  // namespace

std::vector<SeenMarker> find_markers(const Frame& frame, Region region) {
  region = {std::max(region.left, 0), std::max(region.top, 0), std::min(region.right, frame.width),
            std::min(region.bottom, frame.height)};
  if (region.left >= region.right || region.top >= region.bottom) return {};
  cv::Mat picture;
  cv::resize(brightness(frame, region), picture, {}, kEnlarged, kEnlarged, cv::INTER_CUBIC);
  std::vector<int> ids;
  std::vector<std::vector<cv::Point2f>> corners;
  try {
    cv::aruco::detectMarkers(picture, cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50), corners, ids,
                             parameters());
  } catch (const cv::Exception&) {
    return {};  // a contour with an edge of less than two pixels cannot be refined: nothing that small can be read
  }
  std::vector<SeenMarker> markers;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    SeenMarker marker{ids[i], {}};
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const cv::Point2f at = (corners[i][corner] + cv::Point2f(0.5F, 0.5F)) / kEnlarged - cv::Point2f(0.5F, 0.5F);
      marker.corners[corner] = {region.left + static_cast<double>(at.x), region.top + static_cast<double>(at.y)};
    }
    markers.push_back(marker);
  }
  return markers;
}

}  // namespace race::recognition
