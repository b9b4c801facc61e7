// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <stdexcept>

#include "deburr/error.hpp"
#include "io/bytes.hpp"
#include "io/las.hpp"
#include "io/las_grid.hpp"
#include "io/las_head.hpp"
#include "io/las_integers.hpp"
#include "io/las_plan.hpp"
#include "io/scalar_type.hpp"
#include "io/strided.hpp"

namespace deburr {
namespace {

constexpr std::size_t block =
    512;  ///< points that are put together at once, which stay in the cache
constexpr std::size_t most_buffered = std::size_t{1} << 18;  ///< bytes, until they are written

class LasWriter {
 public:
  explicit LasWriter(const WriteJob& job)
      : job_(job), cloud_(job.cloud), columns_(columns_of(job.cloud)) {
    take_blocks();
    plan_ = plan_las(cloud_, columns_, has_layout_ ? &old_ : nullptr, records_, losses_);
    choose_coordinates();
    if (!has_layout_) {
      header_ = new_las_header(plan_.format);
      old_.minor = plan_.format >= las_first_modern_format ? 4 : 2;
    }
    renew_las_records(records_, plan_, cloud_.layout, losses_);
    losses_.add_elements(cloud_.layout);
    losses_.add_foreign_blocks(cloud_.layout, "LAS ");
  }

