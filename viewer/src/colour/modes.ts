// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// What points can be coloured by.
import { isOutlier, labelOf, type Cloud } from '../data/cloud';
import type { SceneInfo } from '../data/scene';
import { diverging, labels, outlier, sequential, table, unknown, type Rgb } from './maps';

export type Mode = 'normals' | 'colours' | 'intensity' | 'displacement' | 'labels' | 'truth';

export const modeNames: Record<Mode, string> = {
  normals: 'Shape',
  colours: 'Colours of the file',
  intensity: 'Intensity',
  displacement: 'Displacement',
  labels: 'Labels',
  truth: 'Distance to the truth',
};

/** The values at the ends of a map, in file units. */
export interface Range {
  low: number;
  high: number;
}

/** Modes for which some cloud has data. */
export function availableModes(clouds: Cloud[]): Mode[] {
  const any = (has: (cloud: Cloud) => unknown) => clouds.some((cloud) => has(cloud));
  const modes: Mode[] = ['normals'];
  if (any((c) => c.colours)) modes.push('colours');
  if (any((c) => c.intensity)) modes.push('intensity');
  if (any((c) => c.displacement)) modes.push('displacement');
  if (any((c) => c.flags)) modes.push('labels');
  if (any((c) => c.truth)) modes.push('truth');
  return modes;
}

export function valuesOf(cloud: Cloud, mode: Mode): Float64Array | undefined {
  if (mode === 'intensity') return cloud.intensity;
  if (mode === 'displacement') return cloud.displacement;
  if (mode === 'truth') return cloud.truth;
  return undefined;
}

export function mapOf(mode: Mode, scene: SceneInfo): Rgb[] {
  return mode === 'displacement' && scene.displacement?.signed ? diverging : sequential;
}

const trimmed = 0.02;
const asked = 50_000; // points of a cloud: a first part of them is as even as the whole

/** The range that a mode begins with. */
export function firstRange(mode: Mode, scene: SceneInfo, clouds: Cloud[]): Range | undefined {
  if (mode === 'displacement' && scene.displacement) {
    const high = scene.displacement.range || scene.displacement.max || 1;
    return { low: scene.displacement.signed ? -high : 0, high };
  }
  if (mode === 'truth') return { low: 0, high: scene.truthRange || 1 };
  if (mode !== 'intensity') return undefined;
  const values = Float64Array.from(
    clouds.flatMap((c) => Array.from(c.intensity?.subarray(0, asked) ?? []))).sort();
  const skip = Math.floor(trimmed * values.length);
  const low = values[skip] ?? 0;
  const high = values[values.length - 1 - skip] ?? 1;
  return { low, high: high > low ? high : low + 1 };
}

const plain: Rgb = [205, 205, 200];
const levels = 512;

/** The colour of one point in the modes without a range. */
function plainColour(cloud: Cloud, mode: Mode, i: number): Rgb {
  if (mode === 'normals') return plain;
  if (mode === 'labels') {
    if (isOutlier(cloud, i)) return outlier.colour;
    return labels[labelOf(cloud, i)]?.colour ?? unknown.colour;
  }
  if (mode === 'colours' && cloud.colours) {
    return [cloud.colours[3 * i]!, cloud.colours[3 * i + 1]!, cloud.colours[3 * i + 2]!];
  }
  return unknown.colour;
}

/** The colour of every point as RGBA, where A is 255 for outliers and else 0. */
export function paint(cloud: Cloud, mode: Mode, map: Rgb[], range: Range | undefined): Uint8Array {
  const bytes = new Uint8Array(4 * cloud.count);
  const values = range && valuesOf(cloud, mode);
  const lookup = table(map, levels);
  for (let i = 0; i < cloud.count; ++i) {
    const at = 4 * i;
    const share = values && range ? (values[i]! - range.low) / (range.high - range.low) : NaN;
    if (Number.isNaN(share)) {
      const colour = values ? unknown.colour : plainColour(cloud, mode, i);
      bytes[at] = colour[0];
      bytes[at + 1] = colour[1];
      bytes[at + 2] = colour[2];
    } else {
      const step = 3 * Math.round(Math.min(Math.max(share, 0), 1) * (levels - 1));
      bytes[at] = lookup[step]!;
      bytes[at + 1] = lookup[step + 1]!;
      bytes[at + 2] = lookup[step + 2]!;
    }
    bytes[at + 3] = isOutlier(cloud, i) ? 255 : 0;
  }
  return bytes;
}
