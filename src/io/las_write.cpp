// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "deburr/error.hpp"
#include "deburr/version.hpp"
#include "io/bytes.hpp"
#include "io/las.hpp"
#include "io/las_grid.hpp"
#include "io/las_plan.hpp"
#include "io/scalar_type.hpp"

namespace deburr {
namespace {

constexpr std::size_t block = 4096;  ///< points that are written at once

class LasWriter {
 public:
  explicit LasWriter(const WriteJob& job)
      : job_(job), cloud_(job.cloud), columns_(columns_of(job.cloud)) {
    take_blocks();
    plan_ = plan_las(cloud_, columns_, has_layout_ ? &old_ : nullptr, records_, losses_);
    choose_coordinates();
    if (!has_layout_) make_header();
    renew_records();
    losses_.add_elements(cloud_.layout);
    losses_.add_foreign_blocks(cloud_.layout, "LAS ");
  }

  std::vector<std::string> write() {
    count_points();
    buffer_ = head();
    for (std::size_t begin = 0; begin < cloud_.size(); begin += block) {
      append_points(begin, std::min(cloud_.size(), begin + block));
      job_.flush(buffer_);
    }
    for (const LasRecord& record : records_) {
      if (record.is_extended) buffer_ += record.bytes;
    }
    job_.flush(buffer_);
    return losses_.take();
  }

 private:
  void take_blocks() {
    const FileLayout& layout = cloud_.layout;
    if (layout.encoding != Encoding::Las) return;
    for (const HeaderBlock& b : layout.blocks) {
      if (b.name == "LAS header") {
        old_ = las_header_of(b);
        header_ = b.data;
        has_layout_ = true;
      } else if (b.name == "LAS gap") {
        gap_ = b.data;
      } else if (b.name.starts_with("LAS extended record")) {
        records_.push_back({b.data, true});
      } else if (b.name.starts_with("LAS record")) {
        records_.push_back({b.data, false});
      }
    }
  }

  void choose_coordinates() {
    const auto bad = std::ranges::find_if_not(cloud_.points, is_finite);
    if (bad != cloud_.points.end()) {
      throw DataError(
          fmt::format("LAS cannot hold the coordinates of point {}, which are not finite",
                      bad - cloud_.points.begin() + 1));
    }
    std::optional<GridChoice> choice;
    if (has_layout_) choice = refine_grid(old_.grid, cloud_.points, cloud_.layout.resolution);
    const bool is_new = !choice;
    if (is_new) choice = choose_grid(cloud_.points);
    grid_ = choice->grid;
    if (choice->is_coarse || (is_new && !choice->is_exact)) {
      losses_.add(fmt::format("LAS rounds coordinates, here to multiples of {}",
                              fmt::join(grid_.scale, ", ")));
    }
  }

  /// A header for a cloud that does not come from LAS.
  void make_header() {
    const unsigned minor = plan_.format >= las_first_modern_format ? 4 : 2;
    header_.assign(las_header_size(minor), '\0');
    header_.replace(0, 4, "LASF");
    header_[las_at::minor - 1] = 1;
    header_[las_at::minor] = static_cast<char>(minor);
    header_.replace(las_at::software - 32, 32, padded("OTHER", 32));
    header_.replace(las_at::software, 32, padded(fmt::format("deburr {}", version), 32));
    old_.minor = minor;
  }

  /// Descriptions of the extra bytes, and comments of other formats.
  void renew_records() {
    std::string descriptors;
    for (const LasExtraSource& source : plan_.extras) descriptors += source.extra.descriptor;
    const auto is_extra = [](const LasRecord& r) { return r.is(las_spec, las_extra_id); };
    const auto old = std::ranges::find_if(records_, is_extra);
    const auto place = old - records_.begin();
    std::string before;
    for (const LasRecord& r : records_) {
      if (is_extra(r)) before += r.data();
    }
    if (descriptors != before) {
      std::erase_if(records_, is_extra);
      constexpr std::size_t most = 0xffff / las_descriptor_bytes * las_descriptor_bytes;
      auto at = records_.begin() + std::min<std::ptrdiff_t>(place, std::ssize(records_));
      for (std::size_t from = 0; from < descriptors.size(); from += most) {
        at = records_.insert(at, make_las_record(las_spec, las_extra_id, "extra bytes",
                                                 std::string_view(descriptors).substr(from, most)));
        ++at;
      }
    }
    add_comments();
  }

