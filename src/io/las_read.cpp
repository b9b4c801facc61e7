// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "io/bytes.hpp"
#include "io/fields.hpp"
#include "io/las.hpp"
#include "io/las_extra.hpp"
#include "io/las_fields.hpp"
#include "io/las_header.hpp"
#include "io/las_layout.hpp"
#include "io/scalar_type.hpp"
#include "io/strided.hpp"

namespace deburr {
namespace {

constexpr std::size_t block = 512;  ///< points that are read at once, which stay in the cache

class LasReader {
 public:
  explicit LasReader(const Source& source)
      : source_(source), header_(parse_las_header(source)), fields_(las_fields(header_.format)) {}

  PointCloud read() {
    find_extras();
    check_scales();
    make_columns();
    for (std::size_t begin = 0; begin < header_.points; begin += block) {
      source_.check_cancelled();
      const std::size_t end = std::min(header_.points, begin + block);
      gathered_ = 0;
      grow(end);
      read_coordinates(begin, end);
      for (std::size_t k = 0; k < fields_.size(); ++k) read_field(k, begin, end);
      for (std::size_t k = 0; k < extras_.size(); ++k) read_extra(k, begin, end);
    }
    name_las_columns(cloud_, extras_, roles_);
    cloud_.layout = las_layout(cloud_, header_, extras_, roles_);
    return std::move(cloud_);
  }

 private:
  void find_extras() {
    std::size_t place = las_point_bytes(header_.format);
    extras_ = parse_las_extras(las_descriptors(header_.records), header_.point_bytes - place);
    std::vector<std::string> names{"x", "y", "z"};
    for (LasExtra& extra : extras_) {
      const bool is_number = extra.count == 1 && !extra.descriptor.empty();
      names.push_back(is_number ? extra.name : "");
      extra_places_.push_back(place);
      place += extra.bytes();
    }
    const std::vector<int> roles = find_roles(names);
    roles_.assign(roles.begin() + 3, roles.end());
  }

  /// Integers that their scale does not give back stay as they are.
  void check_scales() {
    for (std::size_t k = 0; k < extras_.size(); ++k) {
      LasExtra& extra = extras_[k];
      if (!extra.is_scaled) continue;
      with_number_type(extra.type, [&]<typename T>(std::type_identity<T>) {
        for (std::size_t i = 0; i < header_.points && extra.is_scaled; ++i) {
          for (std::size_t j = 0; j < extra.count; ++j) {
            const T raw = load_little<T>(point(i) + extra_places_[k] + j * sizeof(T));
            const double value = static_cast<double>(raw) * extra.scale[j] + extra.offset[j];
            extra.is_scaled = extra.is_scaled && unscale<T>(extra, j, value) == raw;
          }
        }
      });
    }
  }

  /// Takes memory for all points, but leaves the zeros to grow().
  void make_columns() {
    const std::size_t n = header_.points;
    reserve_large(cloud_.points, n);
    for (const LasField& field : fields_) {
      cloud_.attributes.push_back({std::string(field.name), room_for(field.type, n), {}});
    }
    if (std::ranges::count(roles_, 3) > 0) reserve_large(cloud_.normals, n);
    for (std::size_t k = 0; k < extras_.size(); ++k) {
      if (roles_[k] != no_role) continue;
      const LasExtra& extra = extras_[k];
      Attribute attribute{extra.name, room_for(extra.value_type(), n * extra.count), {}};
      counts_.push_back(extra.count);
      for (std::size_t i = 0; extra.count > 1 && i <= n; ++i) {
        attribute.offsets.push_back(i * extra.count);
      }
      attribute.length_type = extra.count <= 0xff ? ScalarType::UInt8 : ScalarType::UInt16;
      cloud_.attributes.push_back(std::move(attribute));
    }
  }

  /// Makes all columns as long as that, while the block that comes is not yet in the cache.
  void grow(std::size_t size) {
    cloud_.points.resize(size);
    if (cloud_.normals.capacity() > 0) cloud_.normals.resize(size);
    for (std::size_t k = 0; k < cloud_.attributes.size(); ++k) {
      const std::size_t count = k < fields_.size() ? 1 : counts_[k - fields_.size()];
      std::visit([&](auto& values) { values.resize(size * count); }, cloud_.attributes[k].values);
    }
  }

