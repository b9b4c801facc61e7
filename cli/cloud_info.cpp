// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud_info.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <tuple>

#include "deburr/neighborhoods.hpp"
#include "deburr/noise.hpp"
#include "interrupt.hpp"

namespace deburr::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t spacing_neighbors = 12;

const char* type_name(ScalarType type) {
  constexpr std::array names{"int8",  "uint8",  "int16",   "uint16",  "int32", "uint32",
                             "int64", "uint64", "float32", "float64", "text"};
  static_assert(names.size() == std::variant_size_v<Values>);
  return names.at(static_cast<std::size_t>(type));
}

FieldInfo describe(const Attribute& attribute) {
  return {attribute.name, type_name(attribute.type()), attribute.is_list()};
}

std::vector<FieldInfo> describe_fields(const PointCloud& cloud) {
  std::vector<FieldInfo> fields;
  for (const Field& field : cloud.layout.fields) {
    const auto attribute = std::ranges::find(cloud.attributes, field.name, &Attribute::name);
    fields.push_back(attribute != cloud.attributes.end()
                         ? describe(*attribute)
                         : FieldInfo{field.name, type_name(field.type)});
  }
  return fields;
}

/// The places of the finite points, each once.
std::vector<Vec3> distinct_points(std::vector<Vec3> finite) {
  const auto key = [](const Vec3& p) { return std::tie(p.x, p.y, p.z); };
  std::ranges::sort(finite, {}, key);
  const auto rest = std::ranges::unique(finite);
  finite.erase(rest.begin(), rest.end());
  return finite;
}

Box bounding_box(Points points) {
  Box box{points.front(), points.front()};
  for (const Vec3& p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
  }
  return box;
}

Json to_json(const std::vector<FieldInfo>& fields) {
  Json json = Json::array();
  for (const FieldInfo& field : fields) {
    json.push_back({{"name", field.name}, {"type", field.type}, {"list", field.list}});
  }
  return json;
}

Json to_json(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

std::string to_text(const std::vector<FieldInfo>& fields) {
  std::vector<std::string> parts;
  parts.reserve(fields.size());
  for (const FieldInfo& field : fields) {
    parts.push_back(fmt::format("{} {}{}", field.name, field.list ? "list of " : "", field.type));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

CloudInfo measure(const PointCloud& cloud, int threads, ProgressBar& bar) {
  CloudInfo info;
  info.points = cloud.size();
  std::vector<Vec3> finite;
  std::ranges::copy_if(cloud.points, std::back_inserter(finite), is_finite);
  info.non_finite = cloud.size() - finite.size();
  if (!finite.empty()) info.box = bounding_box(finite);

  const std::size_t finite_count = finite.size();
  const std::vector<Vec3> distinct = distinct_points(std::move(finite));
  info.duplicates = finite_count - distinct.size();
  const auto part = [&](std::string_view stage, double from, double to) {
    return Execution{threads, bar.part(stage, from, to), interrupted};
  };
  const Neighborhoods nearest =
      find_neighbors(distinct, {.max_count = spacing_neighbors}, part("spacing", 0, 0.3));
  info.spacing = mean_neighbor_distance(distinct, nearest, part("spacing", 0.3, 0.35));
  info.noise = estimate_noise(distinct, part("noise", 0.35, 1));

  info.fields = describe_fields(cloud);
  for (const Element& element : cloud.layout.elements) {
    ElementInfo& other = info.elements.emplace_back(element.name, element.size);
    std::ranges::transform(element.attributes, std::back_inserter(other.fields), describe);
  }
  for (const HeaderBlock& block : cloud.layout.blocks) info.blocks.push_back(block.name);
  info.comments = cloud.layout.comments.size();
  return info;
}

nlohmann::ordered_json to_json(const CloudInfo& info) {
  Json elements = Json::array();
  for (const ElementInfo& element : info.elements) {
    elements.push_back(
        {{"name", element.name}, {"size", element.size}, {"fields", to_json(element.fields)}});
  }
  Json box;
  if (info.box) box = {{"min", to_json(info.box->low)}, {"max", to_json(info.box->high)}};
  return {{"points", info.points},
          {"non_finite", info.non_finite},
          {"duplicates", info.duplicates},
          {"bounding_box", box},
          {"spacing", info.spacing},
          {"noise", info.noise},
          {"noise_in_spacings", info.noise_in_spacings()},
          {"fields", to_json(info.fields)},
          {"elements", elements},
          {"blocks", info.blocks},
          {"comments", info.comments}};
}

std::string to_text(const CloudInfo& info) {
  std::string text;
  const auto line = [&text](const char* name, const std::string& value) {
    text += as_line(fmt::format("{:<11} {}", name, value));
  };
  line("points", fmt::format("{}", info.points));
  line("not finite", fmt::format("{}", info.non_finite));
  line("duplicates", fmt::format("{}", info.duplicates));
  if (info.box) {
    const auto& [low, high] = *info.box;
    // More digits than elsewhere: survey coordinates differ only behind the sixth.
    line("x", fmt::format("{:.12g} to {:.12g}", low.x, high.x));
    line("y", fmt::format("{:.12g} to {:.12g}", low.y, high.y));
    line("z", fmt::format("{:.12g} to {:.12g}", low.z, high.z));
  }
  line("spacing", fmt::format("{:.6g}", info.spacing));
  line("noise",
       fmt::format("{:.6g} (estimated; {:.3g} spacings)", info.noise, info.noise_in_spacings()));
  line("fields", to_text(info.fields));
  for (const ElementInfo& element : info.elements) {
    line("element",
         fmt::format("{}: {} of ({})", element.name, element.size, to_text(element.fields)));
  }
  for (const std::string& block : info.blocks) line("block", block);
  line("comments", fmt::format("{}", info.comments));
  return text;
}

}  // namespace deburr::cli
