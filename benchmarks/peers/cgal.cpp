// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <CGAL/Simple_cartesian.h>
#include <CGAL/bilateral_smooth_point_set.h>
#include <CGAL/jet_estimate_normals.h>
#include <CGAL/jet_smooth_point_set.h>
#include <CGAL/property_map.h>
#include <CGAL/wlop_simplify_and_regularize_point_set.h>

#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "measure.hpp"

// What CGAL offers to smooth points, on one thread: cgal jet|bilateral|wlop CLOUD OUT K. K is the
// number of neighbours; wlop takes its own radius and keeps half of the points.

using Kernel = CGAL::Simple_cartesian<double>;
using Oriented = std::pair<Kernel::Point_3, Kernel::Vector_3>;

int main(int argc, char** argv) {
  if (argc != 5) peers::fail("usage: cgal jet|bilateral|wlop CLOUD OUT K");
  const std::string method = argv[1];
  const auto k = static_cast<unsigned>(std::stoul(argv[4]));
  std::vector<Kernel::Point_3> points;
  for (const peers::Point& p : peers::read_points(argv[2])) points.emplace_back(p[0], p[1], p[2]);

  if (method == "jet") {
    peers::measure([&] {
      CGAL::jet_smooth_point_set<CGAL::Sequential_tag>(points, k);
      return points.size();
    });
  } else if (method == "bilateral") {
    std::vector<Oriented> oriented;
    for (const auto& p : points) oriented.emplace_back(p, CGAL::NULL_VECTOR);
    const auto maps = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
                          .normal_map(CGAL::Second_of_pair_property_map<Oriented>());
    peers::measure([&] {
      CGAL::jet_estimate_normals<CGAL::Sequential_tag>(oriented, k, maps);
      CGAL::bilateral_smooth_point_set<CGAL::Sequential_tag>(oriented, k, maps);
      return oriented.size();
    });
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = oriented[i].first;
  } else if (method == "wlop") {
    std::vector<Kernel::Point_3> kept;
    peers::measure([&] {
      CGAL::wlop_simplify_and_regularize_point_set<CGAL::Sequential_tag>(
          points, std::back_inserter(kept), CGAL::parameters::select_percentage(50));
      return kept.size();
    });
    points = kept;
  } else {
    peers::fail("no such method: " + method);
  }
  peers::write_points(argv[3], points.size(), [&](std::size_t i) {
    return peers::Point{points[i].x(), points[i].y(), points[i].z()};
  });
  return 0;
}
