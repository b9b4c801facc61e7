// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "added_fields.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <variant>

namespace deburr::cli {
namespace {

/// Adds a field to the points, or puts new values into the one of that name.
void set_attribute(PointCloud& cloud, const std::string& name, Values values) {
  const auto found = std::ranges::find(cloud.attributes, name, &Attribute::name);
  Attribute& attribute = found != cloud.attributes.end() ? *found : cloud.attributes.emplace_back();
  attribute = {.name = name, .values = std::move(values), .offsets = {}};
}

/// Values as classes of LAS, whatever type they were read as; none if one is not a class.
std::optional<std::vector<std::uint8_t>> as_classes(const Values& values) {
  std::vector<std::uint8_t> classes;
  const bool all = std::visit(
      [&](const auto& column) {
        using Value = typename std::decay_t<decltype(column)>::value_type;
        if constexpr (std::is_arithmetic_v<Value>) {
          for (const Value value : column) {
            const auto number = static_cast<double>(value);
            if (!(number >= 0 && number <= 255) || number != std::floor(number)) return false;
            classes.push_back(static_cast<std::uint8_t>(number));
          }
          return true;
        } else {
          return false;
        }
      },
      values);
  return all ? std::optional(std::move(classes)) : std::nullopt;
}

/// LAS has a class for outliers, low noise, which all its programs know.
void classify_outliers(PointCloud& cloud, const std::vector<std::uint8_t>& outliers) {
  constexpr std::uint8_t low_noise = 7;
  const auto found = std::ranges::find(cloud.attributes, "classification", &Attribute::name);
  std::vector<std::uint8_t> classes(cloud.size());
  if (found != cloud.attributes.end()) {
    auto before = as_classes(found->values);
    // Of what else a file calls its classification, nothing is written over.
    if (!before || before->size() != classes.size()) return;
    classes = std::move(*before);
  }
  for (std::size_t i = 0; i < classes.size(); ++i) {
    if (outliers[i] != 0) classes[i] = low_noise;
  }
  set_attribute(cloud, "classification", std::move(classes));
}

}  // namespace

AddedFields parse_added_fields(const std::string& list, const FormatInfo& format) {
  if (list.empty()) {
    const bool named = format.takes_any_field;
    return {named, named, named, named};
  }
  AddedFields add;
  if (list == "none") return add;
  for (const std::string& word : CLI::detail::split(list, ',')) {
    if (word == "normals") {
      add.normals = true;
    } else if (word == "label") {
      add.label = true;
    } else if (word == "displacement") {
      add.displacement = true;
    } else if (word == "outlier") {
      add.outlier = true;
    } else {
      throw std::invalid_argument(fmt::format(
          "--add takes none, or a list of normals,label,displacement,outlier, got {}", list));
    }
  }
  return add;
}

std::vector<std::string> add_fields(DenoiseResult& result, const AddedFields& add, bool had_normals,
                                    const FormatInfo& format) {
  std::vector<std::string> names;
  // Only a header can tell what a new column of a text file is.
  TextHeader& header = result.cloud.layout.text.header;
  const bool new_columns =
      (add.normals && !had_normals) || add.label || add.displacement || add.outlier;
  if (new_columns && header == TextHeader::None) header = TextHeader::Plain;
  if (add.normals || had_normals) {
    names.insert(names.end(), {"nx", "ny", "nz"});
  } else {
    result.cloud.normals.clear();
  }
  if (add.label) {
    std::vector<std::uint8_t> values;
    values.reserve(result.labels.size());
    for (const Feature label : result.labels) values.push_back(static_cast<std::uint8_t>(label));
    set_attribute(result.cloud, names.emplace_back("deburr_label"), std::move(values));
  }
  if (add.displacement) {
    std::vector<float> values;
    values.reserve(result.displacement.size());
    constexpr double most = std::numeric_limits<float>::max();
    for (const double moved : result.displacement) {
      values.push_back(static_cast<float>(std::min(moved, most)));
    }
    set_attribute(result.cloud, names.emplace_back("deburr_displacement"), std::move(values));
  }
  if (add.outlier && format.name == "las") {
    names.emplace_back("classification");
    classify_outliers(result.cloud, result.outliers);
  } else if (add.outlier) {
    set_attribute(result.cloud, names.emplace_back("deburr_outlier"), std::move(result.outliers));
  }
  return names;
}

}  // namespace deburr::cli
