// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>

#include "io/bytes.hpp"
#include "io/fields.hpp"
#include "io/lines.hpp"
#include "io/losses.hpp"
#include "io/lzf.hpp"
#include "io/numbers.hpp"
#include "io/pcd.hpp"
#include "io/pcd_header.hpp"
#include "io/scalar_type.hpp"

namespace deburr {
namespace {

constexpr std::size_t block = 4096;  ///< points that are written at once

bool is_pcd(Encoding encoding) {
  return encoding == Encoding::PcdAscii || encoding == Encoding::PcdBinary ||
         encoding == Encoding::PcdCompressed;
}

const std::string* find_block(const FileLayout& layout, std::string_view name) {
  const auto found = std::ranges::find(layout.blocks, name, &HeaderBlock::name);
  return found == layout.blocks.end() ? nullptr : &found->data;
}

class PcdWriter {
 public:
  explicit PcdWriter(const WriteJob& job)
      : job_(job), cloud_(job.cloud), columns_(columns_of(job.cloud)) {
    const FileLayout& layout = cloud_.layout;
    const bool is_pcd_layout = is_pcd(layout.encoding);
    header_.encoding = is_pcd_layout ? layout.encoding : Encoding::PcdBinary;
    header_.comments = layout.comments;
    header_.comments.insert(header_.comments.end(), layout.obj_info.begin(), layout.obj_info.end());
    header_.width = cloud_.size();
    if (const std::string* text = find_block(layout, "PCD viewpoint")) header_.viewpoint = *text;
    if (const std::string* text = find_block(layout, "PCD rows")) keep_rows(*text);
    find_colors(is_pcd_layout);
    // Normals that are new have the type of the coordinates: PCL reads both as floats only.
    const auto x = std::ranges::find(columns_, 0, &Column::role);
    for (const Column& c : columns_) {
      if (c.role != no_role) {
        add_coordinate(c, is_pcd_layout, c.in_layout || c.role < 3 ? c.type : x->type);
      } else {
        add_attribute(*c.attribute);
      }
    }
    losses_.add_elements(layout);
    losses_.add_foreign_blocks(layout, "PCD ");
    if (x->type == ScalarType::Float32 && header_.encoding != Encoding::PcdAscii) {
      losses_.add_coarse_floats(cloud_.points);
    }
  }

  std::vector<std::string> write() {
    std::size_t size = header_.point_bytes * cloud_.size();
    if (header_.encoding == Encoding::PcdCompressed &&
        size > std::numeric_limits<std::uint32_t>::max()) {
      header_.encoding = Encoding::PcdBinary;
      losses_.add("PCD cannot compress more than 4 GB, the points were written uncompressed");
    }
    buffer_ = format_pcd_header(header_);
    if (header_.encoding == Encoding::PcdCompressed) {
      write_compressed(size);
    } else {
      for (std::size_t begin = 0; begin < cloud_.size(); begin += block) {
        const std::size_t end = std::min(cloud_.size(), begin + block);
        header_.encoding == Encoding::PcdAscii ? append_text(begin, end) : append_rows(begin, end);
        job_.flush(buffer_);
      }
    }
    job_.flush(buffer_);
    return losses_.take();
  }

 private:
  /// Where the values of a field come from.
  struct PcdSource {
    const Column* coordinate = nullptr;
    const Attribute* attribute = nullptr;
    bool is_color = false;
  };

  /// The rows of an organised cloud are lost with the first point that is removed.
  void keep_rows(const std::string& text) {
    const std::size_t rows = parse_number<std::size_t>(text).value_or(0);
    if (rows == 0 || cloud_.size() % rows != 0) return;
    header_.height = rows;
    header_.width = cloud_.size() / rows;
  }

  void find_colors(bool is_pcd_layout) {
    const std::string* const name = find_block(cloud_.layout, "PCD colour");
    if (is_pcd_layout && name == nullptr) return;  // separate fields stay separate
    for (std::size_t k = 0; k < 4; ++k) {
      constexpr std::array names{"red", "green", "blue", "alpha"};
      const auto found = std::ranges::find(cloud_.attributes, names.at(k), &Attribute::name);
      const bool usable = found != cloud_.attributes.end() && !found->is_list() &&
                          found->type() == ScalarType::UInt8;
      colors_.at(k) = usable ? &*found : nullptr;
    }
    if (colors_[0] == nullptr || colors_[1] == nullptr || colors_[2] == nullptr) {
      colors_.fill(nullptr);
    }
    color_name_ = name != nullptr ? *name : colors_[3] != nullptr ? "rgba" : "rgb";
  }

  void add(std::string name, ScalarType type, std::size_t count, PcdSource source) {
    std::ranges::replace_if(
        name, [](char c) { return c == '\n' || is_blank(c); }, '_');
    // The name of a field of padding.
    if (name.empty() || name == "_") name = "field";
    while (!names_.insert(name).second) name += '_';
    header_.fields.push_back({name, type, count, header_.point_bytes});
    header_.point_bytes += size_of(type) * count;
    sources_.push_back(source);
  }

