// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace deburr {

/// A weight that is level near 0, a half at e = 0.83 and 0 from e = 3: nearly exp(-e^2), but of
/// products alone, whose bits no processor or library changes.
inline double flat_top(double e) {
  if (!(e < 3)) return 0;
  const double t = 1 - e * e / 9;
  const double t2 = t * t;
  const double t4 = t2 * t2;
  return t4 * t4;
}

/// How far a height may be from a surface that it is of.
inline double height_reach(double noise, double spacing) { return 3 * noise + 0.15 * spacing; }

/// Turn of a unit normal that makes it foreign.
inline constexpr double normal_reach = 0.5;

/// Share with which something belongs to a smooth surface.
/// @param turn  squared difference of its unit normal from that of the surface
/// @param off  distance from the surface, in parts of height_reach()
inline double belonging(double turn, double off) {
  return flat_top(turn / (normal_reach * normal_reach) + off * off);
}

}  // namespace deburr
