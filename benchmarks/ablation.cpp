// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <string_view>

#include "automatic_parts.hpp"
#include "deburr/io.hpp"

// The default method without one of its ingredients. benchmarks/quality --ablation runs it.

namespace {

using deburr::AutomaticParts;

/// A way to leave something out.
struct Without {
  std::string_view name;
  void (*leave_out)(AutomaticParts&);
};

// In the order of the steps.
constexpr std::array table{
    Without{"nothing", [](AutomaticParts&) {}},
    Without{"all fits: the pilot alone", [](AutomaticParts& p) { p.fits = false; }},
    Without{"second pass", [](AutomaticParts& p) { p.second_pass = false; }},
    Without{"level 2 of nodes", [](AutomaticParts& p) { p.levels = 2; }},
    Without{"levels 1 and 2", [](AutomaticParts& p) { p.levels = 1; }},
    Without{"pool: the nearest curve alone", [](AutomaticParts& p) { p.pool = false; }},
    Without{"misfit of the cloud", [](AutomaticParts& p) { p.cloud_misfit = false; }},
    Without{"noise of the surroundings", [](AutomaticParts& p) { p.local_sigma = false; }},
    Without{"guards of growth", [](AutomaticParts& p) { p.guards = false; }},
    Without{"surer sheet", [](AutomaticParts& p) { p.surer_sheet = false; }},
    Without{"blend: the own sheet alone", [](AutomaticParts& p) { p.blend = false; }},
    Without{"creases and shares", [](AutomaticParts& p) { p.creases = false; }},
    Without{"shares", [](AutomaticParts& p) { p.shares = false; }},
    Without{"levels of noise", [](AutomaticParts& p) { p.noise_levels = false; }},
};

int run(std::string_view name, const char* from, const char* to) {
  const auto* const found = std::ranges::find(table, name, &Without::name);
  if (found == table.end()) {
    (void)std::fprintf(stderr, "ablation: no such part; --list names them\n");
    return 2;
  }
  AutomaticParts parts;
  found->leave_out(parts);
  (void)deburr::write_cloud(to, deburr::denoise_with(parts, deburr::read_cloud(from)).cloud);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc == 2 && std::string_view(argv[1]) == "--list") {
      for (const Without& one : table) std::printf("%s\n", one.name.data());
      return 0;
    }
    if (argc == 2 && std::string_view(argv[1]) == "--compiler") {
      std::printf("%s\n", DEBURR_COMPILER);
      return 0;
    }
    if (argc == 4) return run(argv[1], argv[2], argv[3]);
    (void)std::fprintf(stderr,
                       "ablation --list\nablation --compiler\nablation PART INPUT OUTPUT\n");
    return 2;
  } catch (const std::exception& error) {
    (void)std::fprintf(stderr, "ablation: %s\n", error.what());
    return 1;
  }
}