  void add_coordinate(const Column& c, bool is_pcd_layout, ScalarType wish) {
    constexpr std::array names{"x", "y", "z", "normal_x", "normal_y", "normal_z"};
    const bool is_real = wish == ScalarType::Float32 || wish == ScalarType::Float64;
    const bool keeps_name = is_pcd_layout && c.in_layout;
    add(keeps_name ? c.name : names.at(static_cast<std::size_t>(c.role)),
        is_real ? wish : ScalarType::Float64, 1, {&c, nullptr, false});
  }

  void add_attribute(const Attribute& attribute) {
    if (std::ranges::find(colors_, &attribute) != colors_.end()) {
      if (&attribute == colors_[0]) {
        add(color_name_, ScalarType::UInt32, 1, {nullptr, &attribute, true});
      }
      return;
    }
    std::size_t count = 1;
    if (attribute.is_list()) {
      count = cloud_.size() > 0 ? attribute.offsets[1] : 2;
      for (std::size_t i = 0; i < cloud_.size(); ++i) {
        if (attribute.offsets[i + 1] != (i + 1) * count) count = 0;
      }
    }
    if (attribute.type() == ScalarType::Text || count == 0) return losses_.add(attribute);
    add(attribute.name, attribute.type(), count, {nullptr, &attribute, false});
  }

  [[nodiscard]] std::uint32_t color(std::size_t i) const {
    constexpr std::array<unsigned, 4> shifts{16, 8, 0, 24};
    std::uint32_t packed = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      if (colors_[k] == nullptr) continue;
      const auto& values = std::get<std::vector<std::uint8_t>>(colors_[k]->values);
      packed |= static_cast<std::uint32_t>(values[i]) << shifts[k];
    }
    return packed;
  }

  /// Puts the values of a field for the points [begin, end) into the buffer.
  void store_column(std::size_t k, std::size_t offset, std::size_t stride, std::size_t begin,
                    std::size_t end) {
    const PcdField& field = header_.fields[k];
    const PcdSource& source = sources_[k];
    char* to = buffer_.data() + offset;
    with_number_type(field.type, [&]<typename T>(std::type_identity<T>) {
      for (std::size_t i = begin; i < end; ++i, to += stride) {
        if (source.is_color) {
          store_little(to, color(i));
        } else if (source.coordinate != nullptr) {
          store_little(to, static_cast<T>(source.coordinate->coordinate(i)));
        } else {
          const auto& values = std::get<std::vector<T>>(source.attribute->values);
          for (std::size_t j = 0; j < field.count; ++j) {
            store_little(to + j * sizeof(T), values[i * field.count + j]);
          }
        }
      }
    });
  }

  void append_rows(std::size_t begin, std::size_t end) {
    const std::size_t start = buffer_.size();
    buffer_.resize(start + (end - begin) * header_.point_bytes);
    for (std::size_t k = 0; k < sources_.size(); ++k) {
      store_column(k, start + header_.fields[k].offset, header_.point_bytes, begin, end);
    }
  }

  void write_compressed(std::size_t size) {
    job_.flush(buffer_);
    buffer_.resize(size);
    std::size_t offset = 0;
    for (std::size_t k = 0; k < sources_.size(); ++k) {
      const std::size_t stride = size_of(header_.fields[k].type) * header_.fields[k].count;
      store_column(k, offset, stride, 0, cloud_.size());
      offset += stride * cloud_.size();
    }
    const std::string packed = lzf_pack(buffer_);
    buffer_.clear();
    append_little(buffer_, static_cast<std::uint32_t>(packed.size()));
    append_little(buffer_, static_cast<std::uint32_t>(size));
    buffer_ += packed;
  }

  void append_text(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t k = 0; k < sources_.size(); ++k) {
        const PcdField& field = header_.fields[k];
        const PcdSource& source = sources_[k];
        if (source.is_color) {
          append_number(buffer_, color(i));
        } else if (source.coordinate != nullptr) {
          append_number(buffer_, source.coordinate->coordinate(i));
        } else {
          with_number_type(field.type, [&]<typename T>(std::type_identity<T>) {
            const auto& values = std::get<std::vector<T>>(source.attribute->values);
            for (std::size_t j = 0; j < field.count; ++j) {
              if (j > 0) buffer_ += ' ';
              append_number(buffer_, values[i * field.count + j]);
            }
          });
        }
        buffer_ += ' ';
      }
      buffer_.back() = '\n';
    }
  }

  const WriteJob& job_;
  const PointCloud& cloud_;
  std::vector<Column> columns_;
  PcdHeader header_;
  std::array<const Attribute*, 4> colors_{};
  std::string color_name_;
  std::set<std::string> names_;
  std::vector<PcdSource> sources_;  ///< of each field
  Losses losses_{"PCD"};
  std::string buffer_;
};

}  // namespace

std::vector<std::string> write_pcd(const WriteJob& job) { return PcdWriter(job).write(); }

}  // namespace deburr
