// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "io/colors.hpp"
#include "io/comments.hpp"
#include "io/faces.hpp"
#include "io/fields.hpp"
#include "io/numbers.hpp"
#include "io/off.hpp"
#include "io/off_colors.hpp"
#include "io/text_row.hpp"

namespace deburr {
namespace {

constexpr std::size_t block = 4096;  ///< rows between two looks at the cancel callback

/// What the first word of an OFF file says of its vertices.
struct OffKind {
  bool texture = false;
  bool colors = false;
  bool normals = false;
};

std::optional<OffKind> parse_kind(std::string_view word) {
  OffKind kind;
  const auto take = [&](std::string_view prefix) {
    const bool has = word.starts_with(prefix);
    if (has) word.remove_prefix(prefix.size());
    return has;
  };
  kind.texture = take("ST");
  kind.colors = take("C");
  kind.normals = take("N");
  if (word != "OFF") return std::nullopt;
  return kind;
}

class OffReader {
 public:
  explicit OffReader(const Source& source) : source_(source), lines_(source.data) {}

  PointCloud read() {
    read_counts();
    read_vertices();
    read_faces();
    keep_comments(cloud_.layout, "OFF", std::move(comments_));
    cloud_.layout.encoding = Encoding::Off;
    return std::move(cloud_);
  }

 private:
  /// The next line with something on it, without its comment.
  TextRow next_row(std::string_view what) {
    while (lines_.next_full()) {
      std::string_view line = lines_.line();
      if (const std::size_t mark = line.find('#'); mark != std::string_view::npos) {
        const std::string_view raw = lines_.raw();
        const std::size_t begin = raw.find('#');
        // What stands before it in its line is data.
        comments_.push_back(comment_behind(raw.substr(begin), 1));
        line = trim(line.substr(0, mark));
      }
      if (!line.empty()) return {source_, lines_.number(), line};
    }
    source_.fail(fmt::format("line {}: the file ends before {}", lines_.number() + 1, what));
  }

  void read_counts() {
    TextRow row = next_row("its counts");
    const TextRow before = row;
    const std::string_view word = row.word();
    if (const std::optional<OffKind> kind = parse_kind(word)) {
      kind_ = *kind;
      if (row.at_end()) row = next_row("its counts");
      const TextRow rest = row;
      if (row.word() == "BINARY") row.fail("binary OFF is not read");
      row = rest;
    } else if (is_integer(word)) {
      row = before;  // the word may be left out
    } else {
      row.fail(fmt::format("'{}' is no kind of OFF that is read", word.substr(0, 40)));
    }
    points_ = row.take<std::size_t>("the number of vertices");
    face_count_ = row.take<std::size_t>("the number of faces");
    // No memory is taken on the word of a header: a vertex has at least six bytes, a face two.
    const std::size_t left =
        source_.data.size() + 1 - std::min(lines_.end_offset(), source_.data.size());
    if (points_ > left / 6 || face_count_ > left / 2) {
      row.fail(fmt::format("{} vertices and {} faces are announced, {} bytes are left", points_,
                           face_count_, left - 1));
    }
  }

