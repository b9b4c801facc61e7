// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "io/bytes.hpp"
#include "io/fields.hpp"
#include "io/lzf.hpp"
#include "io/pcd.hpp"
#include "io/pcd_header.hpp"
#include "io/scalar_type.hpp"
#include "io/text_row.hpp"

namespace deburr {
namespace {

constexpr std::size_t block = 4096;  ///< points between two looks at the cancel callback

/// Where the values of a field go.
struct PcdTarget {
  std::vector<Vec3>* vectors = nullptr;
  double Vec3::*axis = nullptr;
  std::size_t attribute = 0;  ///< or the first of three or four for colours
  bool is_color = false;
};

class PcdReader {
 public:
  explicit PcdReader(const Source& source) : source_(source), header_(parse_pcd_header(source)) {}

  PointCloud read() {
    check_size();
    make_targets();
    if (header_.encoding == Encoding::PcdAscii) {
      read_text();
    } else if (header_.encoding == Encoding::PcdBinary) {
      const char* const data = source_.data.data() + header_.bytes;
      for (std::size_t begin = 0; begin < header_.points(); begin += block) {
        source_.check_cancelled();
        const std::size_t end = std::min(header_.points(), begin + block);
        for (std::size_t k = 0; k < header_.fields.size(); ++k) {
          read_column(k, data + header_.fields[k].offset, header_.point_bytes, begin, end);
        }
      }
    } else {
      read_compressed();
    }
    finish();
    return std::move(cloud_);
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

  void make_targets() {
    std::vector<std::string> names;
    names.reserve(header_.fields.size());
    for (const PcdField& field : header_.fields) {
      names.push_back(field.count == 1 ? field.name : "");
    }
    const std::vector<int> roles = find_roles(names);
    if (const std::string_view missing = missing_coordinate(roles); !missing.empty()) {
      source_.fail(fmt::format("the file has no field '{}'", missing));
    }
    const std::size_t n = header_.points();
    resize_large(cloud_.points, n);
    if (std::ranges::count(roles, 3) > 0) resize_large(cloud_.normals, n);
    const bool colors_taken = std::ranges::any_of(names, [](const std::string& name) {
      return name == "red" || name == "green" || name == "blue" || name == "alpha";
    });
    for (std::size_t k = 0; k < roles.size(); ++k) {
      const PcdField& field = header_.fields[k];
      PcdTarget& target = targets_.emplace_back();
      const bool is_color = (field.name == "rgb" || field.name == "rgba") && field.count == 1 &&
                            size_of(field.type) == 4 && !colors_taken && !has_color_;
      if (field.is_padding()) continue;
      if (is_color) {
        add_colors(field, target);
        continue;
      }
      cloud_.layout.fields.push_back({field.name, field.type});
      if (roles[k] != no_role) {
        target.vectors = roles[k] < 3 ? &cloud_.points : &cloud_.normals;
        target.axis = axes[static_cast<std::size_t>(roles[k]) % 3];
        continue;
      }
      target.attribute = cloud_.attributes.size();
      Attribute attribute{field.name, zeros(field.type, n * field.count), {}};
      for (std::size_t i = 0; field.count > 1 && i <= n; ++i) {
        attribute.offsets.push_back(i * field.count);
      }
      attribute.length_type = field.count <= 0xff ? ScalarType::UInt8 : ScalarType::UInt32;
      cloud_.attributes.push_back(std::move(attribute));
    }
  }

  /// The four bytes of a colour, which other formats know by these names.
  void add_colors(const PcdField& field, PcdTarget& target) {
    has_color_ = true;
    target.is_color = true;
    target.attribute = cloud_.attributes.size();
    for (const char* name : {"red", "green", "blue", "alpha"}) {
      cloud_.layout.fields.push_back({name, ScalarType::UInt8});
      cloud_.attributes.push_back({name, zeros(ScalarType::UInt8, header_.points()), {}});
    }
    cloud_.layout.blocks.push_back({"PCD colour", field.name});
    has_alpha_ = field.name == "rgba";
  }

  void set_color(const PcdTarget& target, std::size_t i, std::uint32_t color) {
    constexpr unsigned shifts[] = {16, 8, 0, 24};
    for (std::size_t k = 0; k < 4; ++k) {
      auto& values =
          std::get<std::vector<std::uint8_t>>(cloud_.attributes[target.attribute + k].values);
      values[i] = static_cast<std::uint8_t>(color >> shifts[k]);
    }
    has_alpha_ = has_alpha_ || color > 0xffffff;
  }

  /// Points [begin, end) of a field, of which the first point has its values at `data`.
  void read_column(std::size_t k, const char* data, std::size_t stride, std::size_t begin,
                   std::size_t end) {
    const PcdField& field = header_.fields[k];
    const PcdTarget& target = targets_[k];
    if (field.is_padding()) return;
    if (target.is_color) {
      for (std::size_t i = begin; i < end; ++i) {
        set_color(target, i, load_little<std::uint32_t>(data + i * stride));
      }
      return;
    }
    with_number_type(field.type, [&]<typename T>(std::type_identity<T>) {
      if (target.vectors != nullptr) {
        for (std::size_t i = begin; i < end; ++i) {
          (*target.vectors)[i].*target.axis =
              static_cast<double>(load_little<T>(data + i * stride));
        }
        return;
      }
      auto& values = std::get<std::vector<T>>(cloud_.attributes[target.attribute].values);
      for (std::size_t i = begin; i < end; ++i) {
        for (std::size_t j = 0; j < field.count; ++j) {
          values[i * field.count + j] = load_little<T>(data + i * stride + j * sizeof(T));
        }
      }
    });
  }

  void read_compressed() {
    const std::string_view data = std::string_view(source_.data).substr(header_.bytes);
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
    const std::optional<std::string> columns = lzf_unpack(data.substr(8, packed), size);
    if (!columns) {
      source_.fail(fmt::format("byte {}: the compressed data are damaged", header_.bytes + 8));
    }
    std::size_t offset = 0;
    for (std::size_t k = 0; k < header_.fields.size(); ++k) {
      source_.check_cancelled();
      const PcdField& field = header_.fields[k];
      const std::size_t stride = size_of(field.type) * field.count;
      read_column(k, columns->data() + offset, stride, 0, header_.points());
      offset += stride * header_.points();
    }
  }

  void read_text() {
    Lines lines(source_.data, header_.bytes, header_.lines);
    for (std::size_t i = 0; i < header_.points(); ++i) {
      if (i % block == 0) source_.check_cancelled();
      if (!lines.next_full()) fail_at_end(i);
      TextRow row(source_, lines);
      for (std::size_t k = 0; k < header_.fields.size(); ++k) read_values(row, i, k);
      if (!row.at_end()) row.fail(fmt::format("unexpected '{}' behind the last field", row.word()));
    }
  }

  void read_values(TextRow& row, std::size_t i, std::size_t k) {
    const PcdField& field = header_.fields[k];
    const PcdTarget& target = targets_[k];
    if (field.is_padding()) {
      for (std::size_t j = 0; j < field.count; ++j) (void)row.word();
    } else if (target.vectors != nullptr) {
      // The text is more exact than a declared type of float.
      (*target.vectors)[i].*target.axis = row.take<double>(field.name);
    } else {
      with_number_type(field.type, [&]<typename T>(std::type_identity<T>) {
        for (std::size_t j = 0; j < field.count; ++j) {
          const T value = row.take<T>(field.name);
          if constexpr (sizeof(T) == 4) {
            if (target.is_color) return set_color(target, i, std::bit_cast<std::uint32_t>(value));
          }
          auto& values = std::get<std::vector<T>>(cloud_.attributes[target.attribute].values);
          values[i * field.count + j] = value;
        }
      });
    }
  }

  void finish() {
    FileLayout& layout = cloud_.layout;
    if (has_color_ && !has_alpha_) {
      std::erase_if(layout.fields, [](const Field& f) { return f.name == "alpha"; });
      std::erase_if(cloud_.attributes, [](const Attribute& a) { return a.name == "alpha"; });
    }
    layout.encoding = header_.encoding;
    layout.comments = std::move(header_.comments);
    if (header_.viewpoint != pcd_default_viewpoint) {
      layout.blocks.push_back({"PCD viewpoint", header_.viewpoint});
    }
    if (header_.height != 1) {
      layout.blocks.push_back({"PCD rows", fmt::format("{}", header_.height)});
    }
  }

  const Source& source_;
  PcdHeader header_;
  PointCloud cloud_;
  std::vector<PcdTarget> targets_;
  bool has_color_ = false;
  bool has_alpha_ = false;
};

}  // namespace

Match match_pcd(std::string_view data) {
  return data.starts_with("# .PCD") || data.starts_with("VERSION") ? Match::Sure : Match::Possible;
}

PointCloud read_pcd(const Source& source) { return PcdReader(source).read(); }

}  // namespace deburr
