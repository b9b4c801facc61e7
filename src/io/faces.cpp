// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/faces.hpp"

#include <type_traits>
#include <utility>

namespace deburr {

const Attribute* find_faces(const FileLayout& layout) {
  for (const Element& element : layout.elements) {
    if (element.name != "face") continue;
    for (const Attribute& a : element.attributes) {
      if (a.is_list() && (a.name == "vertex_indices" || a.name == "vertex_index")) return &a;
    }
  }
  return nullptr;
}

Element make_faces(std::vector<std::int32_t> corners, std::vector<std::size_t> offsets) {
  const std::size_t count = offsets.size() - 1;
  return {"face",
          count,
          {{"vertex_indices", std::move(corners), std::move(offsets), ScalarType::UInt8}},
          false};
}

Faces valid_faces(const FileLayout& layout, std::size_t points) {
  Faces faces{find_faces(layout), {}};
  if (faces.attribute == nullptr) return faces;
  std::visit(
      [&]<typename T>(const std::vector<T>& values) {
        if constexpr (std::is_integral_v<T>) {
          faces.corners.reserve(values.size());
          for (const T value : values) {
            if (!std::in_range<std::uint32_t>(value) || std::cmp_greater_equal(value, points)) {
              faces.attribute = nullptr;
              return;
            }
            faces.corners.push_back(static_cast<std::uint32_t>(value));
          }
        } else {
          faces.attribute = nullptr;
        }
      },
      faces.attribute->values);
  return faces;
}

}  // namespace deburr
