// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "deburr/point_cloud.hpp"

namespace deburr {

inline constexpr Encoding all_encodings[] = {Encoding::PlyAscii, Encoding::PlyLittleEndian,
                                             Encoding::PlyBigEndian};
inline constexpr double inf = std::numeric_limits<double>::infinity();
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <typename T>
std::vector<T> extremes() {
  using Limits = std::numeric_limits<T>;
  if constexpr (std::is_floating_point_v<T>) {
    return {Limits::denorm_min(), Limits::lowest(),    Limits::max(),      T{1} / T{10}, -T(0),
            Limits::infinity(),   Limits::quiet_NaN(), -Limits::infinity()};
  } else {
    return {Limits::min(), Limits::max(), 0, 1, 2, 3, 4, 100};
  }
}

template <typename T>
void add_type(std::vector<Attribute>& to, const std::string& name, ScalarType length_type) {
  to.push_back({name, extremes<T>(), {}});
  to.push_back({name + "_list", extremes<T>(), {0, 0, 3, 3, 4, 8, 8, 8, 8}, length_type});
}

/// Eight items with a value and a list of every type.
inline std::vector<Attribute> every_type() {
  std::vector<Attribute> all;
  add_type<std::int8_t>(all, "i8", ScalarType::Int8);
  add_type<std::uint8_t>(all, "u8", ScalarType::UInt8);
  add_type<std::int16_t>(all, "i16", ScalarType::Int16);
  add_type<std::uint16_t>(all, "u16", ScalarType::UInt16);
  add_type<std::int32_t>(all, "i32", ScalarType::Int32);
  add_type<std::uint32_t>(all, "u32", ScalarType::UInt32);
  add_type<float>(all, "f32", ScalarType::UInt8);
  add_type<double>(all, "f64", ScalarType::UInt8);
  return all;
}

/// Eight points with everything that a PLY file can hold.
inline PointCloud full_cloud(Encoding encoding) {
  PointCloud cloud;
  const std::vector<double> values = extremes<double>();
  for (std::size_t i = 0; i < 8; ++i) {
    cloud.points.push_back({values[i], 500000.123456789, 0.1 * static_cast<double>(i)});
    const double outside[] = {nan, inf};
    cloud.normals.push_back({0, 0.5, outside[i % 2]});
  }
  cloud.attributes = every_type();
  cloud.layout.encoding = encoding;
  // Order is that of the file: here neither coordinates nor normals stand together.
  cloud.layout.fields = {{"nz", ScalarType::Float32}, {"y", ScalarType::Float64}};
  for (const Attribute& a : cloud.attributes) cloud.layout.fields.push_back({a.name, a.type()});
  for (const char* name : {"z", "x"}) cloud.layout.fields.push_back({name, ScalarType::Float64});
  for (const char* name : {"nx", "ny"}) cloud.layout.fields.push_back({name, ScalarType::Float32});
  cloud.layout.comments = {"made by hand", "", "two  blanks, and = marks"};
  cloud.layout.obj_info = {"num_cols 4", "num_rows 2"};
  cloud.layout.elements = {{"camera", 8, every_type(), true},
                           {"nothing", 5, {}, true},
                           {"face", 8, every_type(), false},
                           {"none", 0, {{"a", std::vector<float>{}, {}}}, false}};
  return cloud;
}

/// A file with the vertex properties and rows given, in ASCII.
inline std::string ascii(const std::string& properties, const std::string& rows, int count = 1) {
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(count) + "\n" + properties +
         "end_header\n" + rows;
}
inline std::string xyz() { return "property float x\nproperty float y\nproperty float z\n"; }

}  // namespace deburr
