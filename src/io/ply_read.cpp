// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "io/fields.hpp"
#include "io/lines.hpp"
#include "io/ply.hpp"
#include "io/ply_body.hpp"
#include "io/ply_header.hpp"
#include "io/scalar_type.hpp"

namespace deburr {
namespace {

Attribute make_attribute(const PlyProperty& property, std::size_t size) {
  Attribute attribute{property.name, {}, {}, property.length_type};
  attribute.values = zeros(property.type, property.is_list ? 0 : size);
  if (property.is_list) {
    attribute.offsets.reserve(size + 1);
    attribute.offsets.push_back(0);
  }
  return attribute;
}

std::vector<int> roles_of(const PlyElement& vertex) {
  std::vector<std::string> names;
  names.reserve(vertex.properties.size());
  for (const PlyProperty& p : vertex.properties) names.push_back(p.is_list ? "" : p.name);
  return find_roles(names);
}

void read_vertices(PlyBodyReader& body, const PlyElement& vertex, PointCloud& cloud) {
  const std::vector<int> roles = roles_of(vertex);
  resize_large(cloud.points, vertex.size);
  if (std::ranges::count(roles, 3) > 0) resize_large(cloud.normals, vertex.size);
  for (std::size_t k = 0; k < roles.size(); ++k) {
    const PlyProperty& p = vertex.properties[k];
    cloud.layout.fields.push_back({p.name, p.type});
    if (roles[k] == no_role) cloud.attributes.push_back(make_attribute(p, vertex.size));
  }
  std::vector<PlyTarget> targets;
  auto attribute = cloud.attributes.begin();
  for (std::size_t k = 0; k < roles.size(); ++k) {
    if (roles[k] == no_role) {
      targets.push_back({vertex.properties[k], nullptr, nullptr, &*attribute++});
    } else {
      targets.push_back({vertex.properties[k], roles[k] < 3 ? &cloud.points : &cloud.normals,
                         axes[static_cast<std::size_t>(roles[k]) % 3], nullptr});
    }
  }
  body.read(vertex, targets);
}

Element read_element(PlyBodyReader& body, const PlyElement& header) {
  Element element{header.name, header.size, {}, false};
  for (const PlyProperty& p : header.properties) {
    element.attributes.push_back(make_attribute(p, header.size));
  }
  std::vector<PlyTarget> targets;
  for (std::size_t k = 0; k < element.attributes.size(); ++k) {
    targets.push_back({header.properties[k], nullptr, nullptr, &element.attributes[k]});
  }
  body.read(header, targets);
  return element;
}

}  // namespace

Match match_ply(std::string_view data) {
  const bool is_ply =
      data.starts_with("ply") && (data.size() == 3 || is_blank(data[3]) || data[3] == '\n');
  return is_ply ? Match::Sure : Match::No;
}

PointCloud read_ply(const Source& source) {
  PlyHeader header = parse_ply_header(source);
  const auto vertex = std::ranges::find(header.elements, "vertex", &PlyElement::name);
  if (vertex == header.elements.end()) source.fail("the file has no element 'vertex'");
  const std::string_view missing = missing_coordinate(roles_of(*vertex));
  if (!missing.empty()) {
    source.fail(fmt::format("element 'vertex' has no property '{}'", missing));
  }

  PointCloud cloud;
  PlyBodyReader body(source, header);
  for (const PlyElement& element : header.elements) {
    body.check_size(element);
    const PlyPlace start = body.place();
    if (&element == &*vertex) {
      read_vertices(body, element, cloud);
    } else {
      cloud.layout.elements.push_back(read_element(body, element));
      cloud.layout.elements.back().before_points = &element < &*vertex;
      check_faces(source, header.encoding, start, cloud.layout.elements.back(), vertex->size);
    }
  }
  cloud.layout.encoding = header.encoding;
  cloud.layout.comments = std::move(header.comments);
  cloud.layout.obj_info = std::move(header.obj_info);
  return cloud;
}

}  // namespace deburr
