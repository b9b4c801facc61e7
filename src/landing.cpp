// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "landing.hpp"

#include <algorithm>
#include <utility>

#include "columns.hpp"
#include "corners.hpp"
#include "crease.hpp"
#include "nearest_beside.hpp"
#include "parallel.hpp"
#include "sheet_blend.hpp"
#include "surer_sheet.hpp"
#include "unit.hpp"

namespace deburr {
namespace {

/// Sheets around a point that its landing is made of.
constexpr std::size_t fewest_sheets = 20;
constexpr std::size_t most_sheets_around = 60;
constexpr std::size_t edge_sheets = 50;  ///< by an edge

/// Less of a point is not worth a place among the nodes of another sheet.
constexpr double least_share = 0.02;

/// A point on a sheet that is not its likeliest.
struct Other {
  std::uint32_t point;
  CutSheet sheet;
};

/// What the points of one block leave for after all have landed.
struct Block {
  std::vector<Other> others;
  std::vector<EdgePoint> edges;
};

Landing on_one_sheet(const Vec3& place, const Vec3& normal) {
  Landing landing{place, normal};
  landing.sheets[0] = {place, normal};
  return landing;
}

/// One landing of all points.
class Lander {
 public:
  Lander(const AutomaticInput& input, const FittedNodes& nodes, const SheetSet& set,
         const SheetsAround& around)
      : input_(input),
        set_(set),
        sheets_(set.sheets()),
        by_edge_(around.by_edge),
        blended_(std::clamp(around.nodes / around.step, fewest_sheets, most_sheets_around)),
        scales_{input.noise, nodes.spacing},
        finder_(set.sheets(), scales_, input.spacing) {}

  /// Buffers of one thread.
  struct Scratch {
    NearestBeside of_even, of_all;
    std::vector<Found> near;
  };

  /// Where a point of a node comes to lie from where it was taken to lie so far.
  Landing land(const Vec3& point, std::uint32_t node, const Vec3& place, const Vec3& normal,
               Scratch& scratch) const {
    auto& near = scratch.near;
    if (!by_edge_.empty() && by_edge_[node] != 0) {
      scratch.of_all.find(set_.all(), place, edge_sheets, near);
    } else {
      scratch.of_even.find(set_.even(), place, blended_, near);
    }
    std::uint32_t own = set_.of(node);
    if (input_.parts.surer_sheet) {
      own = surer_sheet(point, own, near, sheets_, input_.noise);
    }
    // Without a fit the place so far is the best that is known.
    const auto unfitted = [&] {
      Landing landing = on_one_sheet(place, normal);
      landing.fitted = false;
      return landing;
    };
    if (own == SheetSet::none) return unfitted();
    const Found alone{0, own};
    const std::span<const Found> some =
        input_.parts.blend ? std::span<const Found>(near) : std::span(&alone, 1);
    const Blend blend = blend_sheets(point, place, own, some, sheets_, scales_);
    if (!blend.valid || !is_finite(blend.foot)) return unfitted();
    if (input_.parts.creases) return finder_.land(point, blend, own, near);
    return on_one_sheet(blend.foot, blend.normal);
  }

 private:
  const AutomaticInput& input_;
  const SheetSet& set_;
  std::span<const PackedSheet> sheets_;
  std::span<const std::uint8_t> by_edge_;
  std::size_t blended_;
  BlendScales scales_;
  CreaseFinder finder_;
};

/// Nodes whose points land together: beside where the mean of them does. Only far from edges, where
/// no point is of two sheets.
class Together {
 public:
  Together(const FittedNodes& nodes, const Lander& lander, const Execution& execution)
      : measured_(nodes.measured), feet_(nodes.places.size()), normals_(nodes.places.size()) {
    parallel_blocks(feet_.size(), execution, [&](std::size_t begin, std::size_t end) {
      Lander::Scratch scratch;
      scratch.of_even.expect(Points(nodes.places).subspan(begin, end - begin));
      for (std::size_t k = begin; k < end; ++k) {
        const Landing landing = lander.land(nodes.measured[k], static_cast<std::uint32_t>(k),
                                            nodes.places[k], nodes.normals[k], scratch);
        if (landing.label != Feature::Surface || landing.sheet_count > 1) continue;
        feet_[k] = landing.place;
        normals_[k] = landing.normal;
      }
    });
  }

  /// Whether the points of a node do.
  [[nodiscard]] bool holds(std::uint32_t node) const {
    return !normals_.empty() && !is_zero(normals_[node]);
  }
  [[nodiscard]] Landing land(const Vec3& point, std::uint32_t node) const {
    const Vec3& n = normals_[node];
    const Vec3 within = point - measured_[node];
    return on_one_sheet(feet_[node] + within - dot(within, n) * n, n);
  }

