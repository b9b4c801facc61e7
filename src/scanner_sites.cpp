// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>

#include "deburr/error.hpp"
#include "parallel.hpp"
#include "synth_sites.hpp"
#include "triangle_bvh.hpp"
#include "unit_circle.hpp"

namespace deburr {
namespace {

/// Distance of the scanners from the middle of the box, in diagonals. The sphere around the box
/// has half a diagonal as its radius: it is seen within an angle whose sine is 1/3.
constexpr double away = 1.5;
const double cos_view = std::sqrt(8.0) / 3;

Direction turn(const Direction& a, const Direction& b) {
  return {a.cos * b.cos - a.sin * b.sin, a.sin * b.cos + a.cos * b.sin};
}

/// A rotation by 2 atan(t): rational, so that its bits are the same on every machine.
Direction rotation(double t) { return {(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)}; }

/// Equal angles across the view, ascending; one of them is that of `first`.
std::vector<Direction> fan(const Direction& step, const Direction& first) {
  std::vector<Direction> angles;
  const Direction back{step.cos, -step.sin};
  for (Direction d = turn(first, back); d.cos >= cos_view; d = turn(d, back)) angles.push_back(d);
  std::ranges::reverse(angles);
  for (Direction d = first; d.cos >= cos_view; d = turn(d, step)) angles.push_back(d);
  return angles;
}

Vec3 unit_vector(const Vec3& v) { return (1 / norm(v)) * v; }

/// Angles of one scanner's grid of rays, as fractions of the angle between two of them.
struct Shift {
  double azimuth, elevation;
};

/// Where rays from one scanner meet the surface, line by line, for angles of 2 atan(t) between
/// them.
std::vector<Site> scan_from(const TriangleBvh& bvh, const Vec3& from, const Vec3& ahead,
                            std::uint32_t scanner, double t, const Shift& shift,
                            const Execution& execution) {
  const std::vector<Direction> azimuths = fan(rotation(t), rotation(t * shift.azimuth));
  const std::vector<Direction> elevations = fan(rotation(t), rotation(t * shift.elevation));
  const Vec3 right = unit_vector(cross(ahead, {0, 0, 1}));
  const Vec3 up = cross(right, ahead);
  const std::size_t rays = elevations.size() * azimuths.size();
  constexpr std::size_t at_once = std::size_t{1} << 20;  // to bound the memory
  std::vector<std::optional<RayHit>> hits;
  std::vector<Site> sites;
  for (std::size_t begin = 0; begin < rays; begin += at_once) {
    const std::size_t end = std::min(rays, begin + at_once);
    hits.assign(end - begin, std::nullopt);
    const auto part = [&](std::size_t i) {
      return static_cast<double>(i) / static_cast<double>(rays);
    };
    parallel_for(hits.size(), sub_execution(execution, "points", part(begin), part(end)),
                 [&](std::size_t i) {
                   const Direction& elevation = elevations[(begin + i) / azimuths.size()];
                   const Direction& azimuth = azimuths[(begin + i) % azimuths.size()];
                   const Vec3 level = azimuth.cos * ahead + azimuth.sin * right;
                   hits[i] = bvh.first_hit(from, elevation.cos * level + elevation.sin * up);
                 });
    for (const std::optional<RayHit>& hit : hits) {
      if (hit) sites.push_back({{hit->point, hit->triangle}, scanner});
    }
  }
  return sites;
}

using Shifts = std::array<Shift, scanner_count>;

std::vector<Site> scan_from_all(const TriangleBvh& bvh, const Box& box, double t,
                                const Shifts& shifts, const Execution& execution) {
  const auto scanners = scanner_positions(box);
  std::vector<Site> sites;
  for (std::uint32_t k = 0; k < scanner_count; ++k) {
    const std::vector<Site> more = scan_from(
        bvh, scanners.at(k), unit_vector(middle(box) - scanners.at(k)), k, t, shifts.at(k),
        sub_execution(execution, "points", static_cast<double>(k) / scanner_count,
                      static_cast<double>(k + 1) / scanner_count));
    sites.insert(sites.end(), more.begin(), more.end());
  }
  return sites;
}

/// Leaves a random choice of `count`, in their order.
/// Source: Knuth, The art of computer programming, volume 2, algorithm 3.4.2S.
void choose(std::vector<Site>& sites, std::size_t count, Random& random) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < sites.size() && kept < count; ++i) {
    const auto left = static_cast<double>(sites.size() - i);
    if (random.uniform() * left < static_cast<double>(count - kept)) sites[kept++] = sites[i];
  }
  sites.resize(kept);
}

}  // namespace

std::array<Vec3, scanner_count> scanner_positions(const Box& box) {
  const double step = away * norm(box.high - box.low) / std::sqrt(3.0);
  const Vec3 centre = middle(box);
  return {centre + step * Vec3{1, 1, 1}, centre + step * Vec3{-1, -1, 1},
          centre + step * Vec3{1, -1, -1}, centre + step * Vec3{-1, 1, -1}};
}

std::vector<Site> scanner_sites(const TriangleMesh& mesh, std::size_t count, Random& random,
                                const Execution& execution) {
  const TriangleBvh bvh(mesh);
  const Box box = bounding_box(mesh);
  // Where the grids of rays lie differs from scanner to scanner and from seed to seed.
  Shifts shifts;
  for (Shift& shift : shifts) {
    shift.azimuth = random.uniform();
    shift.elevation = random.uniform();
  }
  const Execution quiet = without_progress(execution);
  // A few more than needed, so that one scan is mostly enough.
  const double wanted = static_cast<double>(count) + 2 * std::sqrt(static_cast<double>(count));
  double t = 1.0 / 256;
  double done = 0;
  double hits = static_cast<double>(scan_from_all(bvh, box, t, shifts, quiet).size());
  for (;;) {
    // Hits go with the inverse square of the angle. A grid that meets little tells little.
    t *= hits >= 16 ? std::sqrt(hits / wanted) : 0.5;
    // Not so coarse that a scanner has no ray at all.
    t = std::min(t, 0.05);
    const double rays_to_a_side = 0.34 / t;
    if (rays_to_a_side * rays_to_a_side > 1e6 + 1000 * wanted) {
      throw DataError("synth.sampling: hardly any ray of a scanner meets the surface");
    }
    // Progress never falls, so another scan has half of what is left for it.
    std::vector<Site> sites = scan_from_all(
        bvh, box, t, shifts, sub_execution(execution, "points", done, 0.5 + 0.5 * done));
    done = 0.5 + 0.5 * done;
    if (sites.size() >= count) {
      choose(sites, count, random);
      return sites;
    }
    hits = 0.98 * static_cast<double>(sites.size());
  }
}

}  // namespace deburr
