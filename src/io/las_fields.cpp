// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/las_fields.hpp"

#include <array>

namespace deburr {
namespace {

constexpr std::array<LasField, 11> legacy_fields{
    {{"intensity", ScalarType::UInt16, 12, 0, 0},
     {"return_number", ScalarType::UInt8, 14, 0, 3},
     {"number_of_returns", ScalarType::UInt8, 14, 3, 3},
     {"scan_direction_flag", ScalarType::UInt8, 14, 6, 1},
     {"edge_of_flight_line", ScalarType::UInt8, 14, 7, 1},
     {"classification", ScalarType::UInt8, 15, 0, 5},
     {"synthetic", ScalarType::UInt8, 15, 5, 1},
     {"key_point", ScalarType::UInt8, 15, 6, 1},
     {"withheld", ScalarType::UInt8, 15, 7, 1},
     {"scan_angle_rank", ScalarType::Int8, 16, 0, 0},
     {"user_data", ScalarType::UInt8, 17, 0, 0}}};
constexpr std::size_t legacy_bytes = 18;

constexpr std::array<LasField, 13> modern_fields{
    {{"intensity", ScalarType::UInt16, 12, 0, 0},
     {"return_number", ScalarType::UInt8, 14, 0, 4},
     {"number_of_returns", ScalarType::UInt8, 14, 4, 4},
     {"synthetic", ScalarType::UInt8, 15, 0, 1},
     {"key_point", ScalarType::UInt8, 15, 1, 1},
     {"withheld", ScalarType::UInt8, 15, 2, 1},
     {"overlap", ScalarType::UInt8, 15, 3, 1},
     {"scanner_channel", ScalarType::UInt8, 15, 4, 2},
     {"scan_direction_flag", ScalarType::UInt8, 15, 6, 1},
     {"edge_of_flight_line", ScalarType::UInt8, 15, 7, 1},
     {"classification", ScalarType::UInt8, 16, 0, 0},
     {"user_data", ScalarType::UInt8, 17, 0, 0},
     {"scan_angle", ScalarType::Int16, 18, 0, 0}}};
constexpr std::size_t modern_bytes = 20;

struct Part {
  bool time;
  bool color;
  bool infrared;
  bool wave;
};

constexpr std::array<Part, las_last_format + 1> parts{{{false, false, false, false},
                                                       {true, false, false, false},
                                                       {false, true, false, false},
                                                       {true, true, false, false},
                                                       {true, false, false, true},
                                                       {true, true, false, true},
                                                       {true, false, false, false},
                                                       {true, true, false, false},
                                                       {true, true, true, false},
                                                       {true, false, false, true},
                                                       {true, true, true, true}}};

/// Puts fields one behind the other.
class FieldList {
 public:
  FieldList(std::vector<LasField> fields, std::size_t bytes)
      : fields_(std::move(fields)), bytes_(bytes) {}

  void add(std::string_view name, ScalarType type, std::size_t size) {
    fields_.push_back({name, type, bytes_, 0, 0});
    bytes_ += size;
  }

  std::vector<LasField> fields_;
  std::size_t bytes_;
};

FieldList list_of(unsigned format) {
  const bool is_modern = format >= las_first_modern_format;
  FieldList list = is_modern
                       ? FieldList({modern_fields.begin(), modern_fields.end()}, modern_bytes)
                       : FieldList({legacy_fields.begin(), legacy_fields.end()}, legacy_bytes);
  const Part& part = parts.at(format);
  list.add("point_source_id", ScalarType::UInt16, 2);
  if (part.time) list.add("gps_time", ScalarType::Float64, 8);
  if (part.color) {
    for (const char* name : {"red", "green", "blue"}) list.add(name, ScalarType::UInt16, 2);
  }
  if (part.infrared) list.add("nir", ScalarType::UInt16, 2);
  if (part.wave) {
    list.add("wavepacket_index", ScalarType::UInt8, 1);
    list.add("wavepacket_offset", ScalarType::UInt64, 8);
    list.add("wavepacket_size", ScalarType::UInt32, 4);
    list.add("return_point_wave_location", ScalarType::Float32, 4);
    for (const char* name : {"x_t", "y_t", "z_t"}) list.add(name, ScalarType::Float32, 4);
  }
  return list;
}

}  // namespace

std::vector<LasField> las_fields(unsigned format) { return list_of(format).fields_; }

std::size_t las_point_bytes(unsigned format) { return list_of(format).bytes_; }

}  // namespace deburr
