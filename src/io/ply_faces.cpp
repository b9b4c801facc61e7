// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <type_traits>
#include <utility>

#include "io/lines.hpp"
#include "io/ply_body.hpp"
#include "io/scalar_type.hpp"

namespace deburr {
namespace {

/// Line or byte at which an item of an element begins.
std::string place_of(const Source& source, Encoding encoding, const PlyPlace& start,
                     const Element& element, std::size_t item) {
  if (encoding == Encoding::PlyAscii) {
    Lines lines(source.data, start.offset, start.line);
    for (std::size_t i = 0; i <= item; ++i) (void)lines.next_full();
    return fmt::format("line {}", lines.number());
  }
  std::size_t offset = start.offset;
  for (const Attribute& a : element.attributes) {
    const std::size_t values = a.is_list() ? a.offsets[item] : item;
    offset += values * size_of(a.type()) + (a.is_list() ? item * size_of(a.length_type) : 0);
  }
  return fmt::format("byte {}", offset);
}

}  // namespace

void check_faces(const Source& source, Encoding encoding, const PlyPlace& start,
                 const Element& element, std::size_t vertices) {
  if (element.name != "face") return;
  for (const Attribute& a : element.attributes) {
    if (!a.is_list() || (a.name != "vertex_indices" && a.name != "vertex_index")) continue;
    std::visit(
        [&]<typename T>(const std::vector<T>& values) {
          if constexpr (std::is_integral_v<T>) {
            const auto bad = std::ranges::find_if(values, [&](T corner) {
              return std::cmp_less(corner, 0) || std::cmp_greater_equal(corner, vertices);
            });
            if (bad == values.end()) return;
            const auto at = static_cast<std::size_t>(bad - values.begin());
            const auto next = std::ranges::upper_bound(a.offsets, at);
            const auto face = static_cast<std::size_t>(next - a.offsets.begin()) - 1;
            source.fail(fmt::format("{}: face {} has vertex {}, but there are {} vertices",
                                    place_of(source, encoding, start, element, face), face + 1,
                                    *bad, vertices));
          }
        },
        a.values);
  }
}

}  // namespace deburr
