// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/features.hpp"

#include <array>

#include "parallel.hpp"
#include "point_class.hpp"
#include "require.hpp"

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
  FeatureField field{std::vector<Feature>(points.size()), std::vector<Vec3>(points.size())};
  parallel_for(points.size(), execution, [&](std::size_t i) {
    const PointClass c = classify_point(i, points, normals, neighborhoods[i], options);
    field.label[i] = c.label;
    field.direction[i] = c.direction;
  });
  return field;
}

}  // namespace deburr
