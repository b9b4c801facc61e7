// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "deburr/point_cloud.hpp"
#include "io/source.hpp"

// Header and records of a LAS file: LAS Specification 1.4 R15, tables 2 to 7, and 1.0 to 1.3.

namespace deburr {

/// Places in the public header block.
namespace las_at {
inline constexpr std::size_t minor = 25;
inline constexpr std::size_t software = 58;
inline constexpr std::size_t header_size = 94;
inline constexpr std::size_t point_offset = 96;
inline constexpr std::size_t record_count = 100;
inline constexpr std::size_t format = 104;
inline constexpr std::size_t point_bytes = 105;
inline constexpr std::size_t points = 107;
inline constexpr std::size_t returns = 111;
inline constexpr std::size_t scale = 131;
inline constexpr std::size_t offset = 155;
inline constexpr std::size_t box = 179;
inline constexpr std::size_t waveforms = 227;
inline constexpr std::size_t extended_start = 235;
inline constexpr std::size_t extended_count = 243;
inline constexpr std::size_t points_64 = 247;
inline constexpr std::size_t returns_64 = 255;
}  // namespace las_at

/// Size of the public header block of version 1.`minor`.
[[nodiscard]] std::size_t las_header_size(unsigned minor);

/// How integers become coordinates: x = X scale + offset.
struct LasGrid {
  std::array<double, 3> scale{};
  std::array<double, 3> offset{};
};

/// A variable length record, with its own header in front as in the file.
struct LasRecord {
  std::string bytes;
  bool is_extended = false;

  [[nodiscard]] std::string_view user() const;
  [[nodiscard]] std::uint16_t id() const;
  [[nodiscard]] std::string_view description() const;
  [[nodiscard]] std::string_view data() const;
  [[nodiscard]] bool is(std::string_view user_id, std::uint16_t record_id) const {
    return user() == user_id && id() == record_id;
  }
  /// As a block of a layout.
  [[nodiscard]] std::string name() const;
};

[[nodiscard]] LasRecord make_las_record(std::string_view user, std::uint16_t id,
                                        std::string_view description, std::string_view data);

inline constexpr std::string_view las_spec = "LASF_Spec";
inline constexpr std::uint16_t las_text_id = 3;
inline constexpr std::uint16_t las_extra_id = 4;
inline constexpr std::uint16_t las_waveform_id = 65535;
/// All descriptions of extra bytes.
[[nodiscard]] std::string las_descriptors(const std::vector<LasRecord>& records);

/// Description of the text record that holds comments of other formats.
inline constexpr std::string_view las_comments = "comments (deburr)";

/// What stands before and behind the points of a LAS file.
struct LasHeader {
  std::string bytes;  ///< the public header block, with what a writer put behind it
  unsigned minor = 2;
  unsigned format = 0;
  std::size_t point_bytes = 0;
  std::size_t points = 0;
  std::size_t point_offset = 0;
  LasGrid grid;
  std::vector<LasRecord> records;
  std::string gap;  ///< between the records and the points
};

/// @throws IoError  naming the byte
[[nodiscard]] LasHeader parse_las_header(const Source& source);

/// Whether a block of a layout that calls itself one of LAS has the bytes for it.
[[nodiscard]] bool is_las_block(const HeaderBlock& block);

/// The header without its counts and places, from the block of a layout.
[[nodiscard]] LasHeader las_header_of(const HeaderBlock& block);

/// Scale and offset in a header.
[[nodiscard]] LasGrid load_las_grid(std::string_view header);

}  // namespace deburr
