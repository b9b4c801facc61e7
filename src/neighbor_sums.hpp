// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "deburr/features.hpp"
#include "deburr/position_update.hpp"
#include "lanes.hpp"
#include "normal_votes.hpp"
#include "rows.hpp"

namespace deburr {

/// Points with their normals, as the sums over neighbours read them.
struct Oriented {
  const Row* points;
  const Row* normals;
};

/// For each of up to eight points, the moments about it of its neighbours with similar normals.
struct Moments {
  Lanes count{};
  Lanes3 sum;
  LanesSym3 outer;
};

/// For each of up to eight points, sums of weights and of weighted offsets along the normals.
struct SurfaceSums {
  Lanes total{};
  Lanes offsets{};
};

/// The quadric of the neighbours' tangent planes: matrix and right-hand side, relative to the
/// point.
struct FeatureSums {
  Sym3 a;
  Vec3 b;
};

/// What classifying point i needs. A zero normal is similar to none, since rho is not negative.
/// @param[out] to  gets it in lane `l`
void add_moments(std::size_t i, const Oriented& cloud, std::span<const std::uint32_t> neighbors,
                 double rho, std::size_t l, Moments& to);

/// What moving point i needs if it is on a surface.
/// @param[out] to  gets it in lane `l`
void add_offsets(std::size_t i, const Oriented& cloud, std::span<const std::uint32_t> neighbors,
                 const PositionUpdateOptions& options, std::size_t l, SurfaceSums& to);

/// Both in one pass over the neighbours.
void add_both(std::size_t i, const Oriented& cloud, std::span<const std::uint32_t> neighbors,
              double rho, const PositionUpdateOptions& options, std::size_t l, Moments& moments,
              SurfaceSums& sums);

/// In the same pass the votes on the normal, of those neighbours that count for the moments.
void add_all(std::size_t i, const Oriented& cloud, std::span<const std::uint32_t> neighbors,
             double rho, const PositionUpdateOptions& options, std::size_t l, Moments& moments,
             SurfaceSums& sums, Votes& votes);

/// What moving point i needs if it is on an edge or a corner.
/// @param along  the edge, to leave out what lies along it; zero for a corner
void add_planes(std::size_t i, const Oriented& cloud, std::span<const std::uint32_t> neighbors,
                const PositionUpdateOptions& options, const Vec3& along, FeatureSums& to);

}  // namespace deburr
