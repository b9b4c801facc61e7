// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "automatic.hpp"
#include "landing.hpp"

namespace deburr {

/// Places and normals of a result while nodes that are shares hold nearly all of them: most points
/// are where their likeliest sheet has them, so that only the others need be kept.
class LentResult {
 public:
  /// Takes the places and normals out of the result.
  /// @param shares  of the same landing
  LentResult(const AutomaticInput& input, const Shares& shares, AutomaticResult& result,
             const Execution& execution);

  /// Puts them back, bit by bit.
  /// @param places,normals  of the shares
  void give_back(std::vector<Vec3> places, std::vector<Vec3> normals, AutomaticResult& result,
                 const Execution& execution) const;

 private:
  struct Elsewhere {
    std::uint32_t point;
    Vec3 place, normal;
  };
  const AutomaticInput& input_;
  std::vector<Elsewhere> elsewhere_;
};

}  // namespace deburr
