// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstring>
#include <vector>

#include "deburr/point_cloud.hpp"
#include "io/bytes.hpp"
#include "io/ply_header.hpp"

// What reader and writer of the data behind a PLY header share.

namespace deburr {

/// Items that are read or written between two looks at the cancel callback, and as one block.
inline constexpr std::size_t ply_block = 4096;

/// Where the values of a property go: to a coordinate, or to an attribute of the right type.
struct PlyTarget {
  PlyProperty property;
  std::vector<Vec3>* vectors = nullptr;
  double Vec3::*axis = nullptr;
  Attribute* attribute = nullptr;
};

/// Whether numbers of this encoding have the other byte order than this machine.
inline bool needs_swap(Encoding encoding) {
  return (encoding == Encoding::PlyLittleEndian) != (std::endian::native == std::endian::little);
}

/// Where something stands in a file.
struct PlyPlace {
  std::size_t offset = 0;
  std::size_t line = 0;  ///< number of lines before it, in ASCII
};

/// Refuses faces with a corner that is no vertex.
/// @param start  where the element begins
/// @throws IoError  naming line or byte
void check_faces(const Source& source, Encoding encoding, const PlyPlace& start,
                 const Element& element, std::size_t vertices);

/// Reads the items of one element from a position on.
class PlyBodyReader {
 public:
  PlyBodyReader(const Source& source, const PlyHeader& header)
      : source_(source), header_(header), offset_(header.bytes), line_(header.lines) {}

  /// Refuses an element with more items than the rest of the file can hold; to be called before
  /// memory is taken for them.
  void check_size(const PlyElement& element) const;
  /// Where the next element begins.
  [[nodiscard]] PlyPlace place() const { return {offset_, line_}; }
  /// Fills targets whose scalar attributes and vectors have the size of the element.
  void read(const PlyElement& element, std::vector<PlyTarget>& targets);

 private:
  [[noreturn]] void fail_at_end(const PlyElement& element, std::size_t row) const;
  void read_scalars(const PlyElement& element, std::vector<PlyTarget>& targets);
  void read_rows(const PlyElement& element, std::vector<PlyTarget>& targets);
  void read_list(const PlyElement& element, std::size_t row, PlyTarget& target);
  void read_text(const PlyElement& element, std::vector<PlyTarget>& targets);

  template <typename T>
  [[nodiscard]] T load(std::size_t offset) const {
    T value;
    std::memcpy(&value, source_.data.data() + offset, sizeof(T));
    return needs_swap(header_.encoding) ? swap_bytes(value) : value;
  }

  const Source& source_;
  const PlyHeader& header_;
  std::size_t offset_;
  std::size_t line_;
};

}  // namespace deburr
