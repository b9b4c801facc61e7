// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/las_head.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "deburr/error.hpp"
#include "deburr/version.hpp"
#include "io/bytes.hpp"

namespace deburr {
namespace {

/// Comments of other formats.
void add_comments(std::vector<LasRecord>& records, const FileLayout& layout, Losses& losses) {
  std::string text;
  std::size_t changed = 0;
  for (const auto* comments : {&layout.comments, &layout.obj_info}) {
    for (std::string comment : *comments) {
      if (comment.find('\n') != std::string::npos) ++changed;
      std::ranges::replace(comment, '\n', ' ');
      text += comment + '\n';
    }
  }
  if (text.empty()) return;
  losses.add_changed_comments(changed);
  constexpr std::size_t most = 0xffff;
  if (text.size() > most) losses.add("LAS holds 64 kB of comments, the rest was left out");
  records.push_back(
      make_las_record(las_spec, las_text_id, las_comments, std::string_view(text).substr(0, most)));
}

void store_counts(std::string& head, unsigned minor, const LasPlan& plan, const LasCounts& counts) {
  constexpr std::size_t most = 0xffffffff;
  const bool is_legacy = plan.format < las_first_modern_format && counts.points <= most;
  if (!is_legacy && minor < 4) {
    throw DataError(
        fmt::format("{} points are too many for version 1.{} of LAS", counts.points, minor));
  }
  const std::size_t legacy = is_legacy ? counts.points : 0;
  store_little(head, las_at::points, static_cast<std::uint32_t>(legacy));
  for (std::size_t r = 0; r < 5; ++r) {
    store_little(head, las_at::returns + 4 * r,
                 static_cast<std::uint32_t>(is_legacy ? counts.returns[r + 1] : 0));
  }
  if (minor < 4) return;
  store_little(head, las_at::points_64, static_cast<std::uint64_t>(counts.points));
  for (std::size_t r = 0; r < 15; ++r) {
    store_little(head, las_at::returns_64 + 8 * r, counts.returns[r + 1]);
  }
}

/// Programs differ in the last bit of a bound. That of the input stays where it says the same.
void store_bound(std::string& head, std::size_t place, double bound, double step) {
  constexpr double same = 1e-3;
  const auto before = load_little<double>(head, place);
  if (!(std::abs(before - bound) <= same * std::abs(step))) store_little(head, place, bound);
}

/// Waveforms may stand in one of the extended records; version 1.3 has no other, whatever its name.
void store_waveforms(std::string& head, unsigned minor, std::uint64_t end,
                     const std::vector<LasRecord>& records) {
  if (load_little<std::uint64_t>(head, las_at::waveforms) == 0) return;
  for (const LasRecord& r : records) {
    if (!r.is_extended) continue;
    const bool is_wanted = minor == 3 || r.is(las_spec, las_waveform_id);
    if (is_wanted) return store_little(head, las_at::waveforms, end);
    end += r.bytes.size();
  }
  if (minor == 3) store_little(head, las_at::waveforms, std::uint64_t{0});
}

}  // namespace

std::string new_las_header(unsigned format) {
  const unsigned minor = format >= las_first_modern_format ? 4 : 2;
  std::string header;
  header.assign(las_header_size(minor), '\0');
  header.replace(0, 4, "LASF");
  header[las_at::minor - 1] = 1;
  header[las_at::minor] = static_cast<char>(minor);
  header.replace(las_at::software - 32, 32, padded("OTHER", 32));
  header.replace(las_at::software, 32, padded(fmt::format("deburr {}", version), 32));
  return header;
}

void renew_las_records(std::vector<LasRecord>& records, const LasPlan& plan,
                       const FileLayout& layout, Losses& losses) {
  std::string descriptors;
  for (const LasExtraSource& source : plan.extras) descriptors += source.extra.descriptor;
  const auto is_extra = [](const LasRecord& r) { return r.is(las_spec, las_extra_id); };
  const auto old = std::ranges::find_if(records, is_extra);
  const auto place = old - records.begin();
  if (descriptors != las_descriptors(records)) {
    std::erase_if(records, is_extra);
    constexpr std::size_t most = 0xffff / las_descriptor_bytes * las_descriptor_bytes;
    auto at = records.begin() + std::min<std::ptrdiff_t>(place, std::ssize(records));
    for (std::size_t from = 0; from < descriptors.size(); from += most) {
      at = records.insert(at, make_las_record(las_spec, las_extra_id, "extra bytes",
                                              std::string_view(descriptors).substr(from, most)));
      ++at;
    }
  }
  add_comments(records, layout, losses);
}

std::string format_las_head(const std::string& header, unsigned minor, const LasPlan& plan,
                            const LasGrid& grid, const LasCounts& counts,
                            const std::vector<LasRecord>& records, const std::string& gap) {
  std::string bytes;
  std::uint32_t count = 0;
  std::uint32_t extended = 0;
  for (const LasRecord& r : records) {
    if (!r.is_extended) bytes += r.bytes;
    ++(r.is_extended ? extended : count);
  }
  std::string head = header;
  const std::size_t start = head.size() + bytes.size() + gap.size();
  const std::uint64_t end = start + counts.points * plan.point_bytes;
  store_little(head, las_at::header_size, static_cast<std::uint16_t>(head.size()));
  store_little(head, las_at::point_offset, static_cast<std::uint32_t>(start));
  store_little(head, las_at::record_count, count);
  store_little(head, las_at::format, static_cast<std::uint8_t>(plan.format));
  store_little(head, las_at::point_bytes, static_cast<std::uint16_t>(plan.point_bytes));
  for (std::size_t k = 0; k < 3; ++k) {
    store_little(head, las_at::scale + 8 * k, grid.scale[k]);
    store_little(head, las_at::offset + 8 * k, grid.offset[k]);
    store_bound(head, las_at::box + 16 * k, counts.high[k], grid.scale[k]);
    store_bound(head, las_at::box + 16 * k + 8, counts.low[k], grid.scale[k]);
  }
  store_counts(head, minor, plan, counts);
  if (minor >= 3) store_waveforms(head, minor, end, records);
  if (minor >= 4) {
    store_little(head, las_at::extended_start, extended > 0 ? end : std::uint64_t{0});
    store_little(head, las_at::extended_count, extended);
  }
  return head + bytes + gap;
}

}  // namespace deburr
