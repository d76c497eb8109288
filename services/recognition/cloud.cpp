// The only file that includes PCL (seconds to compile). Its templates for PointXYZ come from its libraries, but for
// those of pcl_segmentation: it brings pcl_features, and together they made every start of `race` 0.1 s longer.
#include "services/recognition/cloud.h"

#include <pcl/filters/voxel_grid.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/sample_consensus/ransac.h>
#include <pcl/sample_consensus/sac_model_plane.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/extract_clusters.h>

#include <memory>
#include <pcl/segmentation/impl/extract_clusters.hpp>

namespace race::recognition {
namespace {

using PclCloud = pcl::PointCloud<pcl::PointXYZ>;

PclCloud::Ptr to_pcl(const Cloud& cloud) {
  PclCloud::Ptr out(new PclCloud);
  out->reserve(cloud.size());
  for (const auto& p : cloud) out->push_back(pcl::PointXYZ(p[0], p[1], p[2]));
  return out;
}

}  // namespace

Cloud voxels(const Cloud& cloud, float leaf) {
  if (cloud.empty()) return {};
  pcl::VoxelGrid<pcl::PointXYZ> grid;
  grid.setInputCloud(to_pcl(cloud));
  grid.setLeafSize(leaf, leaf, leaf);
  PclCloud filtered;
  grid.filter(filtered);
  Cloud out;
  out.reserve(filtered.size());
  for (const auto& p : filtered) out.push_back({p.x, p.y, p.z});
  return out;
}

std::optional<Plane> find_plane(const Cloud& cloud, double tolerance, double share) {
  if (cloud.size() < 3) return std::nullopt;
  // Its random numbers have a fixed seed.
  const auto model = std::make_shared<pcl::SampleConsensusModelPlane<pcl::PointXYZ>>(to_pcl(cloud));
  pcl::RandomSampleConsensus<pcl::PointXYZ> search(model, tolerance);
  search.setMaxIterations(200);
  if (!search.computeModel()) return std::nullopt;
  pcl::Indices inliers;
  Eigen::VectorXf sampled, found;
  search.getInliers(inliers);
  search.getModelCoefficients(sampled);
  model->optimizeModelCoefficients(inliers, sampled, found);
  model->selectWithinDistance(found, tolerance, inliers);
  if (found.size() != 4 || static_cast<double>(inliers.size()) < share * static_cast<double>(cloud.size()))
    return std::nullopt;
  Plane plane;
  // a x + b y + c z + d = 0; the camera is at the origin, so d > 0 if the normal looks towards it.
  const double sign = found[3] >= 0 ? 1 : -1;
  for (std::size_t i = 0; i < 3; ++i) plane.normal[i] = sign * static_cast<double>(found[static_cast<Eigen::Index>(i)]);
  plane.offset = -sign * static_cast<double>(found[3]);
  return plane;
}

std::vector<Cloud> clusters(const Cloud& cloud, double gap, int least) {
  if (cloud.empty()) return {};
  const PclCloud::Ptr points = to_pcl(cloud);
  pcl::search::KdTree<pcl::PointXYZ>::Ptr tree(new pcl::search::KdTree<pcl::PointXYZ>);
  tree->setInputCloud(points);
  pcl::EuclideanClusterExtraction<pcl::PointXYZ> extraction;
  extraction.setClusterTolerance(gap);
  extraction.setMinClusterSize(least);
  extraction.setSearchMethod(tree);
  extraction.setInputCloud(points);
  std::vector<pcl::PointIndices> groups;
  extraction.extract(groups);  // the largest first
  std::vector<Cloud> out;
  for (const pcl::PointIndices& group : groups) {
    Cloud& one = out.emplace_back();
    for (const int i : group.indices) one.push_back(cloud[static_cast<std::size_t>(i)]);
  }
  return out;
}

}  // namespace race::recognition
