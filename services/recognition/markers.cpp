#include "services/recognition/markers.h"

#include <algorithm>
#include <opencv2/aruco.hpp>
#include <opencv2/imgproc.hpp>

#include "services/marker.h"

namespace race::recognition {
namespace {

constexpr int kEnlarged = 5;    // a marker of 40 mm has some 20 pixels at 1 m, its cells three: too few for contours
constexpr int kLargest = 4096;  // pixels of the enlarged picture along one side

/// The region as brightness: the brightest channel, in which all that is colourful is bright beside black.
cv::Mat brightness(const RgbdImage& image, const Region& region) {
  cv::Mat out(region.bottom - region.top, region.right - region.left, CV_8UC1);
  for (int v = region.top; v < region.bottom; ++v)
    for (int u = region.left; u < region.right; ++u)
      out.at<std::uint8_t>(v - region.top, u - region.left) = std::ranges::max(image.colour[image.index(u, v)]);
  return out;
}

cv::Ptr<cv::aruco::DetectorParameters> parameters(cv::aruco::CornerRefineMethod refinement) {
  auto parameters = cv::aruco::DetectorParameters::create();
  // In enlarged pixels; what else there is stays as OpenCV has it: no cell of a code may be wrong.
  parameters->adaptiveThreshWinSizeMax = 43;
  parameters->perspectiveRemovePixelPerCell = 8;
  parameters->maxErroneousBitsInBorderRate = 0.1;  // one of the 20 cells of the rim
  parameters->cornerRefinementMethod = refinement;
  return parameters;
}

struct Detected {
  std::vector<int> ids;
  std::vector<std::vector<cv::Point2f>> corners;
};

Detected detect(const cv::Mat& picture, cv::aruco::CornerRefineMethod refinement) {
  Detected found;
  cv::aruco::detectMarkers(picture, cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50), found.corners,
                           found.ids, parameters(refinement));
  return found;
}

/// All that can be read, also where one contour has an edge of less than two pixels: OpenCV refuses to refine that.
Detected detect(const cv::Mat& picture) {
  try {
    return detect(picture, cv::aruco::CORNER_REFINE_CONTOUR);
  } catch (const cv::Exception&) {
    return detect(picture, cv::aruco::CORNER_REFINE_NONE);
  }
}

}  // namespace

std::vector<SeenMarker> find_markers(const RgbdImage& image, Region region) {
  region = {std::max(region.left, 0), std::max(region.top, 0), std::min(region.right, image.width),
            std::min(region.bottom, image.height)};
  if (region.left >= region.right || region.top >= region.bottom) return {};
  const int side = std::max(region.right - region.left, region.bottom - region.top);
  const int enlarged = std::clamp(kLargest / side, 1, kEnlarged);
  cv::Mat picture;
  cv::resize(brightness(image, region), picture, {}, enlarged, enlarged, cv::INTER_CUBIC);
  const auto [ids, corners] = detect(picture);
  std::vector<SeenMarker> markers;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    SeenMarker marker{ids[i], {}};
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const cv::Point2f at = (corners[i][corner] + cv::Point2f(0.5F, 0.5F)) / enlarged - cv::Point2f(0.5F, 0.5F);
      marker.corners[corner] = {region.left + static_cast<double>(at.x), region.top + static_cast<double>(at.y)};
    }
    markers.push_back(marker);
  }
  return markers;
}

}  // namespace race::recognition
