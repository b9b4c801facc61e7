// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "deburr/vec3.hpp"

namespace deburr {

/// How far points lie from their own places without noise, along the true normals. What slides
/// along the surface does not count.
struct OffsetError {
  double mean = 0;        ///< mean signed offset, > 0 on the side that normals point to
  double rms = 0;         ///< root of the mean squared offset
  double far_share = 0;   ///< share of the points whose offset is larger than `far`, either way
  std::size_t count = 0;  ///< points measured; where there are none, all of these are zero
};

/// Compares points with the same ones without noise: a mean that is not zero tells that the surface
/// shrank or grew, far points that some went to another sheet of it.
///
/// Left out are points that are not finite in either cloud, and normals that are zero or not finite
/// (their length is of no matter).
/// @param clean    the points without noise, in the same order
/// @param normals  true normals, one per point
/// @param far      > 0, in the unit of the input; infinite if of no interest
/// @throws std::invalid_argument  if sizes differ, or for `far` out of its range
[[nodiscard]] OffsetError offset_error(Points points, Points clean, Normals normals, double far);

/// How well flags match the true outliers.
struct OutlierScore {
  double precision = 0;      ///< of the flagged points, those that are outliers; NaN without any
  double recall = 0;         ///< of the outliers, those that are flagged; NaN without any
  std::size_t flagged = 0;   ///< points flagged
  std::size_t outliers = 0;  ///< true ones
};

/// Compares flags with the truth; anything but 0 is a flag.
/// @throws std::invalid_argument  if sizes differ
[[nodiscard]] OutlierScore score_outliers(std::span<const std::uint8_t> flags,
                                          std::span<const std::uint8_t> truth);

}  // namespace deburr
