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

const counted = 20_000;
const asked = 200;
const nth = 6;
/** Mean distance to the 6th nearest of points at random on a plane, in mean spacings. */
const nthInSpacings = 1.36;

/** Mean spacing of the points on their surface. Measured on a first part of them, which is as
 * even as the whole but sparser, so that noise does not count as distance. */
export function meanSpacing(local: Float32Array, extent: Extent): number {
  const count = local.length / 3;
  const used = Math.min(count, counted);
  if (used <= nth) return extent.radius;
  const found: number[] = [];
  for (let k = 0; k < Math.min(asked, used); ++k) {
    const i = Math.floor((k * used) / Math.min(asked, used));
    found.push(nthDistance(local, used, i));
  }
  found.sort((a, b) => a - b);
  const spacing = found[Math.floor(found.length / 2)]! / nthInSpacings;
  return (spacing || extent.radius / Math.sqrt(used)) * Math.sqrt(used / count);
}

function nthDistance(local: Float32Array, used: number, i: number): number {
  const nearest = new Array<number>(nth).fill(Infinity);
  for (let j = 0; j < used; ++j) {
    if (j === i) continue;
    const dx = local[3 * j]! - local[3 * i]!;
    const dy = local[3 * j + 1]! - local[3 * i + 1]!;
    const dz = local[3 * j + 2]! - local[3 * i + 2]!;
    const squared = dx * dx + dy * dy + dz * dz;
    if (squared >= nearest[nth - 1]!) continue;
    let at = nth - 1;
    for (; at > 0 && nearest[at - 1]! > squared; --at) nearest[at] = nearest[at - 1]!;
    nearest[at] = squared;
  }
  return Math.sqrt(nearest[nth - 1]!);
}
