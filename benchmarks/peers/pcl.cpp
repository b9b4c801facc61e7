// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/surface/mls.h>

#include <string>

#include "measure.hpp"

// Moving least squares of PCL, of second order, on one thread: pcl CLOUD OUT RADIUS.

int main(int argc, char** argv) {
  if (argc != 4) peers::fail("usage: pcl CLOUD OUT RADIUS");
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (const peers::Point& p : peers::read_points(argv[1])) {
    cloud->push_back(
        {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
  }
  pcl::PointCloud<pcl::PointXYZ> smooth;
  peers::measure([&] {
    pcl::MovingLeastSquares<pcl::PointXYZ, pcl::PointXYZ> mls;
    const pcl::search::KdTree<pcl::PointXYZ>::Ptr tree(new pcl::search::KdTree<pcl::PointXYZ>);
    mls.setSearchMethod(tree);
    mls.setInputCloud(cloud);
    mls.setPolynomialOrder(2);
    mls.setSearchRadius(std::stod(argv[3]));
    mls.process(smooth);
    return smooth.size();
  });
  peers::write_points(argv[2], smooth.size(), [&](std::size_t i) {
    return peers::Point{smooth[i].x, smooth[i].y, smooth[i].z};
  });
  return 0;
}