  std::vector<std::string> write() {
    count_points();
    buffer_ = format_las_head(header_, old_.minor, plan_, grid_.grid, counts_, records_, gap_);
    for (std::size_t begin = 0; begin < cloud_.size(); begin += block) {
      append_points(begin, std::min(cloud_.size(), begin + block));
      if (buffer_.size() >= most_buffered) job_.flush(buffer_);
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
      if (!is_las_block(b)) {
        throw std::invalid_argument(fmt::format("the block '{}' is none of LAS", b.name));
      }
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

  void require_finite() const {
    const auto bad = std::ranges::find_if_not(cloud_.points, is_finite);
    if (bad == cloud_.points.end()) return;
    throw DataError(fmt::format("LAS cannot hold the coordinates of point {}, which are not finite",
                                bad - cloud_.points.begin() + 1));
  }

  void choose_coordinates() {
    std::optional<GridChoice> choice;
    if (has_layout_) choice = refine_grid(old_.grid, cloud_.points, cloud_.layout.resolution);
    const bool is_new = !choice;
    if (is_new) {
      require_finite();
      choice = choose_grid(cloud_.points);
    }
    if (!choice) throw DataError("LAS cannot hold coordinates as large as these");
    if (choice->is_coarse || (is_new && !choice->is_exact)) {
      losses_.add(fmt::format("LAS rounds coordinates, here to multiples of {}",
                              fmt::join(choice->grid.scale, ", ")));
    }
    grid_ = *choice;
    integers_ = LasIntegers(grid_.grid);
  }

  void count_points() {
    counts_.points = cloud_.size();
    counts_.low = grid_.low;
    counts_.high = grid_.high;
    const Attribute* const returns = plan_.attribute_for("return_number");
    if (returns == nullptr) {
      counts_.returns[plan_.makes_up("return_number") ? 1 : 0] = cloud_.size();
      return;
    }
    // Several counts at a time: one that is the same again and again has to wait for itself.
    constexpr std::size_t lanes = 4;
    std::array<std::array<std::uint64_t, 16>, lanes> sums{};
    std::visit(
        [&]<typename T>(const std::vector<T>& values) {
          if constexpr (!std::is_same_v<T, std::string>) {
            for (std::size_t i = 0; i < values.size(); ++i) {
              ++sums[i % lanes].at(static_cast<std::size_t>(values[i]));
            }
          }
        },
        returns->values);
    for (const auto& sum : sums) {
      for (std::size_t r = 0; r < sum.size(); ++r) counts_.returns.at(r) += sum.at(r);
    }
  }

  void append_points(std::size_t begin, std::size_t end) {
    const std::size_t stride = plan_.point_bytes;
    const std::size_t start = buffer_.size();
    buffer_.resize(start + (end - begin) * stride);
    char* const to = buffer_.data() + start;
    append_coordinates(Points(cloud_.points).subspan(begin, end - begin), to);
    for (std::size_t k = 0; k < plan_.fields.size(); ++k) {
      const LasFieldSource& source = plan_.fields[k];
      if (source.field.bits == 0) {
        store_field(source, to + source.field.byte, begin, end);
        continue;
      }
      // Fields that share a byte stand one after the other: it is stored once for all of them.
      const bool is_first = k == 0 || plan_.fields[k - 1].field.byte != source.field.byte;
      const bool is_last =
          k + 1 == plan_.fields.size() || plan_.fields[k + 1].field.byte != source.field.byte;
      if (is_first) bytes_.fill(0);
      add_field(source, begin, end);
      if (is_last) scatter(bytes_.data(), end - begin, to + source.field.byte, stride);
    }
    for (const LasExtraSource& source : plan_.extras) {
      store_extra(source, to + source.place, begin, end);
    }
  }

  void append_coordinates(Points points, char* to) {
    integers_.put(points, triples_.data());
    constexpr std::size_t bytes = 3 * sizeof(std::int32_t);
    if (!is_little_endian) std::ranges::transform(triples_, triples_.begin(), swap_bytes<int>);
    const std::int32_t* from = triples_.data();
    for (std::size_t n = points.size(); n > 0; --n, to += plan_.point_bytes, from += 3) {
      std::memcpy(to, from, bytes);
    }
  }

  /// Adds the bits of a field to those of the others in its byte.
  void add_field(const LasFieldSource& source, std::size_t begin, std::size_t end) {
    const LasField& field = source.field;
    if (source.attribute == nullptr) {
      if (!plan_.makes_up(field.name)) return;
      for (std::size_t i = 0; i < end - begin; ++i) {
        bytes_[i] = static_cast<std::uint8_t>(bytes_[i] | 1U << field.shift);
      }
      return;
    }
    std::visit(
        [&]<typename V>(const std::vector<V>& values) {
          if constexpr (std::is_same_v<V, std::uint8_t>) {
            add_bits(values.data() + begin, end - begin, field.shift, bytes_.data());
          } else if constexpr (!std::is_same_v<V, std::string>) {
            for (std::size_t i = begin; i < end; ++i) {
              bytes_[i - begin] = static_cast<std::uint8_t>(
                  bytes_[i - begin] | static_cast<unsigned>(values[i]) << field.shift);
            }
          }
        },
        source.attribute->values);
  }

  void store_field(const LasFieldSource& source, char* to, std::size_t begin, std::size_t end) {
    if (source.attribute == nullptr) return;
    const std::size_t stride = plan_.point_bytes;
    std::visit(
        [&]<typename V>(const std::vector<V>& values) {
          if constexpr (!std::is_same_v<V, std::string>) {
            with_number_type(source.field.type, [&]<typename T>(std::type_identity<T>) {
              const V* from = values.data() + begin;
              if constexpr (std::is_same_v<T, V>) return scatter(from, end - begin, to, stride);
              for (std::size_t n = end - begin; n > 0; --n, to += stride) {
                // A signed byte is a number here. NOLINTNEXTLINE(bugprone-signed-char-misuse)
                store_little(to, static_cast<T>(*from++));
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
  GridChoice grid_;
  LasIntegers integers_{LasGrid{}};                ///< of the points on the grid
  std::array<std::int32_t, 3 * block> triples_{};  ///< those of a block
  LasCounts counts_;
  std::array<std::uint8_t, block> bytes_{};  ///< those of one place in the points of a block
  std::string buffer_;
};

}  // namespace

std::vector<std::string> write_las(const WriteJob& job) { return LasWriter(job).write(); }

}  // namespace deburr
