// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "io/bytes.hpp"
#include "io/lzf.hpp"
#include "io/pcd.hpp"
#include "io/pcd_columns.hpp"
#include "io/pcd_header.hpp"
#include "io/scalar_type.hpp"
#include "io/text_row.hpp"

namespace deburr {
namespace {

constexpr std::size_t block = 4096;  ///< points between two looks at the cancel callback
constexpr std::size_t block_bytes = std::size_t{1} << 16;  ///< that are unpacked at once

class PcdReader {
 public:
  explicit PcdReader(const Source& source) : source_(source), header_(parse_pcd_header(source)) {}

  PointCloud read() {
    check_size();
    PcdColumns columns(source_, header_);
    if (header_.encoding == Encoding::PcdAscii) {
      read_text(columns);
    } else if (header_.encoding == Encoding::PcdBinary) {
      read_binary(columns);
    } else {
      read_compressed(columns);
    }
    PointCloud cloud = columns.finish();
    complete(cloud.layout);
    return cloud;
  }

 private:
  [[noreturn]] void fail_at_end(std::size_t point) const {
    source_.fail(fmt::format("byte {}: the file ends in point {} of {}", source_.data.size(),
                             point + 1, header_.points()));
  }

  /// Before memory is taken for the points.
  void check_size() const {
    const std::size_t left = source_.data.size() - header_.bytes;
    std::size_t held = left / header_.point_bytes;
    if (header_.encoding == Encoding::PcdAscii) {
      std::size_t values = 0;
      for (const PcdField& field : header_.fields) values += field.count;
      held = values > 0 ? (left + 1) / (2 * values) : 0;
    }
    if (header_.encoding == Encoding::PcdCompressed) {
      held = left * lzf_most_growth / header_.point_bytes;
    }
    if (header_.points() > held) fail_at_end(held);
  }

  void read_text(PcdColumns& columns) const {
    Lines lines(source_.data, header_.bytes, header_.lines);
    for (std::size_t i = 0; i < header_.points(); ++i) {
      if (i % block == 0) source_.check_cancelled();
      if (!lines.next_full()) fail_at_end(i);
      TextRow row(source_, lines);
      for (std::size_t k = 0; k < header_.fields.size(); ++k) columns.take(k, row, i);
      if (!row.at_end()) row.fail(fmt::format("unexpected '{}' behind the last field", row.word()));
    }
  }

  void read_binary(PcdColumns& columns) const {
    const char* const data = source_.data.data() + header_.bytes;
    for (std::size_t begin = 0; begin < header_.points(); begin += block) {
      source_.check_cancelled();
      const std::size_t end = std::min(header_.points(), begin + block);
      for (std::size_t k = 0; k < header_.fields.size(); ++k) {
        columns.take(k, data + begin * header_.point_bytes + header_.fields[k].offset,
                     header_.point_bytes, begin, end);
      }
    }
  }

  /// Column by column, as the file has them, a piece at a time.
  void read_compressed(PcdColumns& columns) const {
    const std::string_view data = source_.data.substr(header_.bytes);
    const std::size_t size = header_.points() * header_.point_bytes;
    if (size == 0 && data.size() < 8) return;
    if (data.size() < 8) fail_at_end(0);
    const std::size_t packed = load_little<std::uint32_t>(data, 0);
    const std::size_t unpacked = load_little<std::uint32_t>(data, 4);
    if (unpacked != size) {
      source_.fail(fmt::format("byte {}: {} bytes are announced, {} points have {}",
                               header_.bytes + 4, unpacked, header_.points(), size));
    }
    if (packed > data.size() - 8) {
      source_.fail(fmt::format("byte {}: the file ends in compressed data", source_.data.size()));
    }
    LzfUnpacker unpacker(data.substr(8, packed));
    bool is_whole = true;
    std::vector<char> piece;
    for (std::size_t k = 0; k < header_.fields.size() && is_whole; ++k) {
      const std::size_t stride = size_of(header_.fields[k].type) * header_.fields[k].count;
      const std::size_t step = std::max<std::size_t>(1, block_bytes / stride);
      for (std::size_t begin = 0; begin < header_.points() && is_whole; begin += step) {
        source_.check_cancelled();
        const std::size_t end = std::min(header_.points(), begin + step);
        piece.resize((end - begin) * stride);
        is_whole = unpacker.read(piece.data(), piece.size());
        if (is_whole) columns.take(k, piece.data(), stride, begin, end);
      }
    }
    if (!is_whole || !unpacker.at_end()) {
      source_.fail(fmt::format("byte {}: the compressed data are damaged", header_.bytes + 8));
    }
  }

  void complete(FileLayout& layout) {
    layout.encoding = header_.encoding;
    keep_comments(layout, "PCD", std::move(header_.comments));
    if (header_.viewpoint != pcd_default_viewpoint) {
      layout.blocks.push_back({"PCD viewpoint", header_.viewpoint});
    }
    if (header_.height != 1) {
      layout.blocks.push_back({"PCD rows", fmt::format("{}", header_.height)});
    }
  }

  const Source& source_;
  PcdHeader header_;
};

}  // namespace

Match match_pcd(std::string_view data) {
  return data.starts_with("# .PCD") || data.starts_with("VERSION") ? Match::Sure : Match::Possible;
}

PointCloud read_pcd(const Source& source) { return PcdReader(source).read(); }

}  // namespace deburr
