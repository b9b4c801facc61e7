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

/// All rays that meet the surface, for angles of 2 atan(t) between them.
std::vector<Site> scan(const TriangleBvh& bvh, const Box& box, double t, const Direction& shift_x,
                       const Direction& shift_y, const Execution& execution) {
  const std::vector<Direction> azimuths = fan(rotation(t), shift_x);
  const std::vector<Direction> elevations = fan(rotation(t), shift_y);
  const auto scanners = scanner_positions(box);
  const Vec3 centre = middle(box);
  std::vector<std::vector<Site>> lines(scanners.size() * elevations.size());
  parallel_for(lines.size(), execution, [&](std::size_t line) {
    check_cancelled(execution);
    const std::size_t scanner = line / elevations.size();
    const auto& [cos_up, sin_up] = elevations[line % elevations.size()];
    const Vec3 ahead = unit_vector(centre - scanners.at(scanner));
    const Vec3 right = unit_vector(cross(ahead, {0, 0, 1}));
    const Vec3 up = cross(right, ahead);
    for (const auto& [cos, sin] : azimuths) {
      const Vec3 direction = cos_up * (cos * ahead + sin * right) + sin_up * up;
      const std::optional<RayHit> hit = bvh.first_hit(scanners.at(scanner), direction);
      if (hit) {
        lines[line].push_back({{hit->point, hit->triangle}, static_cast<std::uint32_t>(scanner)});
      }
    }
  });
  std::vector<Site> sites;
  for (const auto& line : lines) sites.insert(sites.end(), line.begin(), line.end());
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

std::array<Vec3, 4> scanner_positions(const Box& box) {
  const double step = away * norm(box.high - box.low) / std::sqrt(3.0);
  const Vec3 centre = middle(box);
  return {centre + step * Vec3{1, 1, 1}, centre + step * Vec3{-1, -1, 1},
          centre + step * Vec3{1, -1, -1}, centre + step * Vec3{-1, 1, -1}};
}

std::vector<Site> scanner_sites(const TriangleMesh& mesh, std::size_t count, Random& random,
                                const Execution& execution) {
  const TriangleBvh bvh(mesh);
  const Box box = bounding_box(mesh);
  // Where the grid of rays lies differs from seed to seed, in either direction by up to one step.
  const double shift_x = random.uniform();
  const double shift_y = random.uniform();
  const auto scan_at = [&](double t, const Execution& part) {
    return scan(bvh, box, t, rotation(t * shift_x), rotation(t * shift_y), part);
  };
  const Execution quiet{.threads = execution.threads, .cancelled = execution.cancelled};
  // A few more than needed, so that one scan is mostly enough.
  const double wanted = static_cast<double>(count) + 2 * std::sqrt(static_cast<double>(count));
  double t = 1.0 / 256;
  double done = 0;
  double hits = static_cast<double>(scan_at(t, quiet).size());
  for (int tries = 0; tries < 32; ++tries) {
    // Hits go with the inverse square of the angle. A grid that meets little tells little.
    t *= hits >= 16 ? std::sqrt(hits / wanted) : 0.5;
    // Not so coarse that a scanner has no ray at all.
    t = std::min(t, 0.05);
    // Progress never falls, so another scan has half of what is left for it.
    std::vector<Site> sites =
        scan_at(t, sub_execution(execution, "points", done, 0.5 + 0.5 * done));
    done = 0.5 + 0.5 * done;
    if (sites.size() >= count) {
      choose(sites, count, random);
      return sites;
    }
    hits = 0.98 * static_cast<double>(sites.size());
  }
  throw DataError("synth.sampling: hardly any ray of a scanner meets the surface");
}

}  // namespace deburr
