// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "deburr/denoise.hpp"
#include "page_output.hpp"

namespace deburr::cli {

/// The page that `--report x.html` asks for: what goes into denoise(), and what comes out of it.
class ReportPage {
 public:
  /// Keeps a copy of the cloud, and numbers its points, so that those that are left out of the
  /// result can be told.
  ReportPage(std::string input, std::string output, PointCloud& cloud);

  /// Chooses the points to show, and takes the numbers out of the result again.
  void take(DenoiseResult& result, const Execution& execution);

  /// @param report  of the whole run, as JSON
  [[nodiscard]] std::string html(const std::string& report) const;

 private:
  std::string input_;
  std::string output_;
  PointCloud before_;
  std::string numbers_;  ///< name of the attribute
  PreparedPage page_;
};

}  // namespace deburr::cli
