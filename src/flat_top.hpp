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

}  // namespace deburr
