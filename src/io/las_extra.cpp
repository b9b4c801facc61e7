// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/las_extra.hpp"

#include <algorithm>
#include <cmath>

#include "io/bytes.hpp"
#include "io/scalar_type.hpp"

namespace deburr {
namespace {

/// Types of the specification from 1 on.
constexpr std::array<ScalarType, 10> types{
    ScalarType::UInt8,   ScalarType::Int8,   ScalarType::UInt16, ScalarType::Int16,
    ScalarType::UInt32,  ScalarType::Int32,  ScalarType::UInt64, ScalarType::Int64,
    ScalarType::Float32, ScalarType::Float64};

constexpr std::size_t type_at = 2;
constexpr std::size_t options_at = 3;
constexpr std::size_t name_at = 4;
constexpr std::size_t scale_at = 112;
constexpr std::size_t offset_at = 136;
constexpr unsigned has_scale = 8;
constexpr unsigned has_offset = 16;

LasExtra parse_one(std::string_view descriptor) {
  LasExtra extra;
  extra.descriptor = descriptor;
  extra.name = padded_text(descriptor.substr(name_at, 32));
  if (extra.name.empty()) extra.name = "extra";
  const unsigned type = load_little<std::uint8_t>(descriptor, type_at);
  const unsigned options = load_little<std::uint8_t>(descriptor, options_at);
  if (type == 0 || type > 3 * types.size()) {
    extra.count = options;  // so many bytes
    return extra;
  }
  extra.type = types.at((type - 1) % types.size());
  extra.count = 1 + (type - 1) / types.size();
  extra.is_scaled = (options & (has_scale | has_offset)) != 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if ((options & has_scale) != 0)
      extra.scale[k] = load_little<double>(descriptor, scale_at + 8 * k);
    if ((options & has_offset) != 0) {
      extra.offset[k] = load_little<double>(descriptor, offset_at + 8 * k);
    }
  }
  extra.is_scaled = extra.is_scaled && is_integer_type(extra.type);
  // Such numbers tell nothing.
  for (std::size_t k = 0; k < extra.count; ++k) {
    if (!std::isfinite(extra.scale[k]) || extra.scale[k] == 0 || !std::isfinite(extra.offset[k])) {
      extra.is_scaled = false;
    }
  }
  return extra;
}

}  // namespace

std::size_t LasExtra::bytes() const { return count * size_of(type); }

std::vector<LasExtra> parse_las_extras(std::string_view descriptors, std::size_t size) {
  std::vector<LasExtra> extras;
  while (descriptors.size() >= las_descriptor_bytes) {
    LasExtra extra = parse_one(descriptors.substr(0, las_descriptor_bytes));
    descriptors.remove_prefix(las_descriptor_bytes);
    if (extra.count == 0) continue;
    if (extra.bytes() > size) break;
    size -= extra.bytes();
    extras.push_back(std::move(extra));
  }
  if (size > 0) {
    LasExtra rest;
    rest.name = las_undocumented;
    rest.count = size;
    extras.push_back(std::move(rest));
  }
  return extras;
}

LasExtra make_las_extra(const std::string& name, ScalarType type) {
  LasExtra extra;
  extra.name = name;
  extra.type = type;
  extra.descriptor.assign(las_descriptor_bytes, '\0');
  const auto code = std::ranges::find(types, type) - types.begin() + 1;
  extra.descriptor[type_at] = static_cast<char>(code);
  extra.descriptor.replace(name_at, 32, padded(name, 32));
  return extra;
}

}  // namespace deburr
