// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "io/colors.hpp"
#include "io/comments.hpp"
#include "io/faces.hpp"
#include "io/fields.hpp"
#include "io/lines.hpp"
#include "io/losses.hpp"
#include "io/numbers.hpp"
#include "io/obj.hpp"
#include "io/obj_lines.hpp"
#include "io/scalar_type.hpp"

namespace deburr {
namespace {

constexpr std::size_t block = 4096;  ///< lines that are written at once

constexpr std::array<std::string_view, 40> keywords{
    "v",    "vn",         "vt",        "vp",     "f",      "l",      "p",        "o",
    "g",    "s",          "mg",        "mtllib", "usemtl", "usemap", "maplib",   "cstype",
    "deg",  "bmat",       "step",      "curv",   "curv2",  "surf",   "parm",     "trim",
    "hole", "scrv",       "sp",        "end",    "con",    "bevel",  "c_interp", "d_interp",
    "lod",  "shadow_obj", "trace_obj", "ctech",  "stech",  "bsp",    "bzp",      "call"};

/// Whether there are lines of normals. What a line before one goes on to is none.
bool has_normals(std::string_view kept) {
  Lines lines(kept);
  for (bool goes_on = false; lines.next();) {
    std::string_view rest = lines.line();
    const std::string_view keyword = next_token(rest);
    if (!goes_on && keyword == "vn") return true;
    goes_on = lines.line().ends_with('\\') && (goes_on || !keyword.starts_with('#'));
  }
  return false;
}

class ObjWriter {
 public:
  explicit ObjWriter(const WriteJob& job)
      : job_(job), cloud_(job.cloud), columns_(columns_of(job.cloud)) {
    find_kept_lines();
    find_numbers();
    find_corners();
    losses_.add_foreign_blocks(cloud_.layout, "OBJ ");
  }

  std::vector<std::string> write() {
    if (kept_ != nullptr) {
      replay();
    } else {
      write_anew();
    }
    // A file without any content could not be read again.
    if (cloud_.size() == 0 && buffer_.empty()) buffer_ += '\n';
    job_.flush(buffer_);
    return losses_.take();
  }

 private:
  void find_kept_lines() {
    if (cloud_.layout.encoding != Encoding::Obj) return;
    const auto found = std::ranges::find_if(cloud_.layout.blocks, [](const HeaderBlock& b) {
      return b.name.starts_with(obj_lines_name);
    });
    if (found == cloud_.layout.blocks.end()) return;
    std::size_t vertices = 0;
    Lines lines(found->data);
    while (lines.next()) vertices += run_of(lines.line());
    if (vertices == cloud_.size()) {
      kept_ = &found->data;
    } else {
      losses_.add(
          fmt::format("{} left out, which may refer to points that are not there", found->name));
    }
  }

  static std::size_t run_of(std::string_view line) {
    if (!line.starts_with(obj_run_mark)) return 0;
    return parse_number<std::size_t>(line.substr(1)).value_or(0);
  }

  /// The attributes that a vertex line can have behind its place: colours, or w.
  void find_numbers() {
    const Colors colors = find_colors(cloud_);
    for (std::size_t k = 0; k < colors.count(); ++k) {
      numbers_.push_back(colors.of.at(k));
      // Real numbers are written as they are.
      divisors_.push_back(std::max(1U, colors.most.at(k)));
    }
    losses_.add_wider_alpha(colors);
    if (numbers_.empty() && cloud_.layout.encoding == Encoding::Obj) {
      const auto w = std::ranges::find(cloud_.attributes, "w", &Attribute::name);
      if (w != cloud_.attributes.end() && !w->is_list() && w->type() != ScalarType::Text) {
        numbers_.push_back(&*w);
        divisors_.push_back(1);
      }
    }
    for (const Attribute& a : cloud_.attributes) {
      if (std::ranges::find(numbers_, &a) == numbers_.end()) losses_.add(a);
    }
  }

