// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <nanoflann.hpp>
#include <string>
#include <utility>
#include <vector>

#include "measure.hpp"

// The k-d tree of nanoflann (BSD) on the query of deburr's stage: all points within a radius of
// each point, nearest first, kept as one list of indices. The number is that of pairs, each point
// with itself included.

namespace {

struct Cloud {
  std::vector<peers::Point> points;

  [[nodiscard]] std::size_t kdtree_get_point_count() const { return points.size(); }
  [[nodiscard]] double kdtree_get_pt(std::size_t i, std::size_t axis) const {
    return points[i][axis];
  }
  template <typename Box>
  bool kdtree_get_bbox(Box& /*unused*/) const {
    return false;
  }
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) peers::fail("usage: nanoflann CLOUD RADIUS");
  const Cloud cloud{peers::read_points(argv[1])};
  const double radius = std::stod(argv[2]);
  peers::measure([&] {
    using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>,
                                                     Cloud, 3, std::uint32_t>;
    const Tree tree(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(10));
    nanoflann::SearchParams sorted;
    sorted.sorted = true;
    std::vector<std::pair<std::uint32_t, double>> found;
    std::vector<std::size_t> offsets{0};
    std::vector<std::uint32_t> indices;
    for (const peers::Point& p : cloud.points) {
      tree.radiusSearch(p.data(), radius * radius, found, sorted);
      for (const auto& f : found) indices.push_back(f.first);
      offsets.push_back(indices.size());
    }
    return offsets.back();
  });
  return 0;
}
