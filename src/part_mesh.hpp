// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "deburr/mesh.hpp"

namespace deburr {

/// Points on a full circle of the part, a power of two. The chords of its largest circle stay
/// within 1e-3 mm of the arc.
inline constexpr std::uint32_t circle_points = 256;

/// The machined part of synthesize_part: 100 x 60 x 40 mm with one corner of its bounding box at
/// the origin, as described in docs/synth.md. Closed, every edge between exactly two triangles,
/// which run counterclockwise seen from outside. The same bits on every machine.
[[nodiscard]] TriangleMesh part_mesh();

}  // namespace deburr
