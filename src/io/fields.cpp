// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "io/scalar_type.hpp"

namespace deburr {
namespace {

struct RoleName {
  std::string_view name;
  int role;
};

/// In the order in which they are looked for.
constexpr std::array<RoleName, 16> known_names{{{"x", 0},
                                                {"y", 1},
                                                {"z", 2},
                                                {"easting", 0},
                                                {"northing", 1},
                                                {"height", 2},
                                                {"elevation", 2},
                                                {"nx", 3},
                                                {"ny", 4},
                                                {"nz", 5},
                                                {"normal_x", 3},
                                                {"normal_y", 4},
                                                {"normal_z", 5},
                                                {"normalx", 3},
                                                {"normaly", 4},
                                                {"normalz", 5}}};

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return std::ranges::equal(a, b, {}, lower, lower);
}

void check_size(std::string_view what, const Attribute& attribute, std::size_t size) {
  const auto& offsets = attribute.offsets;
  const std::size_t count = value_count(attribute);
  const bool fits = attribute.is_list()
                        ? offsets.size() == size + 1 && offsets.front() == 0 &&
                              offsets.back() == count && std::ranges::is_sorted(offsets)
                        : count == size;
  if (!fits) {
    throw std::invalid_argument(
        fmt::format("{} '{}' must have a value for each of {} items, got {}", what, attribute.name,
                    size, attribute.is_list() ? offsets.size() - 1 : count));
  }
}

void check_sizes(const PointCloud& cloud) {
  if (!cloud.normals.empty() && cloud.normals.size() != cloud.size()) {
    throw std::invalid_argument(
        fmt::format("normals must be none or one for each of {} points, "
                    "got {}",
                    cloud.size(), cloud.normals.size()));
  }
  for (const Attribute& a : cloud.attributes) check_size("attribute", a, cloud.size());
  for (const Element& element : cloud.layout.elements) {
    for (const Attribute& a : element.attributes) check_size(element.name, a, element.size);
  }
}

}  // namespace

std::vector<int> find_roles(const std::vector<std::string>& names) {
  std::vector<int> roles(names.size(), no_role);
  for (const auto& [name, role] : known_names) {
    if (find_role(roles, role) < names.size()) continue;
    const auto found = std::ranges::find_if(
        names, [&](const std::string& s) { return equal_ignoring_case(s, name); });
    if (found != names.end()) roles[static_cast<std::size_t>(found - names.begin())] = role;
  }
  if (std::ranges::count_if(roles, [](int role) { return role >= 3; }) != 3) {
    std::ranges::replace_if(
        roles, [](int role) { return role >= 3; }, no_role);
  }
  return roles;
}

std::size_t find_role(const std::vector<int>& roles, int role) {
  return static_cast<std::size_t>(std::ranges::find(roles, role) - roles.begin());
}

std::string_view missing_coordinate(const std::vector<int>& roles) {
  for (int role = 0; role < 3; ++role) {
    if (find_role(roles, role) == roles.size()) return role_names[static_cast<std::size_t>(role)];
  }
  return {};
}

std::vector<Column> columns_of(const PointCloud& cloud) {
  check_sizes(cloud);
  std::vector<std::string> names;
  names.reserve(cloud.layout.fields.size());
  for (const Field& field : cloud.layout.fields) names.push_back(field.name);
  const std::vector<int> roles = find_roles(names);

  std::vector<Column> columns;
  const auto add_coordinate = [&](int role, const Field& field, bool in_layout) {
    const std::vector<Vec3>& vectors = role < 3 ? cloud.points : cloud.normals;
    columns.push_back({field.name, field.type, role, in_layout, &vectors, nullptr});
  };
  const auto add_missing_coordinates = [&](int begin, int end) {
    for (int role = begin; role < end; ++role) {
      if (find_role(roles, role) < roles.size()) continue;
      add_coordinate(role, {std::string(role_names[static_cast<std::size_t>(role)])}, false);
    }
  };
  const int role_count = cloud.normals.empty() ? 3 : 6;
  std::set<const Attribute*> added;

  add_missing_coordinates(0, 3);
  for (std::size_t k = 0; k < names.size(); ++k) {
    const Field& field = cloud.layout.fields[k];
    const auto found = std::ranges::find(cloud.attributes, field.name, &Attribute::name);
    if (roles[k] != no_role && roles[k] < role_count) {
      add_coordinate(roles[k], field, true);
    } else if (found != cloud.attributes.end()) {
      columns.push_back({field.name, found->type(), no_role, true, nullptr, &*found});
      added.insert(&*found);
    }
  }
  add_missing_coordinates(3, role_count);
  for (const Attribute& a : cloud.attributes) {
    if (!added.contains(&a)) columns.push_back({a.name, a.type(), no_role, false, nullptr, &a});
  }

  std::set<std::string_view> all;
  for (const Column& column : columns) {
    if (!all.insert(column.name).second) {
      throw std::invalid_argument(fmt::format("two fields have the name '{}'", column.name));
    }
  }
  return columns;
}

}  // namespace deburr
