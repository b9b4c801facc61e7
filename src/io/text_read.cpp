// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "io/fields.hpp"
#include "io/lines.hpp"
#include "io/numbers.hpp"
#include "io/text.hpp"
#include "io/text_shape.hpp"
#include "io/text_split.hpp"

namespace deburr {
namespace {

/// What all values of a column have in common so far.
struct ColumnKind {
  bool all_integers = true;  ///< in form
  bool all_fit = true;       ///< the integers, into 64 bits
  bool all_numbers = true;

  void add(std::string_view token) {
    if (all_integers) {
      all_integers = is_integer(token);
      if (all_integers && parse_number<std::int64_t>(token)) return;
      all_fit = false;
    }
    if (all_numbers) all_numbers = is_number(token);
  }
  /// Integers too large for their type stay text, which loses nothing.
  [[nodiscard]] ScalarType type() const {
    if (all_integers) return all_fit ? ScalarType::Int64 : ScalarType::Text;
    return all_numbers ? ScalarType::Float64 : ScalarType::Text;
  }
};

class TextReader {
 public:
  explicit TextReader(const Source& source)
      : source_(source),
        shape_(find_shape(source)),
        roles_(find_roles(shape_.names)),
        kinds_(shape_.names.size()) {}

  PointCloud read() {
    survey();
    if (shape_.announced && *shape_.announced != rows_) {
      source_.fail(
          fmt::format("line 1: the file announces {} points and has {}", *shape_.announced, rows_));
    }
    find_normals();
    PointCloud cloud;
    make_columns(cloud);
    fill(cloud);
    cloud.layout.encoding = Encoding::Text;
    cloud.layout.text = shape_.layout;
    cloud.layout.comments = std::move(comments_);
    return cloud;
  }

 private:
  [[noreturn]] void fail(std::string_view what) const {
    source_.fail(fmt::format("line {}: {}", line_, what));
  }

  /// Calls f() with the fields of each row in fields_.
  template <typename F>
  void for_each_row(const F& f) {
    Lines lines(source_.data, shape_.offset, shape_.lines);
    std::size_t row = 0;
    while (lines.next_full()) {
      line_ = lines.number();
      if (row % 4096 == 0) source_.check_cancelled();
      if (const auto comment = parse_comment(lines.line())) {
        f(0, comment);
        continue;
      }
      if (!split(lines.line(), shape_.layout.separator, fields_)) fail("a quote does not end");
      if (fields_.size() != shape_.names.size()) {
        fail(fmt::format("{} columns, but {} before", fields_.size(), shape_.names.size()));
      }
      f(row++, std::nullopt);
    }
  }

  /// First pass: counts the rows and finds the types of the columns.
  void survey() {
    const bool may_have_normals =
        shape_.layout.header == TextHeader::None && shape_.names.size() == 6;
    bool all_normals = may_have_normals;
    bool any_unit = false;
    constexpr double not_a_normal = 2;
    comments_ = shape_.comments;
    for_each_row([&](std::size_t, const std::optional<CommentLine>& comment) {
      if (comment) {
        if (comments_.empty()) shape_.layout.mark = comment->mark;
        comments_.emplace_back(comment->text);
        return;
      }
      ++rows_;
      for (std::size_t k = 0; k < fields_.size(); ++k) {
        if (roles_[k] == no_role) kinds_[k].add(fields_[k].text);
        if (roles_[k] == no_role && !kinds_[k].all_numbers && !fields_[k].is_quoted &&
            is_decimal_comma(fields_[k].text)) {
          fail(decimal_comma_error);
        }
      }
      if (!all_normals) return;
      const auto number = [&](std::size_t k) {
        return parse_number<double>(fields_[k].text).value_or(not_a_normal);
      };
      const Vec3 v{number(3), number(4), number(5)};
      all_normals = v == Vec3{} || looks_like_unit(v);
      any_unit = any_unit || v != Vec3{};
    });
    has_normals_ = all_normals && any_unit;
  }

  void find_normals() {
    if (!has_normals_) return;
    for (std::size_t k = 3; k < 6; ++k) shape_.names[k] = role_names[k];
    roles_ = find_roles(shape_.names);
  }

  void make_columns(PointCloud& cloud) const {
    cloud.points.resize(rows_);
    if (std::ranges::count(roles_, 3) > 0) cloud.normals.resize(rows_);
    for (std::size_t k = 0; k < roles_.size(); ++k) {
      const ScalarType type = roles_[k] == no_role ? kinds_[k].type() : ScalarType::Float64;
      cloud.layout.fields.push_back({shape_.names[k], type});
      if (roles_[k] != no_role) continue;
      Attribute attribute{shape_.names[k], {}, {}};
      if (type == ScalarType::Int64) attribute.values = std::vector<std::int64_t>(rows_);
      if (type == ScalarType::Float64) attribute.values = std::vector<double>(rows_);
      if (type == ScalarType::Text) attribute.values = std::vector<std::string>(rows_);
      cloud.attributes.push_back(std::move(attribute));
    }
  }

  /// Second pass.
  void fill(PointCloud& cloud) {
    for_each_row([&](std::size_t row, const std::optional<CommentLine>& comment) {
      if (comment) return;
      auto attribute = cloud.attributes.begin();
      for (std::size_t k = 0; k < fields_.size(); ++k) {
        if (roles_[k] == no_role) {
          set(*attribute++, row, fields_[k]);
        } else {
          auto& vectors = roles_[k] < 3 ? cloud.points : cloud.normals;
          vectors[row].*axes[static_cast<std::size_t>(roles_[k]) % 3] = coordinate(k);
        }
      }
    });
  }

  [[nodiscard]] double coordinate(std::size_t k) const {
    const std::string_view token = fields_[k].text;
    const std::optional<double> value = parse_number<double>(token);
    if (!value && is_decimal_comma(token)) fail(decimal_comma_error);
    if (!value) fail(fmt::format("'{}' in column '{}' is not a number", token, shape_.names[k]));
    return *value;
  }

  static void set(Attribute& attribute, std::size_t row, const TextField& field) {
    if (auto* integers = std::get_if<std::vector<std::int64_t>>(&attribute.values)) {
      (*integers)[row] = parse_number<std::int64_t>(field.text).value_or(0);
    } else if (auto* numbers = std::get_if<std::vector<double>>(&attribute.values)) {
      (*numbers)[row] = parse_number<double>(field.text).value_or(0);
    } else {
      std::get<std::vector<std::string>>(attribute.values)[row] = field.str();
    }
  }

  const Source& source_;
  TextShape shape_;
  std::vector<int> roles_;
  std::vector<ColumnKind> kinds_;
  std::vector<std::string> comments_;
  std::vector<TextField> fields_;
  std::size_t rows_ = 0;
  std::size_t line_ = 0;
  bool has_normals_ = false;
};

}  // namespace

Match match_text(std::string_view /*data*/) { return Match::Possible; }

PointCloud read_text(const Source& source) { return TextReader(source).read(); }

}  // namespace deburr