  void find_corners() {
    faces_ = valid_faces(cloud_.layout, cloud_.size());
    losses_.add_elements(cloud_.layout, {faces_.attribute});
  }

  void write_anew() {
    const CommentLines comments(cloud_.layout, "OBJ");
    losses_.add_changed_comments(comments.changed());
    const bool first = !comments.begin_like_another_format() || cloud_.size() == 0;
    if (first) buffer_ += comments.text();
    append_vertices(0, cloud_.size());
    if (!first) buffer_ += comments.text();
    append_normals();
    for (std::size_t face = 0; face < faces_.size(); ++face) {
      if (face % block == 0) job_.flush(buffer_);
      buffer_ += 'f';
      for (const std::uint32_t corner : faces_[face]) {
        append_number(buffer_ += ' ', corner + 1);
        if (!cloud_.normals.empty()) append_number(buffer_ += "//", corner + 1);
      }
      buffer_ += '\n';
    }
  }

  /// The lines of the input, with new vertices.
  void replay() {
    std::size_t vertex = 0;
    Lines lines(*kept_);
    while (lines.next()) {
      const std::size_t run = run_of(lines.line());
      if (run > 0) {
        append_vertices(vertex, vertex + run);
        vertex += run;
        // Behind the last one, where no vertex follows any more.
        if (vertex == cloud_.size()) append_normals();
        continue;
      }
      buffer_ += lines.raw();
      buffer_ += '\n';
      if (lines.number() % block == 0) job_.flush(buffer_);
    }
  }

  void append_vertices(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (i % block == 0) job_.flush(buffer_);
      buffer_ += 'v';
      for (const double Vec3::*axis : axes) append_number(buffer_ += ' ', cloud_.points[i].*axis);
      for (std::size_t k = 0; k < numbers_.size(); ++k) append_value(*numbers_[k], divisors_[k], i);
      buffer_ += '\n';
    }
  }

  void append_value(const Attribute& attribute, unsigned divisor, std::size_t i) {
    buffer_ += ' ';
    std::visit(
        [&]<typename T>(const std::vector<T>& values) {
          if constexpr (std::is_integral_v<T>) {
            append_number(buffer_, static_cast<double>(values[i]) / divisor);
          } else if constexpr (!std::is_same_v<T, std::string>) {
            append_number(buffer_, values[i]);
          }
        },
        attribute.values);
  }

  void append_normals() {
    if (cloud_.normals.empty()) return;
    // Normals that stand in the lines are not those of the points.
    if (kept_ != nullptr && has_normals(*kept_)) {
      losses_.add("OBJ has other normals in its lines already, those of the points were left out");
      return;
    }
    for (std::size_t i = 0; i < cloud_.size(); ++i) {
      if (i % block == 0) job_.flush(buffer_);
      buffer_ += "vn";
      for (const double Vec3::*axis : axes) append_number(buffer_ += ' ', cloud_.normals[i].*axis);
      buffer_ += '\n';
    }
  }

  const WriteJob& job_;
  const PointCloud& cloud_;
  std::vector<Column> columns_;
  const std::string* kept_ = nullptr;
  std::vector<const Attribute*> numbers_;  ///< behind each vertex
  std::vector<unsigned> divisors_;         ///< of them
  Faces faces_;
  Losses losses_{"OBJ"};
  std::string buffer_;
};

}  // namespace

std::string obj_run(std::size_t vertices) { return fmt::format("{}{}\n", obj_run_mark, vertices); }

bool is_obj_keyword(std::string_view word) {
  return std::ranges::find(keywords, word) != keywords.end();
}

bool is_color_step(double value, unsigned most) {
  if (!(value >= 0 && value <= 1) || std::signbit(value)) return false;
  return static_cast<double>(std::lround(most * value)) / most == value;
}

std::vector<std::string> write_obj(const WriteJob& job) { return ObjWriter(job).write(); }

}  // namespace deburr
