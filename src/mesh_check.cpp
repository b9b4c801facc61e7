// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh_check.hpp"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>

namespace deburr {

void require_surface(const TriangleMesh& surface) {
  if (surface.triangles.empty()) throw std::invalid_argument("surface has no triangles");
  if (surface.triangles.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw std::invalid_argument(fmt::format("surface must have fewer than 2^32 triangles, got {}",
                                            surface.triangles.size()));
  }
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    for (const std::uint32_t corner : surface.triangles[i]) {
      if (corner >= surface.vertices.size()) {
        throw std::invalid_argument(
            fmt::format("surface.triangles[{}] has corner {} of {} vertices", i, corner,
                        surface.vertices.size()));
      }
      if (!is_finite(surface.vertices[corner])) {
        throw std::invalid_argument(fmt::format("surface.vertices[{}] is not finite", corner));
      }
    }
  }
}

}  // namespace deburr
