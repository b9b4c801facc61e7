// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/features.hpp"

#include <algorithm>
#include <array>

#include "parallel.hpp"
#include "point_class.hpp"
#include "require.hpp"
#include "rows.hpp"

namespace deburr {

std::string_view to_string(Feature feature) {
  constexpr std::array<std::string_view, 4> names{"surface", "edge", "corner", "isolated"};
  return names.at(static_cast<std::size_t>(feature));
}

FeatureField classify_features(Points points, Normals normals, const Neighborhoods& neighborhoods,
                               const FeatureOptions& options, const Execution& execution) {
  require_size("normals", normals.size(), points.size());
  require_size("neighborhoods", neighborhoods.size(), points.size());
  validate(options);
  const std::vector<Row> point_rows = make_rows(points, execution);
  const std::vector<Row> normal_rows = make_rows(normals, execution);
  const Oriented cloud{point_rows.data(), normal_rows.data()};
  FeatureField field{std::vector<Feature>(points.size()), std::vector<Vec3>(points.size())};
  parallel_blocks(points.size(), execution, [&](std::size_t begin, std::size_t end) {
    Moments moments;
    PointClasses classes;
    for (std::size_t from = begin; from < end; from += lane_count) {
      const std::size_t count = std::min(lane_count, end - from);
      for (std::size_t l = 0; l < count; ++l) {
        add_moments(from + l, cloud, neighborhoods[from + l], options.rho, l, moments);
      }
      classify_points(moments, options, classes);
      for (std::size_t l = 0; l < count; ++l) {
        field.label[from + l] = classes[l].label;
        field.direction[from + l] = classes[l].direction;
      }
    }
  });
  return field;
}

}  // namespace deburr