 private:
  Points measured_;
  std::vector<Vec3> feet_;
  std::vector<Vec3> normals_;  ///< zero where points land by themselves
};

/// Puts point i onto the likeliest of its sheets, and unless it is to be there as a whole,
/// what is left of it into the block.
void share_out(std::uint32_t i, const Landing& landing, bool whole, Shares& shares, Block& block) {
  const std::span<const CutSheet> here(landing.sheets.data(), landing.sheet_count);
  const auto likeliest = std::ranges::max_element(here, {}, &CutSheet::share);
  shares.places[i] = likeliest->foot;
  shares.normals[i] = likeliest->normal;
  shares.by_edge[i] = here.size() > 1 ? 1 : 0;
  shares.trust[i] = whole ? 1 : likeliest->share;
  if (whole) return;
  for (auto s = here.begin(); s != here.end(); ++s) {
    if (s != likeliest && s->share > least_share) block.others.push_back({i, *s});
  }
}

void resize_columns(Shares& shares, std::size_t size, const Execution& execution) {
  for (auto* column : {&shares.measured, &shares.places, &shares.normals}) {
    resize_column(*column, size, execution);
  }
  resize_column(shares.trust, size, execution);
  resize_column(shares.by_edge, size, execution);
}

/// Every point as a whole where it was measured, until it lands.
Shares room_for(const AutomaticInput& input, const Execution& execution) {
  Shares shares;
  shares.measured = copy_column(input.points, execution);
  resize_columns(shares, input.points.size(), execution);
  return shares;
}

/// Adds what is left of points in blocks, one after the other.
void add_others(Points points, std::span<const Block> blocks, Shares& shares,
                const Execution& execution) {
  std::vector<std::size_t> begins{shares.places.size()};
  for (const Block& block : blocks) begins.push_back(begins.back() + block.others.size());
  resize_columns(shares, begins.back(), execution);
  parallel_for<1>(blocks.size(), without_progress(execution), [&](std::size_t b) {
    std::size_t at = begins[b];
    for (const Other& other : blocks[b].others) {
      shares.measured[at] = points[other.point];
      shares.places[at] = other.sheet.foot;
      shares.normals[at] = other.sheet.normal;
      shares.trust[at] = other.sheet.share;
      shares.by_edge[at] = 1;
      ++at;
    }
  });
}

}  // namespace

Vec3 bounded(const Vec3& place, const Vec3& point, double max_move) {
  const Vec3 move = place - point;
  const double distance = norm(move);
  return distance > max_move ? point + (max_move / distance) * move : place;
}

void land(const AutomaticInput& input, const FittedNodes& nodes, NodeSheets sheets,
          const SheetsAround& around, std::span<std::uint8_t> lone, AutomaticResult& result,
          Shares* shares, const Execution& execution) {
  const std::size_t count = input.points.size();
  if (shares != nullptr) *shares = room_for(input, execution);
  std::vector<Block> blocks((count + block_size - 1) / block_size);
  const SheetSet set(std::move(sheets), nodes.count, execution);
  const Lander lander(input, nodes, set, around);
  // Those of the nodes, if there are any, take as long as those of the points.
  const Together together(nodes, lander, sub_execution(execution, "landing", 0, 0.5));
  const Execution rest = sub_execution(execution, "landing", 0.5, 1);
  parallel_blocks(count, rest, [&](std::size_t begin, std::size_t end) {
    Lander::Scratch scratch;
    scratch.of_even.expect(Points(result.points).subspan(begin, end - begin));
    scratch.of_all.expect(Points(result.points).subspan(begin, end - begin));
    Block& block = blocks[begin / block_size];
    for (std::size_t i = begin; i < end; ++i) {
      const auto point = static_cast<std::uint32_t>(i);
      const std::uint32_t node = nodes.of_point(point);
      const Landing landing =
          together.holds(node)
              ? together.land(input.points[i], node)
              : lander.land(input.points[i], node, result.points[i], result.normals[i], scratch);
      result.points[i] = bounded(landing.place, input.points[i], input.max_move);
      result.normals[i] = landing.normal;
      result.labels[i] = landing.label;
      const bool in_reach = norm(landing.place - input.points[i]) <= input.max_move;
      if (landing.fitted && in_reach) lone[i] = 0;
      if (landing.label != Feature::Surface) {
        block.edges.push_back({point, landing.sheets, landing.sheet_count});
      }
      if (shares != nullptr) share_out(point, landing, !input.parts.shares, *shares, block);
    }
  });
  std::vector<EdgePoint> edges;
  if (shares != nullptr) add_others(input.points, blocks, *shares, execution);
  for (const Block& block : blocks) {
    edges.insert(edges.end(), block.edges.begin(), block.edges.end());
  }
  label_corners(edges, result.points, input.spacing, result.labels, without_progress(execution));
}

}  // namespace deburr
