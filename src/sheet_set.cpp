// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "sheet_set.hpp"

namespace deburr {
namespace {

std::vector<Vec3> places_of(const NodeSheets& fitted) {
  std::vector<Vec3> places;
  places.reserve(fitted.even.size() + fitted.further.size());
  for (const NodeSheet& s : fitted.even) places.push_back(s.sheet.frame.origin);
  for (const NodeSheet& s : fitted.further) places.push_back(s.sheet.frame.origin);
  return places;
}

}  // namespace

SheetSet::SheetSet(const NodeSheets& fitted, std::size_t nodes, const Execution& execution)
    : of_(nodes, none),
      places_(places_of(fitted)),
      even_(std::span(places_).first(fitted.even.size()), execution),
      // Without further sheets that would be the same tree again.
      all_(fitted.further.empty() ? Points{} : Points(places_), execution) {
  sheets_.reserve(places_.size());
  const auto add = [&](const std::vector<NodeSheet>& sheets) {
    for (const NodeSheet& s : sheets) {
      of_[s.node] = static_cast<std::uint32_t>(sheets_.size());
      sheets_.push_back(s.sheet);
    }
  };
  add(fitted.even);
  add(fitted.further);
}

}  // namespace deburr
