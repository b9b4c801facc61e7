// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "denoise_summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "console.hpp"
#include "deburr/version.hpp"
#include "denoise_options.hpp"

namespace deburr::cli {

nlohmann::ordered_json to_json(const DenoiseSummary& summary) {
  using Json = nlohmann::ordered_json;
  const Report& report = summary.report;
  Json labels = Json::object();
  for (std::size_t i = 0; i < report.labels.size(); ++i) {
    labels[std::string(to_string(static_cast<Feature>(i)))] = report.labels[i];
  }
  Json rounds = Json::array();
  for (const RoundReport& round : report.rounds) {
    rounds.push_back({{"rms_move", round.rms_move}, {"max_move", round.max_move}});
  }
  Json stages = Json::array();
  for (const StageTime& stage : report.stages) {
    stages.push_back({{"stage", stage.stage}, {"seconds", stage.seconds}});
  }
  return {{"deburr_version", version},
          {"command", "denoise"},
          {"input", summary.input},
          {"output", summary.output},
          {"options", to_json(summary.options)},
          {"points", report.points},
          {"non_finite", report.non_finite},
          {"duplicates", report.duplicates},
          {"outliers", report.outliers},
          {"kept", report.kept},
          {"spacing", report.spacing},
          {"noise", report.noise},
          {"max_move", report.max_move},
          {"kept_normals", report.kept_normals},
          {"labels", labels},
          {"rms_displacement", summary.rms_displacement},
          {"max_displacement", summary.max_displacement},
          {"rounds", rounds},
          {"stages", stages},
          {"added_fields", summary.added},
          {"warnings", summary.warnings}};
}

std::string to_text(const DenoiseSummary& summary) {
  const Report& report = summary.report;
  std::string text =
      as_line(fmt::format("{}: {} points, spacing {:.6g}, noise {:.6g}", summary.input,
                          report.points, report.spacing, report.noise));
  if (report.non_finite + report.duplicates > 0) {
    text += fmt::format("  {} not finite, {} at the place of an earlier one\n", report.non_finite,
                        report.duplicates);
  }
  if (report.outliers > 0) {
    text += fmt::format("  {} outliers {}\n", report.outliers,
                        summary.options.automatic.outliers == OutlierAction::Remove
                            ? "removed"
                            : "labelled, not moved");
  }
  text += fmt::format("  moved by {:.6g} (rms), at most {:.6g} (bound {:.6g})\n",
                      summary.rms_displacement, summary.max_displacement, report.max_move);
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < report.labels.size(); ++i) {
    parts.push_back(fmt::format("{} {}", report.labels[i], to_string(static_cast<Feature>(i))));
  }
  text += fmt::format("  {}\n", fmt::join(parts, ", "));
  parts.clear();
  for (const StageTime& stage : report.stages) {
    parts.push_back(fmt::format("{} {:.3g}", stage.stage, stage.seconds));
  }
  text += fmt::format("  seconds: {}\n", fmt::join(parts, ", "));
  for (const std::string& warning : summary.warnings) text += warning_line(warning);
  const std::string fields =
      summary.added.empty() ? "" : fmt::format(" with {}", fmt::join(summary.added, " "));
  return text +
         as_line(fmt::format("{} points written to {}{}", report.kept, summary.output, fields));
}

}  // namespace deburr::cli
