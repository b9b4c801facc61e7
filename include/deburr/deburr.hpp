// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "deburr/denoise.hpp"
#include "deburr/error.hpp"
#include "deburr/execution.hpp"
#include "deburr/features.hpp"
#include "deburr/io.hpp"
#include "deburr/mesh.hpp"
#include "deburr/metrics.hpp"
#include "deburr/neighborhoods.hpp"
#include "deburr/noise.hpp"
#include "deburr/normal_filter.hpp"
#include "deburr/normals.hpp"
#include "deburr/orientation.hpp"
#include "deburr/outliers.hpp"
#include "deburr/point_cloud.hpp"
#include "deburr/position_update.hpp"
#include "deburr/synth.hpp"
#include "deburr/vec3.hpp"
#include "deburr/version.hpp"
