// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
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

/// The corners of all faces one after the other; none if one of them is no point of the cloud or
/// no integer.
[[nodiscard]] std::optional<std::vector<std::uint32_t>> valid_corners(const Attribute& faces,
                                                                      std::size_t points);

}  // namespace deburr
