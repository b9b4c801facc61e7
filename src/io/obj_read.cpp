// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "io/colors.hpp"
#include "io/comments.hpp"
#include "io/faces.hpp"
#include "io/obj.hpp"
#include "io/obj_lines.hpp"
#include "io/text_row.hpp"

namespace deburr {
namespace {

constexpr std::size_t block = 4096;  ///< lines between two looks at the cancel callback

class ObjReader {
 public:
  explicit ObjReader(const Source& source) : source_(source), lines_(source.data) {}

  PointCloud read() {
    while (lines_.next()) {
      if (lines_.number() % block == 0) source_.check_cancelled();
      read_line();
    }
    check_corners();
    take_normals();
    make_columns();
    if (!faces_.empty()) cloud_.layout.elements.push_back(make_faces(corners_, offsets()));
    if (!other_keywords_.empty()) {
      cloud_.layout.blocks.push_back(
          {fmt::format("{} ({})", obj_lines_name, fmt::join(other_keywords_, " ")),
           std::move(kept_)});
    }
    keep_comments(cloud_.layout, "OBJ", std::move(comments_));
    cloud_.layout.encoding = Encoding::Obj;
    return std::move(cloud_);
  }

 private:
  struct Face {
    std::size_t end;   ///< of its corners
    std::size_t line;  ///< in the file
  };

  void read_line() {
    TextRow row(source_, lines_);
    const std::string_view keyword = row.word();
    if (keyword == "v") return read_vertex(row);
    if (keyword == "vn") {
      normals_.push_back({row.take<double>("nx"), row.take<double>("ny"), row.take<double>("nz")});
    } else if (keyword == "f") {
      read_face(row);
    } else if (keyword.starts_with('#')) {
      comments_.push_back(comment_behind(lines_.raw(), lines_.raw().find('#') + 1));
    } else if (!keyword.empty() &&
               std::ranges::find(other_keywords_, keyword) == other_keywords_.end()) {
      if (!is_obj_keyword(keyword)) {
        row.fail(fmt::format("unknown keyword '{}'", keyword.substr(0, 40)));
      }
      other_keywords_.emplace_back(keyword);
    }
    flush_run();
    if (keyword == "vn") normal_starts_.push_back(kept_.size());
    kept_ += keyword.starts_with('#') ? lines_.raw() : lines_.line();
    kept_ += '\n';
    if (keyword == "vn") normal_ends_.push_back(kept_.size());
    // The line goes on, so that the next one is no vertex.
    const bool may_go_on = !keyword.starts_with('#');
    while (may_go_on && lines_.line().ends_with('\\') && lines_.next()) {
      if (keyword == "f" || keyword == "vn") {
        row.fail("faces and normals of more than one line are not read");
      }
      kept_ += lines_.line();
      kept_ += '\n';
    }
  }

  void read_vertex(TextRow& row) {
    const double x = row.take<double>("x");
    const double y = row.take<double>("y");
    cloud_.points.push_back({x, y, row.take<double>("z")});
    std::size_t count = 0;
    for (; !row.at_end() && count < 4; ++count) {
      extra_[count].push_back(row.take<double>("a colour"));
    }
    if (!row.at_end() || count == 2) row.fail("a vertex has 3, 4, 6 or 7 numbers");
    if (cloud_.points.size() == 1) extra_count_ = count;
    if (count != extra_count_) {
      row.fail(fmt::format("{} numbers, but {} before", count + 3, extra_count_ + 3));
    }
    ++run_;
  }

  void flush_run() {
    if (run_ > 0) kept_ += obj_run(std::exchange(run_, 0));
  }

  /// A corner is v, v/vt, v//vn or v/vt/vn.
  void read_face(TextRow& row) {
    for (std::string_view word = row.word(); !word.empty(); word = row.word()) {
      std::array<std::string_view, 3> parts;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t slash = std::min(word.find('/'), word.size());
        parts[k] = word.substr(0, slash);
        word.remove_prefix(std::min(slash + 1, word.size()));
      }
      if (!word.empty()) row.fail("a corner has at most three indices");
      const auto vertex = row.parse<std::int32_t>(parts[0], "a corner");
      const std::int64_t index =
          vertex > 0 ? vertex - 1 : std::ssize(cloud_.points) + std::int64_t{vertex};
      if (vertex == 0 || index < 0) row.fail(fmt::format("a face has vertex {}", vertex));
      corners_.push_back(static_cast<std::int32_t>(index));
      if (!parts[1].empty()) has_texture_ = true;
      if (!parts[2].empty()) {
        const auto normal = row.parse<std::int32_t>(parts[2], "a normal");
        normals_match_ = normals_match_ && normal == vertex && normal > 0;
      }
    }
    faces_.push_back({corners_.size(), lines_.number()});
  }

