// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "io/colors.hpp"
#include "io/comments.hpp"
#include "io/faces.hpp"
#include "io/fields.hpp"
#include "io/losses.hpp"
#include "io/numbers.hpp"
#include "io/off.hpp"
#include "io/off_colors.hpp"
#include "io/scalar_type.hpp"

namespace deburr {
namespace {

constexpr std::size_t block = 4096;  ///< lines that are written at once

class OffWriter {
 public:
  explicit OffWriter(const WriteJob& job)
      : job_(job), cloud_(job.cloud), columns_(columns_of(job.cloud)) {
    find_numbers();
    faces_ = valid_faces(cloud_.layout, cloud_.size());
    find_face_colors();
    losses_.add_elements(cloud_.layout, {faces_.attribute, face_colors_});
    losses_.add_foreign_blocks(cloud_.layout, "OFF ");
  }

  std::vector<std::string> write() {
    write_head();
    for (std::size_t i = 0; i < cloud_.size(); ++i) {
      if (i % block == 0) job_.flush(buffer_);
      append(cloud_.points[i]);
      if (!cloud_.normals.empty()) append(cloud_.normals[i]);
      for (std::size_t k = 0; k < numbers_.size(); ++k) {
        append_value(*numbers_[k], i, k < colors_.count() ? factor(k) : 0);
      }
      buffer_.back() = '\n';
    }
    write_faces();
    job_.flush(buffer_);
    return losses_.take();
  }

 private:
  [[nodiscard]] const Attribute* find(std::string_view name) const {
    const auto found = std::ranges::find(cloud_.attributes, name, &Attribute::name);
    const bool usable =
        found != cloud_.attributes.end() && !found->is_list() && found->type() != ScalarType::Text;
    return usable ? &*found : nullptr;
  }

  /// Whether a reader tells these numbers from real ones: integers are bytes.
  static bool is_color(const Attribute& a) {
    return a.type() == ScalarType::UInt8 || !is_integer_type(a.type());
  }

  /// Colours and, for what came from OFF, texture coordinates.
  void find_numbers() {
    colors_ = find_colors(cloud_);
    numbers_.assign(colors_.of.begin(),
                    colors_.of.begin() + static_cast<std::ptrdiff_t>(colors_.count()));
    losses_.add_wider_alpha(colors_);
    const Attribute* const s = find("s");
    const Attribute* const t = find("t");
    if (cloud_.layout.encoding == Encoding::Off && s != nullptr && t != nullptr) {
      has_texture_ = true;
      numbers_.insert(numbers_.end(), {s, t});
    }
    for (const Attribute& a : cloud_.attributes) {
      if (std::ranges::find(numbers_, &a) == numbers_.end()) losses_.add(a);
    }
  }

  void find_face_colors() {
    for (const Element& element : cloud_.layout.elements) {
      if (element.name != "face" || faces_.attribute == nullptr) continue;
      const auto found = std::ranges::find(element.attributes, "color", &Attribute::name);
      const bool usable = found != element.attributes.end() && found->is_list() &&
                          is_color(*found) && found->type() != ScalarType::Text;
      if (usable) face_colors_ = &*found;
    }
  }

  void write_head() {
    buffer_ = fmt::format("{}{}{}OFF\n", has_texture_ ? "ST" : "", colors_.are_there() ? "C" : "",
                          cloud_.normals.empty() ? "" : "N");
    const CommentLines comments(cloud_.layout, "OFF");
    losses_.add_changed_comments(comments.changed());
    buffer_ += comments.text();
    buffer_ += fmt::format("{} {} 0\n", cloud_.size(), faces_.size());
  }

  void write_faces() {
    for (std::size_t face = 0; face < faces_.size(); ++face) {
      if (face % block == 0) job_.flush(buffer_);
      append_number(buffer_, faces_[face].size());
      buffer_ += ' ';
      for (const std::uint32_t corner : faces_[face]) {
        append_number(buffer_, corner);
        buffer_ += ' ';
      }
      if (face_colors_ != nullptr) {
        for (std::size_t k = face_colors_->offsets[face]; k < face_colors_->offsets[face + 1];
             ++k) {
          append_value(*face_colors_, k);
        }
      }
      buffer_.back() = '\n';
    }
  }

  void append(const Vec3& v) {
    for (const double Vec3::*axis : axes) {
      append_number(buffer_, v.*axis);
      buffer_ += ' ';
    }
  }

  /// What makes an integer of colour k one of 16 bits, where colours are such.
  [[nodiscard]] unsigned factor(std::size_t k) const {
    return colors_.most[0] > 255 ? 65535 / colors_.most.at(k) : 0;
  }

  /// @param factor  of colours of 16 bits; 0 for others
  void append_value(const Attribute& attribute, std::size_t i, unsigned factor = 0) {
    std::visit(
        [&]<typename T>(const std::vector<T>& values) {
          if constexpr (std::floating_point<T>) {
            append_off_real(buffer_, values[i]);
          } else if constexpr (std::is_integral_v<T>) {
            if (factor > 0) {
              append_off_word(buffer_, factor * static_cast<unsigned>(values[i]));
            } else {
              append_number(buffer_, values[i]);
            }
          }
        },
        attribute.values);
    buffer_ += ' ';
  }

  const WriteJob& job_;
  const PointCloud& cloud_;
  std::vector<Column> columns_;
  std::vector<const Attribute*> numbers_;
  Colors colors_;
  bool has_texture_ = false;
  Faces faces_;
  const Attribute* face_colors_ = nullptr;
  Losses losses_{"OFF"};
  std::string buffer_;
};

}  // namespace

std::vector<std::string> write_off(const WriteJob& job) { return OffWriter(job).write(); }

}  // namespace deburr