  void read_vertices() {
    cloud_.points.reserve(points_);
    OffColumn texture[2];
    OffColumn colors[4];
    std::size_t color_count = 0;
    const std::size_t last = kind_.texture ? 2 : 0;
    for (std::size_t i = 0; i < points_; ++i) {
      if (i % block == 0) source_.check_cancelled();
      TextRow row = next_row(fmt::format("vertex {} of {}", i + 1, points_));
      cloud_.points.push_back(take_vector(row));
      if (kind_.normals) cloud_.normals.push_back(take_vector(row));
      words_.clear();
      while (!row.at_end()) words_.push_back(row.word());
      if (i == 0) color_count = words_.size() - std::min(last, words_.size());
      const bool fits = color_count == 0 || color_count == 3 || color_count == 4;
      if (!fits || words_.size() != color_count + last) {
        row.fail(fmt::format("{} numbers behind those of a vertex", words_.size()));
      }
      for (std::size_t k = 0; k < words_.size(); ++k) {
        add(k < color_count ? colors[k] : texture[k - color_count], row, words_[k]);
      }
    }
    name_columns();
    const auto all = [&](bool (OffColumn::*are)() const) {
      return std::all_of(colors, colors + color_count,
                         [&](const OffColumn& c) { return (c.*are)(); });
    };
    const ScalarType type = all(&OffColumn::are_bytes)   ? ScalarType::UInt8
                            : all(&OffColumn::are_words) ? ScalarType::UInt16
                                                         : ScalarType::Float64;
    for (std::size_t k = 0; k < color_count; ++k) add(color_names.at(k), colors[k].take(type));
    if (kind_.texture) {
      add("s", texture[0].take(ScalarType::Float64));
      add("t", texture[1].take(ScalarType::Float64));
    }
  }

  static void add(OffColumn& column, const TextRow& row, std::string_view token) {
    column.add(token, row.parse<double>(token, "a colour"));
  }

  static Vec3 take_vector(TextRow& row) {
    const auto x = row.take<double>("x");
    const auto y = row.take<double>("y");
    return {x, y, row.take<double>("z")};
  }

  void name_columns() {
    const std::size_t count = kind_.normals ? 6 : 3;
    for (std::size_t k = 0; k < count; ++k) {
      cloud_.layout.fields.push_back({std::string(role_names[k]), ScalarType::Float64});
    }
  }

  void add(const char* name, Values values) {
    Attribute attribute{name, std::move(values), {}};
    cloud_.layout.fields.push_back({name, attribute.type()});
    cloud_.attributes.push_back(std::move(attribute));
  }

  void read_faces() {
    std::vector<std::int32_t> corners;
    std::vector<std::size_t> offsets{0};
    OffColumn colors;
    std::vector<std::size_t> color_offsets{0};
    std::size_t color_count = 0;
    for (std::size_t face = 0; face < face_count_; ++face) {
      if (face % block == 0) source_.check_cancelled();
      TextRow row = next_row(fmt::format("face {} of {}", face + 1, face_count_));
      for (auto left = row.take<std::size_t>("the number of corners"); left > 0; --left) {
        const auto corner = row.take<std::int32_t>("a corner");
        if (corner < 0 || std::cmp_greater_equal(corner, points_)) {
          row.fail(fmt::format("a face has vertex {}, but there are {} vertices", corner, points_));
        }
        corners.push_back(corner);
      }
      offsets.push_back(corners.size());
      for (; !row.at_end(); ++color_count) add(colors, row, row.word());
      color_offsets.push_back(color_count);
    }
    if (face_count_ == 0) return;
    Element faces = make_faces(std::move(corners), std::move(offsets));
    if (color_count > 0) {
      faces.attributes.push_back(
          {"color", colors.take(colors.are_bytes() ? ScalarType::UInt8 : ScalarType::Float64),
           std::move(color_offsets), ScalarType::UInt8});
    }
    cloud_.layout.elements.push_back(std::move(faces));
  }

  const Source& source_;
  Lines lines_;
  OffKind kind_;
  std::size_t points_ = 0;
  std::size_t face_count_ = 0;
  std::vector<Comment> comments_;
  std::vector<std::string_view> words_;
  PointCloud cloud_;
};

}  // namespace

Match match_off(std::string_view data) {
  Lines lines(data.substr(0, 65536));
  while (lines.next_full()) {
    std::string_view rest = lines.line();
    if (rest.starts_with('#')) continue;
    const std::string_view word = next_token(rest);
    if (parse_kind(word)) return Match::Sure;
    return word.ends_with("OFF") || is_integer(word) ? Match::Possible : Match::No;
  }
  return Match::Possible;
}

PointCloud read_off(const Source& source) { return OffReader(source).read(); }

}  // namespace deburr
