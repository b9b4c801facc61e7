// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "compare_measure.hpp"

namespace deburr::cli {

/// Every figure; docs/metrics.md names the keys.
[[nodiscard]] nlohmann::ordered_json to_json(const Comparison& comparison);

/// A short table for people.
[[nodiscard]] std::string to_text(const Comparison& comparison);

}  // namespace deburr::cli
