// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "deburr/denoise.hpp"

namespace CLI {
class App;
}

namespace deburr::cli {

/// Adds the options of the method to the command; their defaults are those in `options`.
void add_denoise_options(CLI::App& command, DenoiseOptions& options);

/// After parsing: refuses what belongs to the other method.
/// @throws std::invalid_argument  naming the option
void finish_denoise_options(const CLI::App& command, const DenoiseOptions& options);

/// Every option that is in effect, defaults included.
[[nodiscard]] nlohmann::ordered_json to_json(const DenoiseOptions& options);

}  // namespace deburr::cli
