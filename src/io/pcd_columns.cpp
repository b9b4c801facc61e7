// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/pcd_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "io/bytes.hpp"
#include "io/colors.hpp"
#include "io/fields.hpp"
#include "io/scalar_type.hpp"
#include "io/strided.hpp"
#include "large_pages.hpp"

namespace deburr {
namespace {

/// Makes a column as long as is needed, where it is not yet: next to what will be written, which so
/// stays in the cache.
template <typename T>
void grow(std::vector<T>& values, std::size_t size) {
  if (values.size() < size) values.resize(size);
}

}  // namespace

PcdColumns::PcdColumns(const Source& source, const PcdHeader& header) : header_(header) {
  std::vector<std::string> names;
  names.reserve(header_.fields.size());
  for (const PcdField& field : header_.fields) {
    names.push_back(field.count == 1 ? field.name : "");
  }
  const std::vector<int> roles = find_roles(names);
  if (const std::string_view missing = missing_coordinate(roles); !missing.empty()) {
    source.fail(fmt::format("the file has no field '{}'", missing));
  }
  const std::size_t n = header_.points();
  reserve_large(cloud_.points, n);
  if (std::ranges::count(roles, 3) > 0) reserve_large(cloud_.normals, n);
  const bool colors_taken = std::ranges::any_of(header_.fields, [](const PcdField& field) {
    return std::ranges::find(color_names, field.name) != color_names.end();
  });
  for (std::size_t k = 0; k < roles.size(); ++k) {
    const PcdField& field = header_.fields[k];
    Target& target = targets_.emplace_back();
    const bool is_color = (field.name == "rgb" || field.name == "rgba") && field.count == 1 &&
                          size_of(field.type) == 4 && !colors_taken && !has_color_;
    if (field.is_padding()) continue;
    if (is_color) {
      add_colors(field, target);
      continue;
    }
    cloud_.layout.fields.push_back({field.name, field.type});
    if (roles[k] != no_role) {
      target.vectors = roles[k] < 3 ? &cloud_.points : &cloud_.normals;
      target.axis = axes[static_cast<std::size_t>(roles[k]) % 3];
      continue;
    }
    target.attribute = cloud_.attributes.size();
    Attribute attribute{field.name, room_for(field.type, n * field.count), {}};
    for (std::size_t i = 0; field.count > 1 && i <= n; ++i) {
      attribute.offsets.push_back(i * field.count);
    }
    attribute.length_type = field.count <= 0xff ? ScalarType::UInt8 : ScalarType::UInt32;
    cloud_.attributes.push_back(std::move(attribute));
  }
}

/// The four bytes of a colour, which other formats know by these names.
void PcdColumns::add_colors(const PcdField& field, Target& target) {
  has_color_ = true;
  target.is_color = true;
  target.attribute = cloud_.attributes.size();
  for (const char* name : color_names) {
    cloud_.layout.fields.push_back({name, ScalarType::UInt8});
    cloud_.attributes.push_back({name, room_for(ScalarType::UInt8, header_.points()), {}});
  }
  cloud_.layout.blocks.push_back({"PCD colour", field.name});
  has_alpha_ = field.name == "rgba";
}

void PcdColumns::take_colors(const Target& target, const char* data, std::size_t stride,
                             std::size_t begin, std::size_t end) {
  constexpr std::array<std::size_t, 4> places{2, 1, 0, 3};  // of red green blue alpha
  for (std::size_t k = 0; k < 4; ++k) {
    const char* from = data + places.at(k);
    auto& values =
        std::get<std::vector<std::uint8_t>>(cloud_.attributes[target.attribute + k].values);
    grow(values, end);
    std::uint8_t used = 0;
    std::uint8_t* const to = values.data();
    for (std::size_t i = begin; i < end; ++i, from += stride) {
      const auto value = static_cast<std::uint8_t>(*from);
      to[i] = value;
      used |= value;
    }
    if (k == 3) has_alpha_ = has_alpha_ || used != 0;
  }
}

void PcdColumns::take(std::size_t k, const char* data, std::size_t stride, std::size_t begin,
                      std::size_t end) {
  const PcdField& field = header_.fields[k];
  const Target& target = targets_[k];
  if (field.is_padding()) return;
  if (target.is_color) return take_colors(target, data, stride, begin, end);
  with_number_type(field.type, [&]<typename T>(std::type_identity<T>) {
    if (target.vectors != nullptr) {
      grow(*target.vectors, end);
      Vec3* const to = target.vectors->data();
      for (std::size_t i = begin; i < end; ++i, data += stride) {
        to[i].*target.axis = static_cast<double>(load_little<T>(data));
      }
      return;
    }
    auto& values = std::get<std::vector<T>>(cloud_.attributes[target.attribute].values);
    const std::size_t count = field.count;
    grow(values, end * count);
    T* to = values.data() + begin * count;
    if (count == 1) return gather(data, end - begin, stride, to);
    for (std::size_t i = begin; i < end; ++i, data += stride, to += count) {
      gather(data, count, sizeof(T), to);
    }
  });
}

void PcdColumns::take(std::size_t k, TextRow& row, std::size_t i) {
  const PcdField& field = header_.fields[k];
  const Target& target = targets_[k];
  if (field.is_padding()) {
    for (std::size_t j = 0; j < field.count; ++j) (void)row.word();
  } else if (target.vectors != nullptr) {
    grow(*target.vectors, i + 1);
    // The text is more exact than a declared type of float.
    (*target.vectors)[i].*target.axis = row.take<double>(field.name);
  } else {
    with_number_type(field.type, [&]<typename T>(std::type_identity<T>) {
      for (std::size_t j = 0; j < field.count; ++j) {
        const T value = row.take<T>(field.name);
        if (target.is_color) {
          char bytes[sizeof(T)];
          store_little(bytes, value);
          return take_colors(target, bytes, sizeof(T), i, i + 1);
        }
        auto& values = std::get<std::vector<T>>(cloud_.attributes[target.attribute].values);
        grow(values, (i + 1) * field.count);
        values[i * field.count + j] = value;
      }
    });
  }
}

/// Colours of 16 bits stand in fields of their own, behind their eight bits for other programs: see
/// PcdPlan. The latter say nothing more.
void PcdColumns::drop_repeated_colors() {
  const Colors colors = find_colors(cloud_);
  if (!colors.are_there() || colors.most[0] <= 255) return;
  const auto red = std::ranges::find(cloud_.attributes, "red", &Attribute::name);
  if (red == cloud_.attributes.begin()) return;
  const auto packed = red - 1;
  const auto* const values = std::get_if<std::vector<std::uint32_t>>(&packed->values);
  if (values == nullptr || packed->is_list()) return;
  if (packed->name != (colors.of[3] != nullptr ? "rgba" : "rgb")) return;
  std::vector<std::uint32_t> expected(values->size());
  colors.pack(0, expected.size(), expected.data());
  if (expected != *values) return;
  cloud_.layout.blocks.push_back({"PCD colour", packed->name});
  std::erase_if(cloud_.layout.fields, [&](const Field& f) { return f.name == packed->name; });
  cloud_.attributes.erase(packed);
}

PointCloud PcdColumns::finish() {
  if (has_color_ && !has_alpha_) {
    std::erase_if(cloud_.layout.fields, [](const Field& f) { return f.name == "alpha"; });
    std::erase_if(cloud_.attributes, [](const Attribute& a) { return a.name == "alpha"; });
  }
  if (!has_color_) drop_repeated_colors();
  return std::move(cloud_);
}

}  // namespace deburr
