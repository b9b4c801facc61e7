// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "view/still.hpp"

#include <algorithm>
#include <utility>

#include "deburr/error.hpp"
#include "deburr/neighborhoods.hpp"
#include "deburr/normals.hpp"
#include "quantile.hpp"
#include "require.hpp"
#include "spatial_order.hpp"
#include "view/colours.hpp"
#include "view/fields.hpp"
#include "view/legend.hpp"
#include "view/pairing.hpp"
#include "view/statistics.hpp"
#include "view/subsample.hpp"

namespace deburr::view {
namespace {

constexpr double colour_share = 0.98;
constexpr double disc_in_spacings = 0.95;  // closes a surface of random points
/// How much brightness tells the shape where colours tell something else.
constexpr double light_beside_colours = 0.35;

[[noreturn]] void lacks(const ShownCloud& shown, const char* what) {
  throw DataError(shown.name + ": " + what);
}

std::vector<Rgb> displacement_colours(const ShownCloud& shown, const Pairing& pairing,
                                      StillPicture& still, std::span<const std::uint32_t> chosen) {
  if (pairing.displacement.empty()) lacks(shown, "no field deburr_displacement");
  still.is_signed = pairing.is_signed;
  if (!(still.range > 0)) still.range = magnitude_quantile(pairing.displacement, colour_share);
  const double low = still.is_signed ? -still.range : 0;
  const double width = still.range - low;
  std::vector<Rgb> colours;
  for (const std::uint32_t i : chosen) {
    const double share = width > 0 ? (pairing.displacement[i] - low) / width : 0.5;
    colours.push_back(still.is_signed ? sample(diverging, share) : sample(sequential, share));
  }
  return colours;
}

std::vector<Rgb> label_colours_of(const ShownCloud& shown, std::span<const std::uint32_t> chosen) {
  const std::vector<std::uint8_t> labels = labels_of(*shown.cloud);
  if (labels.empty()) lacks(shown, "no field deburr_label");
  const std::vector<std::uint8_t> outliers = outliers_of(*shown.cloud);
  std::vector<Rgb> colours;
  for (const std::uint32_t i : chosen) {
    const bool known = labels[i] < label_colours.size();
    const bool is_outlier = !outliers.empty() && outliers[i] != 0;
    colours.push_back(is_outlier ? outlier_colour
                      : known    ? label_colours[labels[i]]
                                 : unknown_colour);
  }
  return colours;
}

std::vector<Rgb> file_colours(const ShownCloud& shown, std::span<const std::uint32_t> chosen) {
  const std::optional<ColourField> field = ColourField::of(*shown.cloud);
  if (!field) lacks(shown, "no fields red green blue");
  std::vector<Rgb> colours;
  for (const std::uint32_t i : chosen) colours.push_back((*field)[i]);
  return colours;
}

std::vector<std::uint32_t> choose(const ShownCloud& shown, std::size_t most,
                                  const Execution& execution) {
  std::vector<std::uint32_t> finite;
  for (std::size_t i = 0; i < shown.cloud->size(); ++i) {
    if (is_finite(shown.cloud->points[i])) finite.push_back(static_cast<std::uint32_t>(i));
  }
  if (finite.empty()) lacks(shown, "no finite point to draw");
  return even_subsample(shown.cloud->points, finite, most, execution);
}

/// The median of the mean distances from points to their neighbours: a single point far away makes
/// no difference.
double usual_distance(Points points, const Neighborhoods& nearest) {
  std::vector<double> distances;
  for (std::size_t i = 0; i < points.size(); ++i) {
    double sum = 0;
    for (const std::uint32_t j : nearest[i]) sum += norm(points[j] - points[i]);
    if (!nearest[i].empty()) distances.push_back(sum / static_cast<double>(nearest[i].size()));
  }
  return quantile(std::move(distances), 0.5);
}

/// What the colours mean; without a map and patches for those that mean themselves.
Legend legend_of(StillColour colour, const StillPicture& still) {
  if (colour == StillColour::Displacement) {
    return still.is_signed ? Legend{.title = "displacement along the normals, in file units",
                                    .map = diverging,
                                    .low = -still.range,
                                    .high = still.range}
                           : Legend{.title = "displacement, in file units",
                                    .map = sequential,
                                    .low = 0,
                                    .high = still.range};
  }
  Legend legend;
  if (colour != StillColour::Labels) return legend;
  for (std::size_t i = 0; i < label_colours.size(); ++i) {
    legend.patches.push_back({std::string(to_string(static_cast<Feature>(i))), label_colours[i]});
  }
  legend.patches.push_back({"outlier", outlier_colour});
  return legend;
}

}  // namespace

StillPicture draw_still(const Request& request, const StillOptions& options,
                        const Execution& execution) {
  require(options.range >= 0, "range", ">= 0", options.range);
  const ShownCloud& shown = request.after ? *request.after : request.before;
  const std::vector<std::uint32_t> chosen = choose(shown, options.max_points, execution);
  const std::vector<Vec3> points = gather<Vec3>(shown.cloud->points, chosen);
  StillPicture still{.picture = {}, .points = points.size(), .range = options.range};
  RasterOptions raster = options.raster;
  std::vector<Rgb> colours(points.size(), plain_colour);
  if (options.colour != StillColour::Normals) raster.light = light_beside_colours;
  if (options.colour == StillColour::Displacement) {
    colours = displacement_colours(shown, pair_points(request), still, chosen);
  } else if (options.colour == StillColour::Labels) {
    colours = label_colours_of(shown, chosen);
  } else if (options.colour == StillColour::OfFile) {
    colours = file_colours(shown, chosen);
  }

  const Neighborhoods nearest = find_neighbors(points, {.max_count = options.neighbors}, execution);
  const double spacing = usual_distance(points, nearest);
  const std::vector<Vec3> normals = shown.cloud->normals.empty()
                                        ? estimate_normals(points, nearest, execution)
                                        : gather<Vec3>(shown.cloud->normals, chosen);
  const Legend legend = legend_of(options.colour, still);
  LegendSize strip;
  if (options.legend && !(legend.map.empty() && legend.patches.empty())) {
    strip = size_of(legend, raster.width, raster.height);
  }
  still.legend = strip.scale > 0;
  raster.height -= strip.height;
  const Camera camera = Camera::fit(options.view, points, raster.width, raster.height, options.up);
  still.picture = draw({.points = points,
                        .normals = normals,
                        .colours = colours,
                        .radius = spacing > 0 ? disc_in_spacings * spacing : 1},
                       camera, raster, execution);
  append(legend, strip, raster.background, still.picture);
  return still;
}

}  // namespace deburr::view
