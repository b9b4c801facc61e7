// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <vector>

// LAS files made byte by byte, from the tables of the specification and not from the library.

namespace deburr {

/// Sizes of the point formats 0 to 10 without extra bytes.
inline constexpr std::size_t las_sizes[] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};

template <typename T>
void put_at(std::string& bytes, std::size_t at, T value) {
  std::memcpy(bytes.data() + at, &value, sizeof(T));
}

inline std::string las_record(const std::string& user, std::uint16_t id, const std::string& data,
                              bool is_extended = false) {
  std::string head(is_extended ? 60 : 54, '\0');
  head.replace(2, user.size(), user);
  put_at(head, 18, id);
  if (is_extended) {
    put_at(head, 20, static_cast<std::uint64_t>(data.size()));
  } else {
    put_at(head, 20, static_cast<std::uint16_t>(data.size()));
  }
  head.replace(is_extended ? 28 : 22, 4, "text");
  return head + data;
}

/// A descriptor of a field of extra bytes.
inline std::string las_descriptor(const std::string& name, std::uint8_t type,
                                  std::uint8_t options = 0, double scale = 1, double offset = 0) {
  std::string bytes(192, '\0');
  put_at(bytes, 2, type);
  put_at(bytes, 3, options);
  bytes.replace(4, name.size(), name);
  put_at(bytes, 112, scale);
  put_at(bytes, 136, offset);
  bytes.replace(160, 4, "what");
  return bytes;
}

/// What a file is made of.
struct LasParts {
  unsigned minor = 2;
  unsigned format = 0;
  std::size_t points = 5;
  std::string records = las_record("LASF_Projection", 34735, "keys");
  std::uint32_t record_count = 1;
  std::string gap{};
  std::string extended{};  ///< records behind the points
  std::uint32_t extended_count = 0;
  std::size_t extra_bytes = 0;
  double scale = 0.01;
  double offset = 500000;
};

/// Points with random bits in every field, but coordinates in a box.
inline std::string las_points(const LasParts& parts, unsigned seed = 1) {
  std::mt19937 random(seed);
  const std::size_t size = las_sizes[parts.format] + parts.extra_bytes;
  std::string bytes(parts.points * size, '\0');
  for (char& c : bytes) c = static_cast<char>(random());
  for (std::size_t i = 0; i < parts.points; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      put_at(bytes, i * size + 4 * k, static_cast<std::int32_t>(random() % 200001) - 100000);
    }
  }
  return bytes;
}

/// The file with right counts, but for the bounding box, which is 0.
inline std::string las_file(const LasParts& parts, const std::string& points) {
  const std::size_t head_size = parts.minor == 4 ? 375 : parts.minor == 3 ? 235 : 227;
  std::string head(head_size, '\0');
  head.replace(0, 4, "LASF");
  put_at(head, 4, std::uint16_t{4711});
  head.replace(8, 16, "0123456789abcdef");
  put_at(head, 24, std::uint8_t{1});
  put_at(head, 25, static_cast<std::uint8_t>(parts.minor));
  head.replace(26, 7, "a laser");
  head.replace(58, 9, "a program");
  put_at(head, 90, std::uint16_t{200});
  put_at(head, 92, std::uint16_t{2026});
  put_at(head, 94, static_cast<std::uint16_t>(head_size));
  const std::size_t start = head_size + parts.records.size() + parts.gap.size();
  put_at(head, 96, static_cast<std::uint32_t>(start));
  put_at(head, 100, parts.record_count);
  put_at(head, 104, static_cast<std::uint8_t>(parts.format));
  const std::size_t size = las_sizes[parts.format] + parts.extra_bytes;
  put_at(head, 105, static_cast<std::uint16_t>(size));
  const bool is_modern = parts.format >= 6;
  put_at(head, 107, static_cast<std::uint32_t>(is_modern ? 0 : parts.points));
  std::vector<std::uint64_t> returns(16);
  for (std::size_t i = 0; i < parts.points; ++i) {
    ++returns[static_cast<unsigned char>(points[i * size + 14]) & (is_modern ? 15U : 7U)];
  }
  for (std::size_t r = 0; r < 5 && !is_modern; ++r) {
    put_at(head, 111 + 4 * r, static_cast<std::uint32_t>(returns[r + 1]));
  }
  for (std::size_t k = 0; k < 3; ++k) {
    put_at(head, 131 + 8 * k, parts.scale);
    put_at(head, 155 + 8 * k, parts.offset);
  }
  if (parts.minor == 4) {
    const std::uint64_t end = start + points.size();
    put_at(head, 235, parts.extended_count > 0 ? end : std::uint64_t{0});
    put_at(head, 243, parts.extended_count);
    put_at(head, 247, static_cast<std::uint64_t>(parts.points));
    for (std::size_t r = 0; r < 15; ++r) put_at(head, 255 + 8 * r, returns[r + 1]);
  }
  return head + parts.records + parts.gap + points + parts.extended;
}

inline std::string las_file(const LasParts& parts) { return las_file(parts, las_points(parts)); }

/// The file without its bounding box, which a writer may know better.
inline std::string without_box(std::string file) {
  if (file.size() > 227) file.replace(179, 48, 48, '\0');
  return file;
}

}  // namespace deburr