  [[nodiscard]] std::vector<std::size_t> offsets() const {
    std::vector<std::size_t> offsets{0};
    for (const Face& face : faces_) offsets.push_back(face.end);
    return offsets;
  }

  /// Faces may stand before their vertices.
  void check_corners() const {
    std::size_t begin = 0;
    for (const Face& face : faces_) {
      for (; begin < face.end; ++begin) {
        if (std::cmp_greater_equal(corners_[begin], cloud_.size())) {
          source_.fail(fmt::format("line {}: a face has vertex {}, but there are {} vertices",
                                   face.line, corners_[begin] + 1, cloud_.size()));
        }
      }
    }
  }

  /// Normals belong to the points if there are as many, and no face says otherwise. Then their
  /// lines are written anew; others stay as they are.
  void take_normals() {
    flush_run();
    if (normals_.empty()) return;
    if (normals_.size() != cloud_.size() || !normals_match_) {
      other_keywords_.insert(other_keywords_.begin(), "vn");
      return;
    }
    cloud_.normals = std::move(normals_);
    std::string rest;
    std::size_t from = 0;
    for (std::size_t k = 0; k < normal_starts_.size(); ++k) {
      rest.append(kept_, from, normal_starts_[k] - from);
      from = normal_ends_[k];
    }
    rest.append(kept_, from);
    kept_ = std::move(rest);
    // A first line with a return in it would say that all lines end so.
    if (kept_.find('\r') < kept_.find('\n')) kept_.insert(kept_.begin(), '\n');
  }

  void make_columns() {
    FileLayout& layout = cloud_.layout;
    for (const char* name : {"x", "y", "z"}) layout.fields.push_back({name, ScalarType::Float64});
    if (extra_count_ == 1) {
      layout.fields.push_back({"w", ScalarType::Float64});
      cloud_.attributes.push_back({"w", std::move(extra_[0]), {}});
    }
    if (extra_count_ >= 3) add_colors();
    if (!cloud_.normals.empty()) {
      for (const char* name : {"nx", "ny", "nz"}) {
        layout.fields.push_back({name, ScalarType::Float64});
      }
    }
    if (has_texture_ && other_keywords_.empty()) other_keywords_.emplace_back("f");
  }

  /// Colours in steps of 1/255 are bytes, in steps of 1/65535 they have 16 bits.
  void add_colors() {
    const auto have_steps = [&](unsigned most) {
      return std::all_of(extra_.begin(), extra_.begin() + static_cast<std::ptrdiff_t>(extra_count_),
                         [&](const std::vector<double>& values) {
                           return std::ranges::all_of(
                               values, [&](double v) { return is_color_step(v, most); });
                         });
    };
    const bool are_bytes = have_steps(255);
    const bool are_words = !are_bytes && have_steps(65535);
    for (std::size_t k = 0; k < extra_count_; ++k) {
      Attribute attribute{color_names.at(k), std::move(extra_[k]), {}};
      if (are_bytes) attribute.values = steps<std::uint8_t>(attribute.values);
      if (are_words) attribute.values = steps<std::uint16_t>(attribute.values);
      cloud_.layout.fields.push_back({attribute.name, attribute.type()});
      cloud_.attributes.push_back(std::move(attribute));
    }
  }

  template <typename T>
  static Values steps(const Values& fractions) {
    const auto& from = std::get<std::vector<double>>(fractions);
    std::vector<T> values;
    values.reserve(from.size());
    constexpr double most = std::numeric_limits<T>::max();
    for (const double value : from) values.push_back(static_cast<T>(std::lround(most * value)));
    return values;
  }

  const Source& source_;
  Lines lines_;
  PointCloud cloud_;
  std::vector<Comment> comments_;
  std::string kept_;     ///< all lines but those of vertices
  std::size_t run_ = 0;  ///< vertices since the last line that is kept
  std::size_t extra_count_ = 0;
  std::array<std::vector<double>, 4> extra_;
  std::vector<Vec3> normals_;
  std::vector<std::size_t> normal_starts_;  ///< of their lines, in kept_
  std::vector<std::size_t> normal_ends_;
  std::vector<std::int32_t> corners_;
  std::vector<Face> faces_;
  std::vector<std::string> other_keywords_;
  bool has_texture_ = false;
  bool normals_match_ = true;
};

}  // namespace

Match match_obj(std::string_view data) {
  Lines lines(data.substr(0, 65536));
  bool has_keyword = false;
  while (lines.next_full()) {
    std::string_view rest = lines.line();
    const std::string_view keyword = next_token(rest);
    if (keyword.starts_with('#')) continue;
    if (keyword == "v") return is_number(next_token(rest)) ? Match::Sure : Match::No;
    if (!is_obj_keyword(keyword)) return has_keyword ? Match::Possible : Match::No;
    has_keyword = true;
  }
  return Match::Possible;
}

PointCloud read_obj(const Source& source) { return ObjReader(source).read(); }

}  // namespace deburr
