// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "random.hpp"
#include "sheet.hpp"
#include "unit.hpp"

namespace deburr {

/// In a cube of side 2 around 0.
inline Vec3 random_place(Random& random) {
  const double x = 2 * random.uniform() - 1;
  const double y = 2 * random.uniform() - 1;
  return {x, y, 2 * random.uniform() - 1};
}

/// A valid sheet near z = 0, sloped and bent by a few tenths over its radius, about `reach` long
/// like that; its height at the origin may be that much too.
/// @param unit  of its lengths
inline Sheet random_sheet(Random& random, double reach, double unit) {
  Sheet sheet;
  const Vec3 at = random_place(random);
  const Vec3 lean = 0.2 * random_place(random);
  sheet.radius = reach * unit * (1 + random.uniform());
  sheet.frame = frame_along(unit * Vec3{reach * at.x, reach * at.y, 0.1 * at.z},
                            deburr::unit(lean + Vec3{0, 0, 1}));
  for (double& c : sheet.height.c) c = 0.3 * (2 * random.uniform() - 1);
  sheet.height.c[0] *= unit;
  for (std::size_t k = 3; k < 6; ++k) sheet.height.c[k] /= sheet.radius;
  sheet.variance = unit * unit * (0.01 + 0.1 * random.uniform());
  sheet.valid = true;
  return sheet;
}

}  // namespace deburr
