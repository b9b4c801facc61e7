// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/las_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/bytes.hpp"
#include "io/las_fields.hpp"

namespace deburr {
namespace {

constexpr std::size_t record_head = 54;
constexpr std::size_t extended_head = 60;

/// Reads the parts of the file one after the other.
class LasParser {
 public:
  explicit LasParser(const Source& source) : source_(source), data_(source.data) {}

  LasHeader parse() {
    need(0, las_header_size(0), "the header");
    if (!data_.starts_with("LASF")) fail(0, "no LAS file, which begins with LASF");
    parse_header();
    std::size_t offset = header_.bytes.size();
    const std::size_t count = load_little<std::uint32_t>(data_, las_at::record_count);
    for (std::size_t k = 0; k < count; ++k) offset = take_record(offset, false);
    if (header_.point_offset < offset) {
      fail(las_at::point_offset, fmt::format("points at byte {}, inside of the records that end at "
                                             "byte {}",
                                             header_.point_offset, offset));
    }
    need(offset, header_.point_offset - offset, "what stands before the points");
    header_.gap = data_.substr(offset, header_.point_offset - offset);
    // The size of a point is not 0: see parse_header().
    const std::size_t held = (data_.size() - header_.point_offset) / header_.point_bytes;
    if (held < header_.points) {
      fail(data_.size(), fmt::format("the file ends in point {} of {}", held + 1, header_.points));
    }
    parse_extended();
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(std::size_t byte, const std::string& what) const {
    source_.fail(fmt::format("byte {}: {}", byte, what));
  }

  void need(std::size_t offset, std::size_t size, std::string_view what) const {
    if (offset <= data_.size() && size <= data_.size() - offset) return;
    fail(data_.size(), fmt::format("the file ends in {}", what));
  }

  void parse_header() {
    const auto major = load_little<std::uint8_t>(data_, las_at::minor - 1);
    header_.minor = load_little<std::uint8_t>(data_, las_at::minor);
    if (major != 1 || header_.minor > 4) {
      fail(las_at::minor - 1, fmt::format("unknown version {}.{} of LAS", major, header_.minor));
    }
    const std::size_t size = load_little<std::uint16_t>(data_, las_at::header_size);
    if (size < las_header_size(header_.minor)) {
      fail(las_at::header_size, fmt::format("the header has {} bytes, version 1.{} needs {}", size,
                                            header_.minor, las_header_size(header_.minor)));
    }
    need(0, size, "the header");
    header_.bytes = data_.substr(0, size);
    header_.format = load_little<std::uint8_t>(data_, las_at::format);
    if ((header_.format & 0xc0U) != 0) {
      fail(las_at::format, "the points are compressed (LAZ), which is not read; unpack it first");
    }
    if (header_.format > las_last_format) {
      fail(las_at::format, fmt::format("unknown point format {}", header_.format));
    }
    header_.point_bytes = load_little<std::uint16_t>(data_, las_at::point_bytes);
    if (header_.point_bytes < las_point_bytes(header_.format)) {
      fail(las_at::point_bytes,
           fmt::format("points of {} bytes, format {} needs {}", header_.point_bytes,
                       header_.format, las_point_bytes(header_.format)));
    }
    header_.points = load_little<std::uint32_t>(data_, las_at::points);
    if (header_.minor >= 4) {
      const auto all = load_little<std::uint64_t>(data_, las_at::points_64);
      if (all != 0) header_.points = all;
    }
    header_.point_offset = load_little<std::uint32_t>(data_, las_at::point_offset);
    header_.grid = load_las_grid(header_.bytes);
    for (std::size_t k = 0; k < 3; ++k) {
      const double scale = header_.grid.scale[k];
      if (!std::isfinite(scale) || scale == 0 || !std::isfinite(header_.grid.offset[k])) {
        fail(las_at::scale + 8 * k,
             fmt::format("scale {} and offset {} of coordinates", scale, header_.grid.offset[k]));
      }
    }
  }

  std::size_t take_record(std::size_t offset, bool is_extended) {
    const std::size_t head = is_extended ? extended_head : record_head;
    need(offset, head, "a record");
    const std::uint64_t size = is_extended ? load_little<std::uint64_t>(data_, offset + 20)
                                           : load_little<std::uint16_t>(data_, offset + 20);
    need(offset + head, size, "a record");
    header_.records.push_back({std::string(data_.substr(offset, head + size)), is_extended});
    return offset + head + size;
  }

  void parse_extended() {
    const std::size_t end = header_.point_offset + header_.points * header_.point_bytes;
    const auto start_at = [&](std::size_t place) {
      const auto start = load_little<std::uint64_t>(data_, place);
      if (start < end) fail(place, fmt::format("a record at byte {}, inside of the points", start));
      return start;
    };
    if (header_.minor >= 4) {
      const std::size_t count = load_little<std::uint32_t>(data_, las_at::extended_count);
      if (count == 0) return;
      std::size_t offset = start_at(las_at::extended_start);
      for (std::size_t k = 0; k < count; ++k) offset = take_record(offset, true);
    } else if (header_.minor == 3 && load_little<std::uint64_t>(data_, las_at::waveforms) != 0) {
      take_record(start_at(las_at::waveforms), true);
    }
  }

  const Source& source_;
  std::string_view data_;
  LasHeader header_;
};

}  // namespace

std::size_t las_header_size(unsigned minor) { return minor >= 4 ? 375 : minor == 3 ? 235 : 227; }

std::string_view LasRecord::user() const {
  return padded_text(std::string_view(bytes).substr(2, 16));
}
std::uint16_t LasRecord::id() const { return load_little<std::uint16_t>(bytes, 18); }
std::string_view LasRecord::description() const {
  return padded_text(std::string_view(bytes).substr(is_extended ? 28 : 22, 32));
}
std::string_view LasRecord::data() const {
  return std::string_view(bytes).substr(is_extended ? extended_head : record_head);
}
std::string LasRecord::name() const {
  // Whatever bytes stand there, the name is to be printed.
  std::string printable(user());
  std::ranges::replace_if(
      printable, [](char c) { return c < ' ' || c > '~'; }, '?');
  return fmt::format("LAS {}record {} {}", is_extended ? "extended " : "", printable, id());
}

LasRecord make_las_record(std::string_view user, std::uint16_t id, std::string_view description,
                          std::string_view data) {
  LasRecord record;
  append_little<std::uint16_t>(record.bytes, 0);
  record.bytes += padded(user, 16);
  append_little(record.bytes, id);
  append_little(record.bytes, static_cast<std::uint16_t>(data.size()));
  record.bytes += padded(description, 32);
  record.bytes += data;
  return record;
}

std::string las_descriptors(const std::vector<LasRecord>& records) {
  std::string descriptors;
  for (const LasRecord& record : records) {
    if (record.is(las_spec, las_extra_id)) descriptors += record.data();
  }
  return descriptors;
}

LasHeader parse_las_header(const Source& source) { return LasParser(source).parse(); }

bool is_las_block(const HeaderBlock& block) {
  const std::string_view data = block.data;
  const bool is_extended = block.name.starts_with("LAS extended record");
  if (is_extended || block.name.starts_with("LAS record")) {
    return data.size() >= (is_extended ? extended_head : record_head);
  }
  if (block.name != "LAS header") return true;
  if (data.size() < las_header_size(0) || data.size() > 0xffff) return false;
  const unsigned minor = load_little<std::uint8_t>(data, las_at::minor);
  const unsigned format = load_little<std::uint8_t>(data, las_at::format);
  return minor <= 4 && data.size() >= las_header_size(minor) && format <= las_last_format;
}

LasHeader las_header_of(const HeaderBlock& block) {
  LasHeader header;
  header.bytes = block.data;
  header.minor = load_little<std::uint8_t>(block.data, las_at::minor);
  header.format = load_little<std::uint8_t>(block.data, las_at::format);
  header.point_bytes = load_little<std::uint16_t>(block.data, las_at::point_bytes);
  header.grid = load_las_grid(block.data);
  return header;
}

LasGrid load_las_grid(std::string_view header) {
  LasGrid grid;
  for (std::size_t k = 0; k < 3; ++k) {
    grid.scale[k] = load_little<double>(header, las_at::scale + 8 * k);
    grid.offset[k] = load_little<double>(header, las_at::offset + 8 * k);
  }
  return grid;
}

}  // namespace deburr
