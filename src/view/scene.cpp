// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "view/scene.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "box.hpp"
#include "view/cloud_packer.hpp"
#include "view/pairing.hpp"
#include "view/statistics.hpp"
#include "view/subsample.hpp"

namespace deburr::view {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t bins = 101;       // odd, so that no movement has one of its own
constexpr double widest_share = 0.999;  // of the magnitudes that the histogram reaches to
constexpr double colour_share = 0.98;   // of the magnitudes within the first range of colours

Json to_json(const Summary& summary) {
  return {{"count", summary.count},
          {"mean", summary.mean},
          {"rms", summary.rms},
          {"p95", summary.percentile_95},
          {"max", summary.maximum}};
}

Json to_json(const Histogram& histogram) {
  return {{"low", histogram.low},
          {"high", histogram.high},
          {"counts", histogram.counts},
          {"below", histogram.below},
          {"above", histogram.above}};
}

Json describe_values(std::span<const double> values) {
  Json json = to_json(summarise(values));
  json["range"] = magnitude_quantile(values, colour_share);
  json["histogram"] = to_json(histogram_of(values, magnitude_quantile(values, widest_share), bins));
  return json;
}

std::vector<std::uint32_t> finite_of(Points points) {
  std::vector<std::uint32_t> indices;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_finite(points[i])) indices.push_back(static_cast<std::uint32_t>(i));
  }
  return indices;
}

Box box_of(const PointCloud& cloud, std::span<const std::uint32_t> chosen) {
  if (chosen.empty()) return {{0, 0, 0}, {0, 0, 0}};
  Box box;
  for (const std::uint32_t i : chosen) box.add(cloud.points[i]);
  return box;
}

/// The points of a pair of clouds: those that are in both first, at the same places.
struct ChosenPairs {
  std::vector<std::uint32_t> before;
  std::vector<std::uint32_t> after;
};

ChosenPairs choose_pairs(const PointCloud& before, const PointCloud& after, const Pairing& pairing,
                         double share, const Execution& execution) {
  std::vector<std::uint32_t> both;
  std::vector<bool> alone(before.size(), true);
  for (std::size_t i = 0; i < after.size(); ++i) {
    alone[pairing.origin[i]] = false;
    if (is_finite(after.points[i]) && is_finite(before.points[pairing.origin[i]])) {
      both.push_back(static_cast<std::uint32_t>(i));
    }
  }
  std::vector<std::uint32_t> rest;
  for (const std::uint32_t i : finite_of(before.points)) {
    if (alone[i]) rest.push_back(i);
  }
  const auto part = [share](std::size_t count) {
    return static_cast<std::size_t>(share * static_cast<double>(count));
  };
  ChosenPairs chosen;
  chosen.after = even_subsample(after.points, both, part(both.size()), execution);
  for (const std::uint32_t i : chosen.after) chosen.before.push_back(pairing.origin[i]);
  std::ranges::copy(even_subsample(before.points, rest, part(rest.size()), execution),
                    std::back_inserter(chosen.before));
  return chosen;
}

}  // namespace

Scene make_scene(const Request& request, std::size_t room, const SceneOptions& options,
                 const Execution& execution) {
  Pairing pairing = pair_points(request);
  CloudPacker before(request.before, options, execution);
  std::optional<CloudPacker> after;
  if (request.after) after.emplace(*request.after, options, execution);
  if (!pairing.displacement.empty()) {
    (after ? *after : before).set_displacement(pairing.displacement);
  }
  if (pairing.paired) before.adopt_flags(*after, pairing.origin);

  // Four characters hold three bytes.
  const double bytes = static_cast<double>(room) / 4 * 3;
  const double wanted =
      static_cast<double>(before.cloud().size() * before.bytes_per_point()) +
      (after ? static_cast<double>(after->cloud().size() * after->bytes_per_point()) : 0);
  const double share = wanted > bytes ? bytes / wanted : 1;
  const auto alone = [&](const PointCloud& cloud) {
    const std::vector<std::uint32_t> finite = finite_of(cloud.points);
    return even_subsample(cloud.points, finite,
                          static_cast<std::size_t>(share * static_cast<double>(finite.size())),
                          execution);
  };

  Scene scene{.paired = pairing.paired, .warnings = std::move(pairing.warnings)};
  PackedArrays arrays;
  Json clouds = Json::array();
  if (pairing.paired) {
    const ChosenPairs chosen =
        choose_pairs(before.cloud(), after->cloud(), pairing, share, execution);
    // On one grid, so that a point that did not move has not moved.
    Box box = box_of(before.cloud(), chosen.before);
    const Box other = box_of(after->cloud(), chosen.after);
    if (!chosen.after.empty()) {
      box.add(other.low);
      box.add(other.high);
    }
    clouds.push_back(before.pack(chosen.before, box, arrays));
    clouds.push_back(after->pack(chosen.after, box, arrays));
  } else {
    for (const CloudPacker* packer : {&before, after ? &*after : nullptr}) {
      if (packer == nullptr) continue;
      const std::vector<std::uint32_t> chosen = alone(packer->cloud());
      clouds.push_back(packer->pack(chosen, box_of(packer->cloud(), chosen), arrays));
    }
  }
  for (const Json& cloud : clouds) scene.shown.push_back(cloud["shown"]);
  const std::size_t removed =
      pairing.paired
          ? before.cloud().size() - std::min(before.cloud().size(), pairing.origin.size())
          : 0;
  Json json{{"format", 1},
            {"up", to_string(options.up)},
            {"paired", pairing.paired},
            {"removed", removed},
            {"clouds", std::move(clouds)}};
  if (!pairing.displacement.empty()) {
    json["displacement"] = describe_values(pairing.displacement);
    json["displacement"]["signed"] = pairing.is_signed;
  }
  if (!request.before.truth_distance.empty()) {
    json["truth"] = Json::array({to_json(summarise(request.before.truth_distance))});
    if (after) json["truth"].push_back(to_json(summarise(request.after->truth_distance)));
    json["truthRange"] = magnitude_quantile(request.before.truth_distance, colour_share);
  }
  scene.description = json.dump(-1, ' ', true, Json::error_handler_t::replace);
  scene.data = arrays.take();
  return scene;
}

}  // namespace deburr::view
