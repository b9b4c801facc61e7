// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "deburr/denoise.hpp"

namespace deburr::cli {

/// What a run of `deburr denoise` has to tell.
struct DenoiseSummary {
  std::string input{};
  std::string output{};
  DenoiseOptions options{};
  Report report{};                   ///< its stages begin with "read" and end with "write"
  double rms_displacement = 0;       ///< over the finite points, input units
  double max_displacement = 0;       ///< input units
  std::vector<std::string> added{};  ///< names of the fields written for every point
  std::vector<std::string> warnings{};
};

[[nodiscard]] nlohmann::ordered_json to_json(const DenoiseSummary& summary);

/// A few lines for people.
[[nodiscard]] std::string to_text(const DenoiseSummary& summary);

}  // namespace deburr::cli
