// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "deburr/mesh.hpp"

namespace deburr {

/// @throws std::invalid_argument  for a mesh without triangles, or with too many for 32 bits, or
///                                with a corner that is no vertex or not finite
void require_surface(const TriangleMesh& surface);

}  // namespace deburr
