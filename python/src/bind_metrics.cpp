// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>

#include "arrays.hpp"
#include "bind.hpp"
#include "deburr/clean_metrics.hpp"
#include "deburr/cloud_metrics.hpp"
#include "deburr/feature_metrics.hpp"
#include "deburr/metrics.hpp"
#include "deburr/normal_metrics.hpp"
#include "deburr/sharp_features.hpp"
#include "run.hpp"
#include "sizes.hpp"

namespace deburr::python {
namespace {

using namespace nb::literals;

nb::tuple to_python(const DistanceError& e) {
  return nb::make_tuple(e.mean, e.rms, e.percentile_95, e.maximum, e.diagonal, e.count);
}

nb::tuple to_python(const NormalError& e) {
  return nb::make_tuple(e.unoriented, e.oriented, e.count);
}

/// Sharp edges as (E, 2, 3), corners as (C, 3).
nb::tuple to_python(SharpFeatures sharp) {
  const std::size_t count = sharp.edges.size();
  static_assert(sizeof(sharp.edges.front()) == 6 * sizeof(double));
  auto [data, owner] = hand_over(std::move(sharp.edges));
  nb::ndarray<nb::numpy, double, nb::shape<-1, 2, 3>> edges(reinterpret_cast<double*>(data),
                                                            {count, 2, 3}, owner);
  return nb::make_tuple(edges, to_array(std::move(sharp.corners)));
}

using EdgeArray = nb::ndarray<const double, nb::shape<-1, 2, 3>, nb::c_contig, nb::device::cpu>;

SharpFeatures make_sharp(const EdgeArray& edges, const VectorArray& corners) {
  SharpFeatures sharp;
  const auto* const ends = reinterpret_cast<const Vec3*>(edges.data());
  for (std::size_t i = 0; i < edges.shape(0); ++i) {
    sharp.edges.push_back({ends[2 * i], ends[2 * i + 1]});
  }
  const Points points = as_span(corners);
  sharp.corners.assign(points.begin(), points.end());
  return sharp;
}

/// Runs `measure(mesh, execution)` on the mesh of two arrays.
template <typename Measure>
auto on_mesh(const VectorArray& vertices, const TriangleArray& triangles, int threads,
             const Measure& measure) {
  return run(threads, nb::none(), [&](const Execution& execution) {
    return measure(make_mesh(vertices, triangles), execution);
  });
}

void bind_surface_metrics(nb::module_& m) {
  m.def(
      "distance_to_surface",
      [](const VectorArray& points, const VectorArray& vertices, const TriangleArray& triangles,
         int threads) {
        return to_array(on_mesh(vertices, triangles, threads, [&](const auto& mesh, const auto& e) {
          return distance_to_surface(as_span(points), mesh, e);
        }));
      },
      "points"_a, "vertices"_a, "triangles"_a, "threads"_a);
  m.def(
      "compare_to_surface",
      [](const VectorArray& points, const VectorArray& vertices, const TriangleArray& triangles,
         int threads) {
        return to_python(
            on_mesh(vertices, triangles, threads, [&](const auto& mesh, const auto& e) {
              return compare_to_surface(as_span(points), mesh, e);
            }));
      },
      "points"_a, "vertices"_a, "triangles"_a, "threads"_a);
  m.def(
      "surface_coverage",
      [](const VectorArray& points, const VectorArray& vertices, const TriangleArray& triangles,
         std::int64_t samples, std::uint64_t seed, int threads) {
        const CoverageOptions options{to_size("samples", samples), seed};
        return to_python(
            on_mesh(vertices, triangles, threads, [&](const auto& mesh, const auto& e) {
              return surface_coverage(as_span(points), mesh, options, e);
            }));
      },
      "points"_a, "vertices"_a, "triangles"_a, "samples"_a, "seed"_a, "threads"_a);
  m.def(
      "mean_spacing",
      [](const VectorArray& vertices, const TriangleArray& triangles, std::int64_t count) {
        return mean_spacing(make_mesh(vertices, triangles), to_size("count", count));
      },
      "vertices"_a, "triangles"_a, "count"_a);
  m.def(
      "normal_error_to_surface",
      [](const VectorArray& points, const VectorArray& normals, const VectorArray& vertices,
         const TriangleArray& triangles, int threads) {
        return to_python(
            on_mesh(vertices, triangles, threads, [&](const auto& mesh, const auto& e) {
              return normal_error(as_span(points), as_span(normals), mesh, e);
            }));
      },
      "points"_a, "normals"_a, "vertices"_a, "triangles"_a, "threads"_a);
}

void bind_feature_metrics(nb::module_& m) {
  m.def(
      "find_sharp_features",
      [](const VectorArray& vertices, const TriangleArray& triangles) {
        return to_python(on_mesh(vertices, triangles, 0, [](const auto& mesh, const auto&) {
          return find_sharp_features(mesh);
        }));
      },
      "vertices"_a, "triangles"_a);
  m.def(
      "edge_error",
      [](const VectorArray& points, const VectorArray& vertices, const TriangleArray& triangles,
         const EdgeArray& edges, const VectorArray& corners, double spacing, int threads) {
        const SharpFeatures sharp = make_sharp(edges, corners);
        return to_python(
            on_mesh(vertices, triangles, threads, [&](const auto& mesh, const auto& e) {
              return edge_error(as_span(points), mesh, sharp, spacing, e);
            }));
      },
      "points"_a, "vertices"_a, "triangles"_a, "edges"_a, "corners"_a, "spacing"_a, "threads"_a);
  m.def(
      "score_features",
      [](const VectorArray& points, const ValueArray<std::uint8_t>& labels, const EdgeArray& edges,
         const VectorArray& corners, double spacing, int threads) {
        const SharpFeatures sharp = make_sharp(edges, corners);
        const FeatureScore s = run(threads, nb::none(), [&](const Execution& execution) {
          return score_features(as_span(points), as_features(labels), sharp, spacing, execution);
        });
        return nb::make_tuple(s.edge_precision, s.edge_recall, s.edge_point_recall,
                              s.corner_precision, s.corner_recall, s.edge_labels, s.corner_labels);
      },
      "points"_a, "labels"_a, "edges"_a, "corners"_a, "spacing"_a, "threads"_a);
}

void bind_cloud_metrics(nb::module_& m) {
  m.def(
      "distance_to_cloud",
      [](const VectorArray& points, const VectorArray& cloud, int threads) {
        return to_array(run(threads, nb::none(), [&](const Execution& execution) {
          return distance_to_cloud(as_span(points), as_span(cloud), execution);
        }));
      },
      "points"_a, "cloud"_a, "threads"_a);
  m.def(
      "compare_to_cloud",
      [](const VectorArray& points, const VectorArray& truth, int threads) {
        const CloudError e = run(threads, nb::none(), [&](const Execution& execution) {
          return compare_to_cloud(as_span(points), as_span(truth), execution);
        });
        return nb::make_tuple(to_python(e.to_truth), to_python(e.coverage), e.chamfer);
      },
      "points"_a, "truth"_a, "threads"_a);
  m.def(
      "normal_error_to_cloud",
      [](const VectorArray& points, const VectorArray& normals, const VectorArray& truth,
         const VectorArray& true_normals, int threads) {
        return to_python(run(threads, nb::none(), [&](const Execution& execution) {
          return normal_error(as_span(points), as_span(normals), as_span(truth),
                              as_span(true_normals), execution);
        }));
      },
      "points"_a, "normals"_a, "truth"_a, "true_normals"_a, "threads"_a);
  m.def(
      "offset_error",
      [](const VectorArray& points, const VectorArray& clean, const VectorArray& normals,
         double far) {
        const OffsetError e = offset_error(as_span(points), as_span(clean), as_span(normals), far);
        return nb::make_tuple(e.mean, e.rms, e.far_share, e.count);
      },
      "points"_a, "clean"_a, "normals"_a, "far"_a);
  m.def(
      "score_outliers",
      [](const ValueArray<std::uint8_t>& flags, const ValueArray<std::uint8_t>& truth) {
        const OutlierScore s = score_outliers(as_span(flags), as_span(truth));
        return nb::make_tuple(s.precision, s.recall, s.flagged, s.outliers);
      },
      "flags"_a, "truth"_a);
}

}  // namespace

void bind_metrics(nb::module_& m) {
  bind_surface_metrics(m);
  bind_feature_metrics(m);
  bind_cloud_metrics(m);
  m.def("surface_coverage_defaults", [] {
    nb::dict values;
    values["samples"] = CoverageOptions{}.samples;
    values["seed"] = CoverageOptions{}.seed;
    return values;
  });
}

}  // namespace deburr::python
