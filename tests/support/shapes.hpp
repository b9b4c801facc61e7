// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "deburr/vec3.hpp"
#include "random.hpp"

// Clouds to test with. The same seed gives the same points on every machine.

namespace deburr {

/// Points with the true normals of the surface they lie on.
struct Sampled {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;
};

inline std::vector<Vec3> random_points(std::size_t n, unsigned seed) {
  Random random(seed);
  std::vector<Vec3> points(n);
  for (Vec3& p : points) {
    p.x = random.uniform();
    p.y = random.uniform();
    p.z = random.uniform();
  }
  return points;
}

/// Integer coordinates: many ties, many duplicates.
inline std::vector<Vec3> grid_points(std::size_t n, unsigned seed) {
  std::vector<Vec3> points = random_points(n, seed);
  for (Vec3& p : points) p = {std::floor(4 * p.x), std::floor(4 * p.y), std::floor(4 * p.z)};
  return points;
}

inline std::vector<Vec3> random_directions(std::size_t n, unsigned seed) {
  Random random(seed);
  std::vector<Vec3> directions(n);
  for (Vec3& d : directions) {
    d.x = random.gaussian();
    d.y = random.gaussian();
    d.z = random.gaussian();
    d = (1 / norm(d)) * d;
  }
  return directions;
}

/// side x side points in z = 0 at distance 1, with normals along z.
inline Sampled plane_grid(int side) {
  Sampled plane;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      plane.points.push_back({static_cast<double>(i), static_cast<double>(j), 0});
    }
  }
  plane.normals.assign(plane.points.size(), {0, 0, 1});
  return plane;
}

/// Uniform on the sphere of radius 1 about 0.
inline Sampled sphere(std::size_t n, unsigned seed) {
  const std::vector<Vec3> directions = random_directions(n, seed);
  return {directions, directions};
}

/// Face 0..5 of the cube [-1, 1]^3 at (u, v) in [-1, 1]^2, with its normal.
inline void add_to_cube(Sampled& cube, std::size_t face, double u, double v) {
  const double side = face < 3 ? 1 : -1;
  const std::array<Vec3, 3> at{Vec3{side, u, v}, Vec3{u, side, v}, Vec3{u, v, side}};
  const std::array<Vec3, 3> normal{Vec3{side, 0, 0}, Vec3{0, side, 0}, Vec3{0, 0, side}};
  cube.points.push_back(at.at(face % 3));
  cube.normals.push_back(normal.at(face % 3));
}

/// Uniform on the cube [-1, 1]^3.
inline Sampled cube(std::size_t n, unsigned seed) {
  Random random(seed);
  Sampled cube;
  for (std::size_t i = 0; i < n; ++i) {
    const double u = 2 * random.uniform() - 1;
    add_to_cube(cube, i % 6, u, 2 * random.uniform() - 1);
  }
  return cube;
}

/// side x side points on each face of the cube [-1, 1]^3, at the middles of equal squares.
inline Sampled cube_grid(int side) {
  Sampled cube;
  for (std::size_t face = 0; face < 6; ++face) {
    for (int i = 0; i < side; ++i) {
      for (int j = 0; j < side; ++j) {
        add_to_cube(cube, face, (2 * i + 1.0) / side - 1, (2 * j + 1.0) / side - 1);
      }
    }
  }
  return cube;
}

inline double distance_to_sphere(const Vec3& p) { return std::abs(norm(p) - 1); }

inline double distance_to_cube(const Vec3& p) {
  const Vec3 q{std::abs(p.x) - 1, std::abs(p.y) - 1, std::abs(p.z) - 1};
  const double largest = std::max({q.x, q.y, q.z});
  if (largest <= 0) return -largest;
  return norm({std::max(q.x, 0.0), std::max(q.y, 0.0), std::max(q.z, 0.0)});
}

/// Gaussian noise with this standard deviation along each axis.
inline std::vector<Vec3> with_noise(std::vector<Vec3> points, double sigma, unsigned seed) {
  Random random(seed);
  for (Vec3& p : points) {
    p.x += sigma * random.gaussian();
    p.y += sigma * random.gaussian();
    p.z += sigma * random.gaussian();
  }
  return points;
}

/// The directions, each turned by a Gaussian step of about `sigma` radians.
inline std::vector<Vec3> tilted(const std::vector<Vec3>& directions, double sigma, unsigned seed) {
  std::vector<Vec3> result = with_noise(directions, sigma, seed);
  for (Vec3& d : result) d = (1 / norm(d)) * d;
  return result;
}

/// Some of the directions turned round.
inline std::vector<Vec3> with_random_signs(std::vector<Vec3> directions, unsigned seed) {
  Random random(seed);
  for (Vec3& d : directions) d = random.uniform() < 0.5 ? -d : d;
  return directions;
}

/// A rotation by the rows of its matrix.
struct Rotation {
  std::array<Vec3, 3> rows;

  Vec3 operator()(const Vec3& v) const {
    return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)};
  }
};

inline Rotation random_rotation(unsigned seed) {
  const std::vector<Vec3> d = random_directions(2, seed);
  const Vec3 across = d[1] - dot(d[0], d[1]) * d[0];
  const Vec3 second = (1 / norm(across)) * across;
  return {{d[0], second, cross(d[0], second)}};
}

template <typename Map>
std::vector<Vec3> mapped(std::vector<Vec3> values, const Map& map) {
  for (Vec3& v : values) v = map(v);
  return values;
}

/// 0 .. n-1 in random order.
inline std::vector<std::uint32_t> random_permutation(std::size_t n, unsigned seed) {
  Random random(seed);
  std::vector<std::uint32_t> order(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(random.uniform() * static_cast<double>(i + 1));
    order[i] = order[at];
    order[at] = static_cast<std::uint32_t>(i);
  }
  return order;
}

}  // namespace deburr
