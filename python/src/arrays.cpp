// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "arrays.hpp"

#include <array>
#include <cstddef>

namespace deburr::python {
namespace {

template <typename Scalar>
void copy_strided(const AnyVectorArray& array, std::vector<Vec3>& to) {
  const auto* const first = static_cast<const Scalar*>(array.data());
  const std::ptrdiff_t row = array.stride(0);
  const std::ptrdiff_t column = array.stride(1);
  for (std::size_t i = 0; i < array.shape(0); ++i) {
    const Scalar* const p = first + static_cast<std::ptrdiff_t>(i) * row;
    to.push_back({static_cast<double>(p[0]), static_cast<double>(p[column]),
                  static_cast<double>(p[2 * column])});
  }
}

}  // namespace

std::vector<Vec3> copy_vectors(const AnyVectorArray& array) {
  std::vector<Vec3> vectors;
  vectors.reserve(array.shape(0));
  if (is_float32(array)) {
    copy_strided<float>(array, vectors);
  } else if (array.dtype() == nb::dtype<double>()) {
    copy_strided<double>(array, vectors);
  } else {
    throw nb::type_error("an array of float32 or float64 is needed");
  }
  return vectors;
}

TriangleMesh make_mesh(const VectorArray& vertices, const TriangleArray& triangles) {
  TriangleMesh mesh;
  const Points points = as_span(vertices);
  mesh.vertices.assign(points.begin(), points.end());
  mesh.triangles.reserve(triangles.shape(0));
  for (std::size_t i = 0; i < triangles.shape(0); ++i) {
    const std::uint32_t* const corner = triangles.data() + 3 * i;
    mesh.triangles.push_back({corner[0], corner[1], corner[2]});
  }
  return mesh;
}

nb::tuple mesh_to_python(TriangleMesh mesh) {
  const std::size_t count = mesh.triangles.size();
  auto [data, owner] = hand_over(std::move(mesh.triangles));
  static_assert(sizeof(std::array<std::uint32_t, 3>) == 3 * sizeof(std::uint32_t));
  nb::ndarray<nb::numpy, std::uint32_t, nb::shape<-1, 3>> triangles(
      reinterpret_cast<std::uint32_t*>(data), {count, 3}, owner);
  return nb::make_tuple(to_array(std::move(mesh.vertices)), triangles);
}

}  // namespace deburr::python
