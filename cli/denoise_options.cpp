// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "denoise_options.hpp"

#include <stdexcept>

#include "args.hpp"

namespace deburr::cli {
namespace {

constexpr Choice<Method> methods[] = {{"auto", Method::Auto}, {"yadav2018", Method::Yadav2018}};
constexpr Choice<NormalSource> normal_sources[] = {{"auto", NormalSource::Auto},
                                                   {"keep", NormalSource::Keep},
                                                   {"estimate", NormalSource::Estimate}};
constexpr Choice<bool> rebuilds[] = {{"once", false}, {"per-round", true}};
constexpr Choice<bool> updates[] = {{"in-place", true}, {"simultaneous", false}};

constexpr Choice<OutlierAction> outlier_actions[] = {{"label", OutlierAction::Label},
                                                     {"remove", OutlierAction::Remove},
                                                     {"keep", OutlierAction::Keep}};

constexpr const char* auto_group = "Options of --method auto";
constexpr const char* yadav2018_group = "Options of --method yadav2018";

}  // namespace

void add_denoise_options(CLI::App& command, DenoiseOptions& options) {
  add_choice(command, "--method", options.method, methods, "What takes the noise off");
  add_choice(command, "--normals", options.normals, normal_sources,
             "First normals; auto keeps those of the input where there are some");

  AutoOptions& automatic = options.automatic;
  const auto of_auto = [](CLI::Option* option) { option->group(auto_group); };
  of_auto(add_value(command, "--strength", automatic.strength,
                    "1 to 5: below 3 less of what may be noise is taken off, above 3 more"));
  of_auto(add_value(command, "--max-move", automatic.max_move,
                    "No point moves farther, in input units; 0 for 4 times the noise"));
  of_auto(add_value(command, "--noise", automatic.noise,
                    "Standard deviation of the noise, in input units; 0 to estimate it"));
  of_auto(add_choice(command, "--outliers", automatic.outliers, outlier_actions,
                     "What becomes of points that are no part of the surface"));

  Yadav2018Options& yadav = options.yadav2018;
  const auto grouped = [](CLI::Option* option) { option->group(yadav2018_group); };
  grouped(add_value(command, "--rounds", yadav.rounds, "Rounds of the method"));
  grouped(add_value(command, "--k", yadav.k, "Neighbours for normals and point spacing (dbar)"));
  grouped(add_value(command, "--rho", yadav.rho, "Cosine above which two normals are similar"));
  grouped(add_value(command, "--tau", yadav.tau, "Eigenvalue threshold of both stages"));
  grouped(add_value(command, "--damping", yadav.damping, "Share of the old normal"));
  grouped(add_value(command, "--alpha", yadav.alpha, "Step of surface points"));
  grouped(add_value(command, "--epsilon", yadav.epsilon, "Largest movement in all, in dbar"));
  grouped(add_value(command, "--radius", yadav.radius, "Scale of the weights, in dbar"));
  grouped(add_choice(command, "--neighborhoods", yadav.rebuild, rebuilds,
                     "When neighbours are searched"));
  grouped(add_choice(command, "--update", yadav.in_place, updates,
                     "Whether a point sees the new places of those before it"));
}

void finish_denoise_options(const CLI::App& command, const DenoiseOptions& options) {
  const bool is_yadav2018 = options.method == Method::Yadav2018;
  const char* const foreign = is_yadav2018 ? auto_group : yadav2018_group;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group() == foreign && option->count() > 0) {
      throw std::invalid_argument(option->get_name() + " belongs to --method " +
                                  (is_yadav2018 ? "auto" : "yadav2018"));
    }
  }
}

nlohmann::ordered_json to_json(const DenoiseOptions& options) {
  nlohmann::ordered_json json{{"method", word_for(methods, options.method)},
                              {"normals", word_for(normal_sources, options.normals)}};
  if (options.method == Method::Yadav2018) {
    const Yadav2018Options& o = options.yadav2018;
    json.update({{"rounds", o.rounds},
                 {"k", o.k},
                 {"rho", o.rho},
                 {"tau", o.tau},
                 {"damping", o.damping},
                 {"alpha", o.alpha},
                 {"epsilon", o.epsilon},
                 {"radius", o.radius},
                 {"neighborhoods", word_for(rebuilds, o.rebuild)},
                 {"update", word_for(updates, o.in_place)}});
  } else {
    const AutoOptions& o = options.automatic;
    json.update({{"strength", o.strength},
                 {"max_move", o.max_move},
                 {"noise", o.noise},
                 {"outliers", word_for(outlier_actions, o.outliers)}});
  }
  return json;
}

}  // namespace deburr::cli
