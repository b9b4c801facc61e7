// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// How large a cloud is, and how dense.
import type { Vec3 } from './cloud';

export interface Extent {
  low: Vec3;
  high: Vec3;
  centre: Vec3;
  /** Half the diagonal. */
  radius: number;
}

const samples = 20_000;
const trimmed = 0.002;

/** The box of most points: a few that lie far off do not count. */
export function robustExtent(local: Float32Array): Extent {
  const count = local.length / 3;
  const used = Math.min(count, samples);
  const low: Vec3 = [0, 0, 0];
  const high: Vec3 = [0, 0, 0];
  for (let k = 0; k < 3; ++k) {
    const values = new Float32Array(used);
    for (let i = 0; i < used; ++i) values[i] = local[3 * i + k]!;
    values.sort();
    const skip = Math.floor(trimmed * used);
    low[k] = values[skip] ?? 0;
    high[k] = values[used - 1 - skip] ?? 0;
  }
  const centre = low.map((v, k) => (v + high[k]!) / 2) as Vec3;
  const radius = Math.hypot(...low.map((v, k) => high[k]! - v)) / 2;
  return { low, high, centre, radius: radius > 0 ? radius : 1 };
}

const cellsAcross = 96;

/** Mean spacing of the points on their surface, whose area is told from the cells that they fill. */
export function meanSpacing(local: Float32Array, extent: Extent): number {
  const count = local.length / 3;
  if (count < 2) return extent.radius;
  const cell = (2 * extent.radius) / cellsAcross;
  const filled = new Set<number>();
  let inside = 0;
  for (let i = 0; i < count; ++i) {
    let key = 0;
    let out = false;
    for (let k = 0; k < 3; ++k) {
      const at = Math.floor((local[3 * i + k]! - extent.low[k]!) / cell);
      out ||= at < 0 || at > cellsAcross;
      key = key * (cellsAcross + 1) + at;
    }
    if (out) continue;
    filled.add(key);
    ++inside;
  }
  // A plane through a grid of cells meets about 1.5 of them per cell of its area.
  const area = (filled.size / 1.5) * cell * cell;
  return Math.sqrt(area / Math.max(inside, 1));
}
