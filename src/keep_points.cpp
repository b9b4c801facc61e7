// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "keep_points.hpp"

#include <algorithm>
#include <span>
#include <type_traits>
#include <utility>

namespace deburr {
namespace {

using Mask = std::span<const std::uint8_t>;  ///< 1 for what goes

template <typename Value>
void erase_marked(std::vector<Value>& values, Mask mask) {
  std::size_t to = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (mask[i] != 0) continue;
    if (to != i) values[to] = std::move(values[i]);
    ++to;
  }
  values.resize(to);
}

void erase_marked(Attribute& attribute, Mask mask) {
  std::visit(
      [&](auto& values) {
        if (!attribute.is_list()) {
          erase_marked(values, mask);
          return;
        }
        std::vector<std::size_t> offsets{0};
        std::size_t to = 0;
        for (std::size_t i = 0; i < mask.size(); ++i) {
          if (mask[i] != 0) continue;
          for (std::size_t k = attribute.offsets[i]; k < attribute.offsets[i + 1]; ++k, ++to) {
            if (to != k) values[to] = std::move(values[k]);
          }
          offsets.push_back(to);
        }
        values.resize(to);
        attribute.offsets = std::move(offsets);
      },
      attribute.values);
}

/// The attributes of an element that are numbers of points: corners of faces, ends of edges. Empty
/// where it is not known which they are.
std::vector<Attribute*> references(Element& element) {
  std::vector<Attribute*> found;
  for (Attribute& a : element.attributes) {
    const bool is_corner = element.name == "face" && a.is_list() &&
                           (a.name == "vertex_indices" || a.name == "vertex_index");
    const bool is_end =
        element.name == "edge" && !a.is_list() && (a.name == "vertex1" || a.name == "vertex2");
    if (!is_corner && !is_end) continue;
    if (a.type() > ScalarType::UInt64) return {};
    found.push_back(&a);
  }
  const bool complete = element.name == "edge" ? found.size() == 2 : found.size() == 1;
  return complete ? found : std::vector<Attribute*>{};
}

/// Puts in the new numbers of the points, and marks those items of which a point goes, or that
/// refer to none.
void renumber(Attribute& attribute, Mask mask, const std::vector<std::size_t>& numbers,
              std::vector<std::uint8_t>& items) {
  std::visit(
      [&]<typename T>(std::vector<T>& values) {
        if constexpr (std::is_integral_v<T>) {
          for (std::size_t item = 0; item < items.size(); ++item) {
            const std::size_t begin = attribute.is_list() ? attribute.offsets[item] : item;
            const std::size_t end = attribute.is_list() ? attribute.offsets[item + 1] : item + 1;
            for (std::size_t k = begin; k < end; ++k) {
              const bool stays = std::cmp_greater_equal(values[k], 0) &&
                                 std::cmp_less(values[k], mask.size()) &&
                                 mask[static_cast<std::size_t>(values[k])] == 0;
              if (stays) {
                values[k] = static_cast<T>(numbers[static_cast<std::size_t>(values[k])]);
              } else {
                items[item] = 1;
              }
            }
          }
        }
      },
      attribute.values);
}

/// Leaves what refers to points that stay.
void keep_elements(std::vector<Element>& elements, Mask mask) {
  std::vector<std::size_t> numbers(mask.size());  // of those that stay
  for (std::size_t i = 0, next = 0; i < mask.size(); ++i) numbers[i] = mask[i] == 0 ? next++ : 0;
  std::erase_if(elements, [](Element& element) { return references(element).empty(); });
  for (Element& element : elements) {
    std::vector<std::uint8_t> items(element.size);
    for (Attribute* attribute : references(element)) renumber(*attribute, mask, numbers, items);
    for (Attribute& attribute : element.attributes) erase_marked(attribute, items);
    element.size = static_cast<std::size_t>(std::ranges::count(items, 0));
  }
}

}  // namespace

void remove_outliers(DenoiseResult& result) {
  const std::vector<std::uint8_t> mask = std::exchange(result.outliers, {});
  PointCloud& cloud = result.cloud;
  erase_marked(cloud.points, mask);
  if (!cloud.normals.empty()) erase_marked(cloud.normals, mask);
  for (Attribute& attribute : cloud.attributes) erase_marked(attribute, mask);
  keep_elements(cloud.layout.elements, mask);
  erase_marked(result.labels, mask);
  erase_marked(result.displacement, mask);
  result.outliers.assign(cloud.size(), 0);
}

}  // namespace deburr
