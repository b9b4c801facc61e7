// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/las_layout.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "io/fields.hpp"

namespace deburr {
namespace {

bool is_zero(const Attribute& attribute) {
  return std::visit(
      []<typename T>(const std::vector<T>& values) {
        return std::ranges::all_of(values, [](const T& value) { return value == T{}; });
      },
      attribute.values);
}

/// Number of extras that are attributes.
std::size_t count_attributes(const std::vector<int>& roles) {
  return static_cast<std::size_t>(std::ranges::count(roles, no_role));
}

void add_comments(FileLayout& layout, std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    layout.comments.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

}  // namespace

void name_las_columns(PointCloud& cloud, const std::vector<LasExtra>& extras,
                      const std::vector<int>& roles) {
  std::set<std::string> taken{"x", "y", "z"};
  for (std::size_t k = 0; k < extras.size(); ++k) {
    if (roles[k] != no_role) taken.insert(extras[k].name);
  }
  std::vector<Attribute> kept;
  const auto first_extra =
      cloud.attributes.end() - static_cast<std::ptrdiff_t>(count_attributes(roles));
  for (auto a = cloud.attributes.begin(); a != first_extra; ++a) {
    const bool wanted = std::any_of(first_extra, cloud.attributes.end(),
                                    [&](const Attribute& extra) { return extra.name == a->name; });
    if (wanted && is_zero(*a)) continue;
    taken.insert(a->name);
    kept.push_back(std::move(*a));
  }
  for (auto a = first_extra; a != cloud.attributes.end(); ++a) {
    while (!taken.insert(a->name).second) a->name += '_';
    kept.push_back(std::move(*a));
  }
  cloud.attributes = std::move(kept);
}

FileLayout las_layout(const PointCloud& cloud, const LasHeader& header,
                      const std::vector<LasExtra>& extras, const std::vector<int>& roles) {
  FileLayout layout;
  layout.encoding = Encoding::Las;
  for (const char* name : {"x", "y", "z"}) layout.fields.push_back({name, ScalarType::Float64});
  auto attribute = cloud.attributes.begin();
  const auto first_extra =
      cloud.attributes.end() - static_cast<std::ptrdiff_t>(count_attributes(roles));
  const auto add_attribute = [&] {
    layout.fields.push_back({attribute->name, attribute->type()});
    ++attribute;
  };
  while (attribute != first_extra) add_attribute();
  for (std::size_t k = 0; k < extras.size(); ++k) {
    if (roles[k] == no_role) {
      add_attribute();
    } else {
      layout.fields.push_back({extras[k].name, extras[k].value_type()});
    }
  }
  layout.blocks.push_back({"LAS header", header.bytes});
  for (const LasRecord& record : header.records) {
    if (!record.is_extended && record.description() == las_comments &&
        record.is(las_spec, las_text_id)) {
      add_comments(layout, record.data());
    } else {
      layout.blocks.push_back({record.name(), record.bytes});
    }
  }
  if (!header.gap.empty()) layout.blocks.push_back({"LAS gap", header.gap});
  return layout;
}

std::set<std::string_view> replaced_las_fields(const FileLayout& layout,
                                               const std::vector<LasField>& fields,
                                               const std::vector<LasExtra>& extras) {
  std::set<std::string_view> replaced;
  if (layout.fields.size() < 3 + extras.size()) return replaced;
  const std::size_t first_extra = layout.fields.size() - extras.size();
  std::size_t at = 3;
  for (const LasField& field : fields) {
    if (at < first_extra && layout.fields[at].name == field.name) {
      ++at;
    } else if (std::ranges::find(extras, field.name, &LasExtra::name) != extras.end()) {
      replaced.insert(field.name);
    }
  }
  return replaced;
}

}  // namespace deburr