  void add_comments() {
    std::string text;
    for (const auto* comments : {&cloud_.layout.comments, &cloud_.layout.obj_info}) {
      for (std::string comment : *comments) {
        std::ranges::replace(comment, '\n', ' ');
        text += comment + '\n';
      }
    }
    if (text.empty()) return;
    constexpr std::size_t most = 0xffff;
    if (text.size() > most) losses_.add("LAS holds 64 kB of comments, the rest was left out");
    records_.push_back(make_las_record(las_spec, las_text_id, las_comments,
                                       std::string_view(text).substr(0, most)));
  }

  [[nodiscard]] std::int32_t integer(std::size_t i, std::size_t k) const {
    const double value = cloud_.points[i].*axes[k];
    const auto held = las_integer(value, grid_.scale[k], grid_.offset[k]);
    if (!held) throw DataError(fmt::format("LAS cannot hold the coordinate {}", value));
    return *held;
  }

  /// Bounding box and numbers of returns.
  void count_points() {
    for (std::size_t i = 0; i < cloud_.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const double value = integer(i, k) * grid_.scale[k] + grid_.offset[k];
        low_[k] = i == 0 ? value : std::min(low_[k], value);
        high_[k] = i == 0 ? value : std::max(high_[k], value);
      }
    }
    const Attribute* const returns = plan_.attribute_for("return_number");
    if (returns == nullptr) {
      // One return each: see append_points().
      returns_[1] = has_layout_ ? 0 : cloud_.size();
      return;
    }
    std::visit(
        [&]<typename T>(const std::vector<T>& values) {
          if constexpr (!std::is_same_v<T, std::string>) {
            for (const T value : values) ++returns_.at(static_cast<std::size_t>(value));
          }
        },
        returns->values);
  }

  /// All that stands before the points.
  std::string head() {
    std::string records;
    std::uint32_t count = 0;
    std::uint32_t extended = 0;
    for (const LasRecord& r : records_) {
      if (!r.is_extended) records += r.bytes;
      ++(r.is_extended ? extended : count);
    }
    std::string head = header_;
    const std::size_t start = head.size() + records.size() + gap_.size();
    const std::uint64_t end = start + cloud_.size() * plan_.point_bytes;
    store_little(head, las_at::header_size, static_cast<std::uint16_t>(head.size()));
    store_little(head, las_at::point_offset, static_cast<std::uint32_t>(start));
    store_little(head, las_at::record_count, count);
    store_little(head, las_at::format, static_cast<std::uint8_t>(plan_.format));
    store_little(head, las_at::point_bytes, static_cast<std::uint16_t>(plan_.point_bytes));
    for (std::size_t k = 0; k < 3; ++k) {
      store_little(head, las_at::scale + 8 * k, grid_.scale[k]);
      store_little(head, las_at::offset + 8 * k, grid_.offset[k]);
      store_little(head, las_at::box + 16 * k, high_[k]);
      store_little(head, las_at::box + 16 * k + 8, low_[k]);
    }
    store_counts(head);
    if (old_.minor >= 3) store_waveforms(head, end);
    if (old_.minor >= 4) {
      store_little(head, las_at::extended_start, extended > 0 ? end : std::uint64_t{0});
      store_little(head, las_at::extended_count, extended);
    }
    return head + records + gap_;
  }

  void store_counts(std::string& head) const {
    constexpr std::size_t most = 0xffffffff;
    const bool is_legacy = plan_.format < las_first_modern_format && cloud_.size() <= most;
    if (!is_legacy && old_.minor < 4) {
      throw DataError(
          fmt::format("{} points are too many for version 1.{} of LAS", cloud_.size(), old_.minor));
    }
    const std::size_t legacy = is_legacy ? cloud_.size() : 0;
    store_little(head, las_at::points, static_cast<std::uint32_t>(legacy));
    for (std::size_t r = 0; r < 5; ++r) {
      store_little(head, las_at::returns + 4 * r,
                   static_cast<std::uint32_t>(is_legacy ? returns_[r + 1] : 0));
    }
    if (old_.minor < 4) return;
    store_little(head, las_at::points_64, static_cast<std::uint64_t>(cloud_.size()));
    for (std::size_t r = 0; r < 15; ++r) {
      store_little(head, las_at::returns_64 + 8 * r, returns_[r + 1]);
    }
  }

