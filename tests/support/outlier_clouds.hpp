// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "box.hpp"
#include "support/shapes.hpp"

namespace deburr {

/// A cloud and which of its points do not belong to the surface.
struct Spoiled {
  std::vector<Vec3> points;
  std::vector<std::uint8_t> outlier;
};

/// Adds 5 % of the number of points as uniform outliers in twice their box, and 2 % in balls of 40
/// points with a radius of 1.5 spacings, at least 6 spacings and 5 sigma off the surface.
template <typename Distance>
Spoiled spoil(const std::vector<Vec3>& surface, double spacing, double sigma, unsigned seed,
              const Distance& distance) {
  Spoiled cloud{with_noise(surface, sigma, seed), std::vector<std::uint8_t>(surface.size())};
  const Box box = bounding_box(surface);
  Random random(seed + 1);
  const auto draw = [&] {
    const double x = 4 * random.uniform() - 2;
    const double y = 4 * random.uniform() - 2;
    const double z = 4 * random.uniform() - 2;
    const Vec3 half = half_extent(box);
    return middle(box) + Vec3{x * half.x, y * half.y, z * half.z};
  };
  for (std::size_t i = 0; i < surface.size() / 20; ++i) cloud.points.push_back(draw());
  for (std::size_t ball = 0; ball < surface.size() / 2000; ++ball) {
    Vec3 center = draw();
    while (distance(center) < 6 * spacing + 5 * sigma) center = draw();
    for (const Vec3& d : random_directions(40, seed + 2 + static_cast<unsigned>(ball))) {
      cloud.points.push_back(center + 1.5 * spacing * std::cbrt(random.uniform()) * d);
    }
  }
  cloud.outlier.resize(cloud.points.size(), 1);
  return cloud;
}

/// How well flags agree with the truth.
struct Agreement {
  double recall = 0;     ///< share of the outliers that are flagged
  double precision = 0;  ///< share of the flagged points that are outliers
};

inline Agreement agreement(const std::vector<std::uint8_t>& flags,
                           const std::vector<std::uint8_t>& outlier) {
  double both = 0;
  double flagged = 0;
  double outliers = 0;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    both += flags[i] != 0 && outlier[i] != 0 ? 1 : 0;
    flagged += flags[i] != 0 ? 1 : 0;
    outliers += outlier[i] != 0 ? 1 : 0;
  }
  return {both / outliers, both / flagged};
}

inline double share_flagged(const std::vector<std::uint8_t>& flags) {
  double flagged = 0;
  for (const std::uint8_t f : flags) flagged += f != 0 ? 1 : 0;
  return flagged / static_cast<double>(flags.size());
}

}  // namespace deburr
