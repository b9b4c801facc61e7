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
constexpr std::array<RoleName, 7> coordinate_names{{{"x", 0},
                                                    {"y", 1},
                                                    {"z", 2},
                                                    {"easting", 0},
                                                    {"northing", 1},
                                                    {"height", 2},
                                                    {"elevation", 2}}};

/// Normals have the three names of one of these.
constexpr std::array<std::array<std::string_view, 3>, 3> normal_names{
    {{"nx", "ny", "nz"}, {"normal_x", "normal_y", "normal_z"}, {"normalx", "normaly", "normalz"}}};

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return std::ranges::equal(a, b, {}, lower, lower);
}

/// Whether readers know one of the normals by this name.
bool is_normal_name(std::string_view name) {
  return std::ranges::any_of(normal_names, [&](const auto& three) {
    return std::ranges::any_of(three,
                               [&](std::string_view s) { return equal_ignoring_case(s, name); });
  });
}

/// Marks the names by which normals that are new would be read from fields that were there before:
/// a file with a field ny alone has no normals.
void set_apart_from_normals(std::vector<Column>& columns) {
  for (Column& column : columns) {
    if (column.role != no_role || !is_normal_name(column.name)) continue;
    do {
      column.name += '_';
    } while (std::ranges::count(columns, column.name, &Column::name) > 1);
  }
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
  const auto place_of = [&](std::string_view name) {
    const auto found = std::ranges::find_if(
        names, [&](const std::string& s) { return equal_ignoring_case(s, name); });
    return static_cast<std::size_t>(found - names.begin());
  };
  for (const auto& [name, role] : coordinate_names) {
    const std::size_t place = place_of(name);
    if (find_role(roles, role) == names.size() && place < names.size()) roles[place] = role;
  }
  for (const auto& three : normal_names) {
    std::array<std::size_t, 3> places{};
    std::ranges::transform(three, places.begin(), place_of);
    if (std::ranges::max(places) == names.size()) continue;
    for (std::size_t k = 0; k < 3; ++k) roles[places[k]] = 3 + static_cast<int>(k);
    break;
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
  const bool has_new_normals = role_count == 6 && find_role(roles, 3) == roles.size();
  if (has_new_normals) set_apart_from_normals(columns);

  std::set<std::string_view> all;
  for (const Column& column : columns) {
    if (!all.insert(column.name).second) {
      throw std::invalid_argument(fmt::format("two fields have the name '{}'", column.name));
    }
  }
  return columns;
}

}  // namespace deburr