  /// Waveforms may stand in one of the extended records.
  void store_waveforms(std::string& head, std::uint64_t end) const {
    if (load_little<std::uint64_t>(head, las_at::waveforms) == 0) return;
    for (const LasRecord& r : records_) {
      if (!r.is_extended) continue;
      if (r.is(las_spec, las_waveform_id)) return store_little(head, las_at::waveforms, end);
      end += r.bytes.size();
    }
  }

  void append_points(std::size_t begin, std::size_t end) {
    const std::size_t stride = plan_.point_bytes;
    const std::size_t start = buffer_.size();
    buffer_.resize(start + (end - begin) * stride);
    char* const to = buffer_.data() + start;
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        store_little(to + (i - begin) * stride + 4 * k, integer(i, k));
      }
    }
    for (const LasFieldSource& source : plan_.fields) {
      store_field(source, to + source.field.byte, begin, end);
    }
    for (const LasExtraSource& source : plan_.extras) {
      store_extra(source, to + source.place, begin, end);
    }
  }

  void store_field(const LasFieldSource& source, char* to, std::size_t begin, std::size_t end) {
    const LasField& field = source.field;
    const std::size_t stride = plan_.point_bytes;
    if (source.attribute == nullptr) {
      // A point without any return would be none.
      const bool is_return = field.name == "return_number" || field.name == "number_of_returns";
      if (has_layout_ || !is_return) return;
      for (std::size_t i = begin; i < end; ++i, to += stride) {
        *to = static_cast<char>(static_cast<unsigned char>(*to) | 1U << field.shift);
      }
      return;
    }
    std::visit(
        [&]<typename V>(const std::vector<V>& values) {
          if constexpr (!std::is_same_v<V, std::string>) {
            with_number_type(field.type, [&]<typename T>(std::type_identity<T>) {
              for (std::size_t i = begin; i < end; ++i, to += stride) {
                const T value = static_cast<T>(values[i]);
                if constexpr (std::is_same_v<T, std::uint8_t>) {
                  *to = static_cast<char>(static_cast<unsigned char>(*to) |
                                          static_cast<unsigned>(value) << field.shift);
                } else {
                  store_little(to, value);
                }
              }
            });
          }
        },
        source.attribute->values);
  }

  void store_extra(const LasExtraSource& source, char* to, std::size_t begin, std::size_t end) {
    const LasExtra& extra = source.extra;
    const std::size_t stride = plan_.point_bytes;
    with_number_type(extra.type, [&]<typename T>(std::type_identity<T>) {
      for (std::size_t i = begin; i < end; ++i, to += stride) {
        if (source.normal != nullptr) {
          store_little(to, static_cast<T>(source.normal->coordinate(i)));
          continue;
        }
        for (std::size_t j = 0; j < extra.count; ++j) {
          const std::size_t k = i * extra.count + j;
          // The plan has seen to it that every value has its integer.
          const T value =
              extra.is_scaled
                  ? unscale<T>(extra, j, std::get<std::vector<double>>(source.attribute->values)[k])
                        .value_or(T{})
                  : std::get<std::vector<T>>(source.attribute->values)[k];
          store_little(to + j * sizeof(T), value);
        }
      }
    });
  }

  const WriteJob& job_;
  const PointCloud& cloud_;
  std::vector<Column> columns_;
  bool has_layout_ = false;
  LasHeader old_;
  std::string header_;
  std::string gap_;
  std::vector<LasRecord> records_;
  Losses losses_{"LAS"};
  LasPlan plan_;
  LasGrid grid_;
  std::array<double, 3> low_{};
  std::array<double, 3> high_{};
  std::array<std::uint64_t, 256> returns_{};
  std::string buffer_;
};

}  // namespace

std::vector<std::string> write_las(const WriteJob& job) { return LasWriter(job).write(); }

}  // namespace deburr
