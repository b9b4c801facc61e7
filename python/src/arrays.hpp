// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "deburr/features.hpp"
#include "deburr/mesh.hpp"
#include "deburr/vec3.hpp"

// Between NumPy's arrays and those of the library. The Python side sees to types and shapes, so
// that nothing is converted here without being seen.

namespace deburr::python {

namespace nb = nanobind;

using VectorArray = nb::ndarray<const double, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;
/// Of float or double, with any strides.
using AnyVectorArray = nb::ndarray<nb::ro, nb::shape<-1, 3>, nb::device::cpu>;
template <typename Value>
using ValueArray = nb::ndarray<const Value, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using TriangleArray =
    nb::ndarray<const std::uint32_t, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;

using NewVectors = nb::ndarray<nb::numpy, double, nb::shape<-1, 3>>;
template <typename Value>
using NewValues = nb::ndarray<nb::numpy, Value, nb::ndim<1>>;

/// The same memory as a span of vectors.
inline Points as_span(const VectorArray& array) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  return {reinterpret_cast<const Vec3*>(array.data()), array.shape(0)};
}

template <typename Value>
std::span<const Value> as_span(const ValueArray<Value>& array) {
  return {array.data(), array.shape(0)};
}

inline std::span<const Feature> as_features(const ValueArray<std::uint8_t>& labels) {
  static_assert(sizeof(Feature) == 1);
  return {reinterpret_cast<const Feature*>(labels.data()), labels.shape(0)};
}

/// The one copy that denoise() needs.
[[nodiscard]] std::vector<Vec3> copy_vectors(const AnyVectorArray& array);

/// Whether an array holds 32-bit floats.
[[nodiscard]] inline bool is_float32(const AnyVectorArray& array) {
  return array.dtype() == nb::dtype<float>();
}

/// Keeps the memory of a vector alive for as long as the array that is made of it.
template <typename Value>
std::pair<Value*, nb::capsule> hand_over(std::vector<Value> values) {
  auto kept = std::make_unique<std::vector<Value>>(std::move(values));
  Value* const data = kept->data();
  nb::capsule owner(kept.get(),
                    [](void* p) noexcept { delete static_cast<std::vector<Value>*>(p); });
  (void)kept.release();
  return {data, std::move(owner)};
}

/// Arrays that own what was in the vector, without a copy.
inline NewVectors to_array(std::vector<Vec3> vectors) {
  const std::size_t size = vectors.size();
  auto [data, owner] = hand_over(std::move(vectors));
  return {reinterpret_cast<double*>(data), {size, 3}, owner};
}

template <typename Value>
NewValues<Value> to_array(std::vector<Value> values) {
  const std::size_t size = values.size();
  auto [data, owner] = hand_over(std::move(values));
  return {data, {size}, owner};
}

inline NewValues<std::uint8_t> to_array(std::vector<Feature> labels) {
  const std::size_t size = labels.size();
  auto [data, owner] = hand_over(std::move(labels));
  return {reinterpret_cast<std::uint8_t*>(data), {size}, owner};
}

/// The mesh of two arrays; copies them.
[[nodiscard]] TriangleMesh make_mesh(const VectorArray& vertices, const TriangleArray& triangles);

/// (vertices, triangles)
[[nodiscard]] nb::tuple mesh_to_python(TriangleMesh mesh);

}  // namespace deburr::python
