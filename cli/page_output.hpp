// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "deburr/execution.hpp"
#include "view/page.hpp"

namespace deburr::cli {

/// The extensions of pages, in small letters.
[[nodiscard]] std::vector<std::string> page_extensions();

/// Whether a report of this name is a page to look at.
[[nodiscard]] bool is_page(const std::string& path);

/// Refuses, before any work is done for it, a page that cannot be made.
/// @throws IoError             if the file cannot be written
/// @throws std::runtime_error  in a build without the viewer
void check_page_output(const std::string& path);

/// A page that waits for its report.
struct PreparedPage {
  view::Scene scene;
  std::vector<view::Still> stills;  ///< for browsers that cannot draw points
};

/// As many points as there is room for, and pictures of the clouds.
[[nodiscard]] PreparedPage prepare_page(const view::Request& request,
                                        const view::SceneOptions& options,
                                        const Execution& execution);

/// The page, one HTML file.
/// @param report  a JSON object as `deburr denoise --json` prints it; may be empty
[[nodiscard]] std::string page_html(const PreparedPage& page, const std::string& report = {});

}  // namespace deburr::cli
