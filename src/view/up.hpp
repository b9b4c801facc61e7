// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "deburr/vec3.hpp"

// Which way is up, for pictures. The page has the same table in viewer/src/scene/up.ts.

namespace deburr::view {

/// The axis of a file that points up.
enum class Up { Z, Y, X, MinusZ, MinusY, MinusX };

/// What somebody sees who stands in front of a thing: directions of length 1, right x forward = up.
struct UpFrame {
  Vec3 right;
  Vec3 forward;  ///< away from the viewer
  Vec3 up;
};

/// The front is where programs with this axis have it: along y where z is up, along -z where y is
/// up, along z where y points down, as in the frame of a camera.
[[nodiscard]] UpFrame frame_of(Up up);

/// "z", "-z" and so on.
[[nodiscard]] std::string_view to_string(Up up);

}  // namespace deburr::view
