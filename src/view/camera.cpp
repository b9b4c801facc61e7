// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "view/raster.hpp"

namespace deburr::view {
namespace {

constexpr double left_out = 0.001;  // of the points, at each side
constexpr double margin = 1.06;

/// Towards the viewer: to the right, away from the front, and up.
Vec3 direction_of(View view) {
  switch (view) {
    case View::Iso:
      return {1, -1.6, 1};
    case View::Front:
      return {0, -1, 0};
    case View::Back:
      return {0, 1, 0};
    case View::Left:
      return {-1, 0, 0};
    case View::Right:
      return {1, 0, 0};
    case View::Top:
      return {0, 0, 1};
    case View::Bottom:
      return {0, 0, -1};
  }
  return {0, 0, 1};
}

Vec3 unit(const Vec3& v) { return (1 / norm(v)) * v; }

struct Range {
  double low = 0;
  double high = 0;
};

/// Of nearly all of the values, which are reordered.
Range robust_range(std::vector<double>& values) {
  if (values.empty()) return {};
  const auto skip = static_cast<std::ptrdiff_t>(left_out * static_cast<double>(values.size()));
  const auto low = values.begin() + skip;
  std::ranges::nth_element(values, low);
  const auto high = values.end() - 1 - skip;
  Range range{*low, 0};
  std::ranges::nth_element(values, high);
  range.high = *high;
  return range;
}

}  // namespace

Camera Camera::fit(View view, Points points, int width, int height, Up up) {
  Camera camera;
  const UpFrame frame = frame_of(up);
  const Vec3 towards = unit(direction_of(view));
  camera.towards = towards.x * frame.right + towards.y * frame.forward + towards.z * frame.up;
  const bool along_height = std::abs(towards.z) > 0.999;
  const Vec3 upwards = along_height ? frame.forward : frame.up;
  camera.right = unit(cross(upwards, camera.towards));
  camera.up = cross(camera.towards, camera.right);

  const auto along = [&](const Vec3& axis) {
    std::vector<double> values;
    for (const Vec3& p : points) {
      if (is_finite(p)) values.push_back(dot(p, axis));
    }
    return robust_range(values);
  };
  const Range x = along(camera.right);
  const Range y = along(camera.up);
  const Range z = along(camera.towards);
  const auto middle = [](const Range& range) { return 0.5 * range.low + 0.5 * range.high; };
  camera.centre = middle(x) * camera.right + middle(y) * camera.up + middle(z) * camera.towards;
  const double needed = margin * std::max((x.high - x.low) / width, (y.high - y.low) / height);
  camera.scale = needed > 0 ? 1 / needed : 1;
  return camera;
}

}  // namespace deburr::view
