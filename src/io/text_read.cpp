// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "io/fields.hpp"
#include "io/lines.hpp"
#include "io/numbers.hpp"
#include "io/text.hpp"
#include "io/text_column.hpp"
#include "io/text_shape.hpp"
#include "io/text_split.hpp"
#include "large_pages.hpp"

namespace deburr {
namespace {

class TextReader {
 public:
  explicit TextReader(const Source& source)
      : source_(source),
        shape_(find_shape(source)),
        roles_(find_roles(shape_.names)),
        columns_(shape_.names.size()) {}

  PointCloud read() {
    reserve();
    read_rows();
    if (shape_.announced && *shape_.announced != cloud_.size()) {
      source_.fail(fmt::format("line 1: the file announces {} points and has {}", *shape_.announced,
                               cloud_.size()));
    }
    if (!may_have_normals_ && std::ranges::count(roles_, 3) == 0) cloud_.normals = {};
    if (may_have_normals_) take_normals();
    read_stale_columns();
    complete();
    return std::move(cloud_);
  }

 private:
  [[noreturn]] void fail(std::string_view what) const {
    source_.fail(fmt::format("line {}: {}", line_, what));
  }

  void reserve() {
    may_have_normals_ = shape_.layout.header == TextHeader::None && shape_.names.size() == 6;
    // A value takes two bytes, with what is between it and the next.
    const std::size_t most =
        source_.data.size() / (2 * std::max<std::size_t>(3, roles_.size())) + 1;
    const std::size_t rows = std::min(count_lines(source_.data), most);
    reserve_large(cloud_.points, rows);
    if (std::ranges::count(roles_, 3) > 0) reserve_large(cloud_.normals, rows);
    for (TextColumn& column : columns_) column.expect(rows);
  }

  /// Calls f() with the fields of each row in fields_.
  template <typename F, typename G>
  void for_each_row(const F& f, const G& on_comment) {
    Lines lines(source_.data, shape_.offset, shape_.lines);
    std::size_t row = 0;
    while (lines.next_full()) {
      line_ = lines.number();
      if (row % 4096 == 0) source_.check_cancelled();
      if (std::optional<Comment> comment = parse_comment(lines.raw())) {
        on_comment(std::move(*comment));
        continue;
      }
      if (!split(lines.line(), shape_.layout.separator, fields_)) fail("a quote does not end");
      if (fields_.size() != shape_.names.size()) {
        fail(fmt::format("{} columns, but {} before", fields_.size(), shape_.names.size()));
      }
      ++row;
      f();
    }
  }

  void read_rows() {
    comments_ = shape_.comments;
    const bool has_normals = std::ranges::count(roles_, 3) > 0;
    for_each_row(
        [&] {
          Vec3& point = cloud_.points.emplace_back();
          if (has_normals) cloud_.normals.emplace_back();
          for (std::size_t k = 0; k < fields_.size(); ++k) {
            if (roles_[k] == no_role) {
              columns_[k].add(fields_[k]);
              check_commas(k);
            } else {
              Vec3& vector = roles_[k] < 3 ? point : cloud_.normals.back();
              vector.*axes[static_cast<std::size_t>(roles_[k]) % 3] = coordinate(k);
            }
          }
          if (may_have_normals_) look_for_normal();
        },
        [&](Comment comment) {
          if (comments_.empty()) shape_.layout.mark = mark_of(comment);
          comments_.push_back(std::move(comment));
        });
  }

  void check_commas(std::size_t k) const {
    if (columns_[k].all_numbers() || fields_[k].is_quoted) return;
    if (is_decimal_comma(fields_[k].text)) fail(decimal_comma_error);
  }

  /// Gathers normals as long as the last three of six columns look like them.
  void look_for_normal() {
    constexpr double not_a_normal = 2;
    const auto number = [&](std::size_t k) {
      return parse_number<double>(fields_[k].text).value_or(not_a_normal);
    };
    const Vec3 v{number(3), number(4), number(5)};
    may_have_normals_ = v == Vec3{} || looks_like_unit(v);
    cloud_.normals.push_back(v);
  }

  void take_normals() {
    // Zeros alone are no normals.
    if (std::ranges::all_of(cloud_.normals, [](const Vec3& n) { return n == Vec3{}; })) {
      cloud_.normals.clear();
      return;
    }
    for (std::size_t k = 3; k < 6; ++k) shape_.names[k] = role_names[k];
    roles_ = find_roles(shape_.names);
  }

  /// A second pass for columns whose type changed on the way, e.g. from 1 to 1.5.
  void read_stale_columns() {
    std::vector<std::size_t> stale;
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      if (roles_[k] == no_role && columns_[k].is_stale()) stale.push_back(k);
    }
    if (stale.empty()) return;
    for (const std::size_t k : stale) columns_[k].start_again();
    for_each_row(
        [&] {
          for (const std::size_t k : stale) columns_[k].add(fields_[k]);
        },
        [](const Comment&) {});
  }

  void complete() {
    for (std::size_t k = 0; k < roles_.size(); ++k) {
      const ScalarType type = roles_[k] == no_role ? columns_[k].type() : ScalarType::Float64;
      cloud_.layout.fields.push_back({shape_.names[k], type});
      if (roles_[k] != no_role) continue;
      cloud_.attributes.push_back({shape_.names[k], columns_[k].take(), {}});
    }
    cloud_.layout.encoding = Encoding::Text;
    cloud_.layout.text = shape_.layout;
    if (shape_.header_mark != shape_.layout.mark && !shape_.header_mark.empty()) {
      cloud_.layout.blocks.push_back({std::string(text_header_mark), shape_.header_mark});
    }
    keep_comments(cloud_.layout, "text", std::move(comments_), shape_.layout.mark);
  }

  [[nodiscard]] double coordinate(std::size_t k) const {
    const std::string_view token = fields_[k].text;
    const std::optional<double> value = parse_number<double>(token);
    if (!value && is_decimal_comma(token)) fail(decimal_comma_error);
    if (!value) fail(fmt::format("'{}' in column '{}' is not a number", token, shape_.names[k]));
    return *value;
  }

  const Source& source_;
  TextShape shape_;
  std::vector<int> roles_;
  std::vector<TextColumn> columns_;  ///< those with a role stay empty
  std::vector<Comment> comments_;
  std::vector<TextField> fields_;
  PointCloud cloud_;
  std::size_t line_ = 0;
  bool may_have_normals_ = false;
};

}  // namespace

Match match_text(std::string_view /*data*/) { return Match::Possible; }

PointCloud read_text(const Source& source) { return TextReader(source).read(); }

}  // namespace deburr
