// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/colors.hpp"

#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>

#include "io/scalar_type.hpp"

namespace deburr {
namespace {

constexpr unsigned most_byte = 255;
constexpr unsigned most_word = 65535;

const Attribute* find(const PointCloud& cloud, const char* name) {
  const auto found = std::ranges::find(cloud.attributes, name, &Attribute::name);
  const bool usable =
      found != cloud.attributes.end() && !found->is_list() && found->type() != ScalarType::Text;
  return usable ? &*found : nullptr;
}

/// 255 or 65535, whatever holds all values; none for values beyond that, 0 for real numbers.
std::optional<unsigned> most_of(const Attribute& attribute) {
  return std::visit(
      []<typename T>(const std::vector<T>& values) -> std::optional<unsigned> {
        if constexpr (!std::is_integral_v<T>) return 0;
        if constexpr (std::is_integral_v<T>) {
          if (values.empty()) return most_byte;
          const auto [low, high] = std::ranges::minmax(values);
          if (std::cmp_less(low, 0) || std::cmp_greater(high, most_word)) return std::nullopt;
          return std::cmp_greater(high, most_byte) ? most_word : most_byte;
        }
      },
      attribute.values);
}

/// Where values of colours or of alpha, but not of both, need 16 bits: then both are of 16 bits, as
/// far as types say no other.
Colors with_other_alpha(Colors colors) {
  const auto is_wide = [](const Attribute* a) { return size_of(a->type()) > 1; };
  if (colors.most[0] > most_byte) {
    if (is_wide(colors.of[3])) colors.most[3] = most_word;
  } else if (std::all_of(colors.of.begin(), colors.of.begin() + 3, is_wide)) {
    std::fill_n(colors.most.begin(), 3, most_word);
  } else {
    colors.of[3] = nullptr;
  }
  return colors;
}

}  // namespace

void Colors::pack(std::size_t begin, std::size_t end, std::uint32_t* to) const {
  constexpr std::array<unsigned, 4> shifts{16, 8, 0, 24};
  std::fill_n(to, end - begin, 0U);
  for (std::size_t k = 0; k < count(); ++k) {
    const unsigned shift = shifts.at(k);
    const unsigned step = std::max(1U, most.at(k) / most_byte);  // 1 or 257
    std::visit(
        [&]<typename T>(const std::vector<T>& values) {
          if constexpr (std::is_integral_v<T>) {
            const T* const from = values.data() + begin;
            const std::size_t n = end - begin;
            for (std::size_t i = 0; i < n && step == 1; ++i) {
              to[i] |= static_cast<unsigned>(from[i]) << shift;
            }
            for (std::size_t i = 0; i < n && step > 1; ++i) {
              to[i] |= (static_cast<unsigned>(from[i]) + step / 2) / step << shift;
            }
          }
        },
        of.at(k)->values);
  }
}

Colors find_colors(const PointCloud& cloud) {
  Colors colors;
  for (std::size_t k = 0; k < 4; ++k) {
    const Attribute* const attribute = find(cloud, color_names.at(k));
    const std::optional<unsigned> most = attribute != nullptr ? most_of(*attribute) : std::nullopt;
    const bool same_kind = most && (k == 0 || (*most == 0) == (colors.most[0] == 0));
    if (!same_kind) {
      if (k == 3) break;
      return {};
    }
    colors.of.at(k) = attribute;
    colors.most.at(k) = *most;
    if (k == 3 && *most != colors.most[0]) return with_other_alpha(colors);
    if (k == 2) {
      const unsigned together = std::ranges::max({colors.most[0], colors.most[1], *most});
      std::fill_n(colors.most.begin(), 3, together);
    }
  }
  return colors;
}

}  // namespace deburr
