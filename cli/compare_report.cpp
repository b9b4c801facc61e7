// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "compare_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace deburr::cli {
namespace {

using Json = nlohmann::ordered_json;

/// A share in [0, 1] as it is read best; a dash where there is nothing to take a share of.
std::string percent(double share) {
  return std::isnan(share) ? "-" : fmt::format("{:.1f} %", 100 * share);
}

/// A number that may not be: what there are no points for, or nothing to compare with.
std::string number(double value, const char* unit = "") {
  return std::isfinite(value) ? fmt::format("{:.6g}{}", value, unit) : "-";
}

/// The mean error at the edges; NaN where no point is near one.
double edge_mean(const FeatureFigures& f) {
  return f.zone.count > 0 ? f.zone.mean : std::numeric_limits<double>::quiet_NaN();
}

std::string row(const char* name, const std::string& values) {
  return fmt::format("{:<11} {}\n", name, values);
}

void add_features(Json& json, const Comparison& c, const FeatureFigures& f) {
  json["sharp_edges"] = f.edges;
  json["sharp_corners"] = f.corners;
  json["edge_count"] = f.zone.count;
  json["edge_mean"] = edge_mean(f);
  json["edge_mean_relative"] = edge_mean(f) / c.error.diagonal;
  json["edge_mean_ratio"] = edge_mean(f) / c.error.mean;
  if (!f.labels) return;
  json["edge_labels"] = f.labels->edge_labels;
  json["edge_precision"] = f.labels->edge_precision;
  json["edge_recall"] = f.labels->edge_recall;
  json["edge_point_recall"] = f.labels->edge_point_recall;
  json["corner_labels"] = f.labels->corner_labels;
  json["corner_precision"] = f.labels->corner_precision;
  json["corner_recall"] = f.labels->corner_recall;
}

void add_one_by_one(Json& json, const Comparison& c) {
  if (c.outliers) {
    json["outlier_count"] = c.outliers->outliers;
    json["outlier_flagged"] = c.outliers->flagged;
    json["outlier_precision"] = c.outliers->precision;
    json["outlier_recall"] = c.outliers->recall;
  }
  if (c.offsets) {
    json["offset_count"] = c.offsets->count;
    json["offset_mean"] = c.offsets->mean;
    json["offset_rms"] = c.offsets->rms;
    if (c.spacing) json["offset_far_share"] = c.offsets->far_share;
  }
}

std::string feature_rows(const Comparison& c, const FeatureFigures& f) {
  const double mean = edge_mean(f);
  const double ratio = mean / c.error.mean;
  std::string text = fmt::format("{:<12} mean error", number(mean));
  if (std::isfinite(ratio)) text += fmt::format(", {:.3g} x that of all points", ratio);
  text = row("at edges", text);
  if (!f.labels) return text;
  return text +
         row("edges", fmt::format("precision {}, recall {}, recall of points {}",
                                  percent(f.labels->edge_precision), percent(f.labels->edge_recall),
                                  percent(f.labels->edge_point_recall))) +
         row("corners", fmt::format("precision {}, recall {}", percent(f.labels->corner_precision),
                                    percent(f.labels->corner_recall)));
}

}  // namespace

Json to_json(const Comparison& c) {
  Json json{{"truth_kind", c.to_mesh ? "mesh" : "cloud"},
            {"count", c.error.count},
            {"non_finite", c.points - c.error.count},
            {"skipped_outliers", c.skipped},
            {"diagonal", c.error.diagonal},
            {"mean", c.error.mean},
            {"rms", c.error.rms},
            {"percentile_95", c.error.percentile_95},
            {"maximum", c.error.maximum},
            {"mean_relative", c.error.mean / c.error.diagonal},
            {"rms_relative", c.error.rms / c.error.diagonal},
            {"percentile_95_relative", c.error.percentile_95 / c.error.diagonal},
            {"maximum_relative", c.error.maximum / c.error.diagonal}};
  if (c.coverage.count > 0) {
    json["coverage_count"] = c.coverage.count;
    json["coverage_mean"] = c.coverage.mean;
    json["coverage_percentile_95"] = c.coverage.percentile_95;
    json["coverage_mean_relative"] = c.coverage.mean / c.coverage.diagonal;
    json["coverage_percentile_95_relative"] = c.coverage.percentile_95 / c.coverage.diagonal;
  }
  if (c.chamfer) json["chamfer"] = *c.chamfer;
  if (c.normals && c.normals->count > 0) {
    json["normal_count"] = c.normals->count;
    json["normal_error"] = c.normals->unoriented;
    json["normal_error_oriented"] = c.normals->oriented;
  }
  if (c.spacing) json["spacing"] = *c.spacing;
  if (c.features) add_features(json, c, *c.features);
  add_one_by_one(json, c);
  json["warnings"] = c.warnings;
  return json;
}

std::string to_text(const Comparison& c) {
  const auto length = [&](const char* name, double value) {
    return row(name, fmt::format("{:<12.6g} {} of the diagonal", value,
                                 number(100 * value / c.error.diagonal, " %")));
  };
  std::string text = row("points", fmt::format("{}", c.error.count)) +
                     row("not finite", fmt::format("{}", c.points - c.error.count));
  if (c.skipped > 0) text += row("skipped", fmt::format("{}", c.skipped));
  text += row("diagonal", fmt::format("{:.6g}", c.error.diagonal)) + length("mean", c.error.mean) +
          length("rms", c.error.rms) + length("95 percent", c.error.percentile_95) +
          length("maximum", c.error.maximum);
  if (c.coverage.count > 0) text += length("coverage", c.coverage.mean);
  if (c.chamfer) text += row("chamfer", number(*c.chamfer));
  if (c.normals && c.normals->count > 0) {
    text += row("normals", fmt::format("{:.3g} degrees off, {:.3g} with their sign",
                                       c.normals->unoriented, c.normals->oriented));
  }
  if (c.features) text += feature_rows(c, *c.features);
  if (c.outliers) {
    text += row("outliers", fmt::format("precision {}, recall {}", percent(c.outliers->precision),
                                        percent(c.outliers->recall)));
  }
  if (c.offsets) {
    text += row("offset", fmt::format("{:<12} mean along the true normals, rms {}",
                                      number(c.offsets->mean), number(c.offsets->rms)));
  }
  return text;
}

}  // namespace deburr::cli