  [[nodiscard]] const char* point(std::size_t i) const {
    return source_.data.data() + header_.point_offset + i * header_.point_bytes;
  }

  void read_coordinates(std::size_t begin, std::size_t end) {
    const LasGrid& g = header_.grid;
    const char* p = point(begin);
    const std::size_t stride = header_.point_bytes;
    for (std::size_t i = begin; i < end; ++i, p += stride) {
      cloud_.points[i] = {load_little<std::int32_t>(p) * g.scale[0] + g.offset[0],
                          load_little<std::int32_t>(p + 4) * g.scale[1] + g.offset[1],
                          load_little<std::int32_t>(p + 8) * g.scale[2] + g.offset[2]};
    }
  }

  void read_field(std::size_t k, std::size_t begin, std::size_t end) {
    const LasField& field = fields_[k];
    if (field.bits > 0) return read_bits(k, begin, end);
    with_number_type(field.type, [&]<typename T>(std::type_identity<T>) {
      T* const to = std::get<std::vector<T>>(cloud_.attributes[k].values).data();
      fetch(field.byte, begin, end, to + begin);
    });
  }

  /// The values at a place in each of the points [begin, end).
  template <typename T>
  void fetch(std::size_t byte, std::size_t begin, std::size_t end, T* to) const {
    gather(point(begin) + byte, end - begin, header_.point_bytes, to);
  }

  /// Fields that share a byte stand one after the other: it is fetched once for all of them.
  void read_bits(std::size_t k, std::size_t begin, std::size_t end) {
    const LasField& field = fields_[k];
    if (gathered_ != field.byte) {
      gathered_ = field.byte;
      fetch(field.byte, begin, end, bytes_.data());
    }
    auto& values = std::get<std::vector<std::uint8_t>>(cloud_.attributes[k].values);
    take_bits(bytes_.data(), end - begin, {field.shift, (1U << field.bits) - 1},
              values.data() + begin);
  }

  void read_extra(std::size_t k, std::size_t begin, std::size_t end) {
    const LasExtra& extra = extras_[k];
    const std::size_t place = extra_places_[k];
    // Attributes of extras with a role are not there, so those before count.
    const auto before = static_cast<std::size_t>(
        std::count(roles_.begin(), roles_.begin() + static_cast<std::ptrdiff_t>(k), no_role));
    const std::size_t index = fields_.size() + before;
    with_number_type(extra.type, [&]<typename T>(std::type_identity<T>) {
      const auto value = [&](std::size_t i, std::size_t j) {
        return load_little<T>(point(i) + place + j * sizeof(T));
      };
      const auto real = [&](std::size_t i, std::size_t j) {
        const auto raw = static_cast<double>(value(i, j));
        return extra.is_scaled ? raw * extra.scale[j] + extra.offset[j] : raw;
      };
      if (roles_[k] != no_role) {
        const auto axis = axes[static_cast<std::size_t>(roles_[k]) % 3];
        for (std::size_t i = begin; i < end; ++i) cloud_.normals[i].*axis = real(i, 0);
        return;
      }
      Values& values = cloud_.attributes[index].values;
      for (std::size_t i = begin; i < end; ++i) {
        for (std::size_t j = 0; j < extra.count; ++j) {
          if (extra.is_scaled) {
            std::get<std::vector<double>>(values)[i * extra.count + j] = real(i, j);
          } else {
            std::get<std::vector<T>>(values)[i * extra.count + j] = value(i, j);
          }
        }
      }
    });
  }

  const Source& source_;
  LasHeader header_;
  std::vector<LasField> fields_;
  std::vector<LasExtra> extras_;
  std::vector<std::size_t> extra_places_;
  std::vector<int> roles_;           ///< of the extras
  std::vector<std::size_t> counts_;  ///< of values, of those extras that are attributes
  std::array<std::uint8_t, block> bytes_{};
  std::size_t gathered_ = 0;  ///< the byte of a point that bytes_ has of this block; 0 for none
  PointCloud cloud_;
};

}  // namespace

Match match_las(std::string_view data) {
  return data.starts_with("LASF") ? Match::Sure : Match::No;
}

PointCloud read_las(const Source& source) { return LasReader(source).read(); }

}  // namespace deburr
