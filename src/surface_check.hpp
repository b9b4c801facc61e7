// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "deburr/mesh.hpp"

namespace deburr {

/// Refuses a surface that points cannot be measured against or drawn from.
/// @throws std::invalid_argument  for a mesh without triangles or with 2^32 or more, or with a
///                                corner that is no vertex or not finite
void check_surface(const TriangleMesh& surface);

}  // namespace deburr
