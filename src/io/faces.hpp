// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "deburr/point_cloud.hpp"

// The faces of a mesh, an element of the layout as PLY has it.

namespace deburr {

/// The indices of the corners of each face, or null.
[[nodiscard]] const Attribute* find_faces(const FileLayout& layout);

/// Faces with their corners, ready for a layout.
[[nodiscard]] Element make_faces(std::vector<std::int32_t> corners,
                                 std::vector<std::size_t> offsets);

/// Faces as writers want them.
struct Faces {
  const Attribute* attribute = nullptr;  ///< null if there are none that can be written
  std::vector<std::uint32_t> corners;    ///< of all faces, one after the other

  [[nodiscard]] std::size_t size() const {
    return attribute != nullptr ? attribute->offsets.size() - 1 : 0;
  }
  /// The corners of one face.
  [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t face) const {
    const std::size_t begin = attribute->offsets[face];
    return {corners.data() + begin, attribute->offsets[face + 1] - begin};
  }
};

/// The faces of a layout; none if a corner is no point of the cloud or no integer.
[[nodiscard]] Faces valid_faces(const FileLayout& layout, std::size_t points);

}  // namespace deburr
