// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "io/comments.hpp"
#include "io/fields.hpp"
#include "io/lines.hpp"
#include "io/losses.hpp"
#include "io/numbers.hpp"
#include "io/text.hpp"
#include "io/text_shape.hpp"

namespace deburr {
namespace {

/// Characters that no line of text can hold.
bool is_bad(char c) { return ends_lines(c) || is_binary_byte(c); }

/// The same text, with blanks for such characters.
std::string cleaned(std::string text) {
  std::ranges::replace_if(text, is_bad, ' ');
  return text;
}

/// Appends text without such characters so that it is read back as one field.
void append_field(std::string& line, const std::string& text, char separator) {
  const bool at_blanks = separator == ' ' || separator == '\t';
  const bool plain = at_blanks ? !text.empty() && text.find_first_of(blanks) == std::string::npos
                               : text == trim(text) && text.find(separator) == std::string::npos;
  const bool is_comment = text.starts_with('#') || text.starts_with("//");
  // Another separator in it could be taken for that of the file.
  if (plain && !is_comment && text.find_first_of("\",;\t") == std::string::npos) {
    line += text;
    return;
  }
  line += '"';
  for (const char c : text) {
    if (c == '"') line += '"';
    line += c;
  }
  line += '"';
}

/// Appends one value of an attribute. A real number keeps a point, so that it is read as one.
void append_value(std::string& line, const Attribute& attribute, std::size_t i, char separator) {
  std::visit(
      [&]<typename T>(const std::vector<T>& values) {
        if constexpr (std::is_same_v<T, std::string>) {
          append_field(line, cleaned(values[i]), separator);
        } else {
          const std::size_t begin = line.size();
          append_number(line, values[i]);
          if (std::floating_point<T> && is_integer(std::string_view(line).substr(begin))) {
            line += ".0";
          }
        }
      },
      attribute.values);
}

class TextWriter {
 public:
  explicit TextWriter(const WriteJob& job)
      : job_(job), cloud_(job.cloud), columns_(columns_of(job.cloud)) {
    const bool is_text_layout = cloud_.layout.encoding == Encoding::Text;
    const bool is_pts = job.format == "pts";
    if (is_text_layout) {
      layout_ = cloud_.layout.text;
    } else {
      layout_.separator = job.format == "csv" ? ',' : ' ';
      layout_.count_line = is_pts;
    }
    layout_.count_line = layout_.count_line && is_pts;
    drop_what_text_cannot_hold();
    if (is_text_layout && layout_.header == TextHeader::None && !cloud_.layout.fields.empty()) {
      // Without names, nobody could tell what a new column is.
      std::erase_if(columns_, [](const Column& c) { return !c.in_layout; });
    } else if (!is_text_layout && !explains_itself()) {
      layout_.header = TextHeader::Plain;
    }
    for (const Column& c : columns_) losses_.add_renamed(c);
    // A file without any content could not be read again.
    if (cloud_.size() == 0 && !layout_.count_line && layout_.header == TextHeader::None) {
      layout_.header = TextHeader::Plain;
    }
  }

  std::vector<std::string> write() {
    write_head();
    for (std::size_t i = 0; i < cloud_.size(); ++i) {
      if (i % 4096 == 0) flush();
      if (i == 1) write_late_comments();
      for (const Column& c : columns_) {
        if (c.role != no_role) {
          append_number(buffer_, c.coordinate(i));
        } else {
          append_value(buffer_, *c.attribute, i, layout_.separator);
        }
        buffer_ += layout_.separator;
      }
      buffer_.back() = '\n';
    }
    if (cloud_.size() <= 1) write_late_comments();
    flush();
    return losses_.take();
  }

 private:
  void drop_what_text_cannot_hold() {
    losses_.add_elements(cloud_.layout);
    losses_.add_foreign_blocks(cloud_.layout, "text ");
    std::erase_if(columns_, [&](const Column& c) {
      const bool is_list = c.attribute != nullptr && c.attribute->is_list();
      if (is_list) losses_.add(*c.attribute);
      return is_list;
    });
    for (const Column& c : columns_) {
      if (c.attribute != nullptr) look_for_bad_characters(*c.attribute);
    }
  }

  void look_for_bad_characters(const Attribute& attribute) {
    const auto* const words = std::get_if<std::vector<std::string>>(&attribute.values);
    if (words == nullptr) return;
    const auto changed = std::ranges::count_if(
        *words, [](const std::string& word) { return std::ranges::any_of(word, is_bad); });
    if (changed == 0) return;
    losses_.add(
        fmt::format("text cannot hold the control characters in {} values of '{}', which "
                    "became blanks",
                    changed, attribute.name));
  }

  /// Whether the reader finds the columns without a header: x y z, or x y z and normals.
  [[nodiscard]] bool explains_itself() const {
    if (columns_.size() != 3 && columns_.size() != 6) return false;
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      if (columns_[k].role != static_cast<int>(k)) return false;
    }
    return columns_.size() == 3 ||
           (std::ranges::all_of(cloud_.normals,
                                [](const Vec3& n) { return n == Vec3{} || looks_like_unit(n); }) &&
            std::ranges::any_of(cloud_.normals, looks_like_unit));
  }

  void write_head() {
    if (layout_.count_line) buffer_ += fmt::format("{}\n", cloud_.size());
    const CommentLines comments(cloud_.layout, "text", layout_.mark, is_bad);
    losses_.add_changed_comments(comments.changed());
    // Above the points, some would be taken for a header, or for the first line of another format.
    const bool are_late = comments.begin_like_another_format() || names_columns();
    (are_late ? late_comments_ : buffer_) += comments.text();
    if (layout_.header == TextHeader::None) return;
    if (layout_.header == TextHeader::Marked) buffer_ += header_mark();
    for (const std::string& name : written_names()) {
      append_field(buffer_, name, layout_.separator);
      buffer_ += layout_.separator;
    }
    buffer_.back() = '\n';
  }

  /// Names that the reader finds as they are; those that have to change make room for the others.
  std::vector<std::string> written_names() {
    std::vector<std::string> names;
    std::set<std::string> taken;
    for (const Column& c : columns_) {
      // What the reader calls it.
      names.push_back(c.name.empty() ? fmt::format("column_{}", names.size() + 1)
                                     : cleaned(c.name));
      if (names.back() == c.name) taken.insert(c.name);
    }
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (names[k] == columns_[k].name) continue;
      while (!taken.insert(names[k]).second) names[k] += '_';
      losses_.add_name(columns_[k].name, names[k]);
    }
    return names;
  }

  /// What stands before the names in a comment.
  [[nodiscard]] std::string header_mark() const {
    const auto& blocks = cloud_.layout.blocks;
    const auto found = std::ranges::find(blocks, text_header_mark, &HeaderBlock::name);
    return found != blocks.end() ? found->data : layout_.mark;
  }

  /// Whether a comment has as many names as there are columns.
  [[nodiscard]] bool names_columns() const {
    if (layout_.header != TextHeader::None) return false;
    const auto are_names = [&](const std::string& comment) {
      return deburr::names_columns(comment, layout_.separator, columns_.size());
    };
    return std::ranges::any_of(cloud_.layout.comments, are_names) ||
           std::ranges::any_of(cloud_.layout.obj_info, are_names);
  }

  void write_late_comments() { buffer_ += std::exchange(late_comments_, {}); }

  void flush() { job_.flush(buffer_); }

  const WriteJob& job_;
  const PointCloud& cloud_;
  std::vector<Column> columns_;
  TextLayout layout_;
  Losses losses_{"text"};
  std::string late_comments_;  ///< that stand behind the first point
  std::string buffer_;
};

}  // namespace

std::vector<std::string> write_text(const WriteJob& job) { return TextWriter(job).write(); }

}  // namespace deburr
