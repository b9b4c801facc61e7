// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
import { directions, integers, numbers } from './bytes';
import type { CloudInfo, SceneInfo } from './scene';

export type Vec3 = [number, number, number];

export const unknownLabel = 7;
const labelBits = 7;
const outlierBit = 8;

/** The points of one cloud. Every first part of them is spread evenly over the whole. */
export interface Cloud {
  info: CloudInfo;
  count: number;
  /** Coordinates less those of `origin`, small enough for the 32-bit floats of a graphics card. */
  local: Float32Array;
  /** Coordinates of the file are low + step * q. */
  q: Uint32Array;
  low: Vec3;
  step: Vec3;
  normals: Int8Array;
  colours?: Uint8Array;
  intensity?: Float64Array;
  flags?: Uint8Array;
  displacement?: Float64Array;
  truth?: Float64Array;
}

/** Coordinates of a point in the file, as exact as the page holds them. */
export function coordinates(cloud: Cloud, i: number): Vec3 {
  return [0, 1, 2].map((k) => cloud.low[k]! + cloud.step[k]! * cloud.q[3 * i + k]!) as Vec3;
}

export function labelOf(cloud: Cloud, i: number): number {
  return cloud.flags ? cloud.flags[i]! & labelBits : unknownLabel;
}

export function isOutlier(cloud: Cloud, i: number): boolean {
  return cloud.flags !== undefined && (cloud.flags[i]! & outlierBit) !== 0;
}

export function hasOutliers(cloud: Cloud): boolean {
  return cloud.flags?.some((flag) => (flag & outlierBit) !== 0) ?? false;
}

function vector(values: number[] | undefined): Vec3 {
  return [values?.[0] ?? 0, values?.[1] ?? 0, values?.[2] ?? 0];
}

/** The middle of the first cloud's box, in file coordinates. */
export function sceneOrigin(scene: SceneInfo): Vec3 {
  const position = scene.clouds[0]?.arrays.position;
  const low = vector(position?.low);
  const step = vector(position?.step);
  return [0, 1, 2].map((k) => low[k]! + step[k]! * 2 ** 23) as Vec3;
}

export function decodeCloud(bytes: Uint8Array, info: CloudInfo, origin: Vec3): Cloud {
  const { position, normal, colour, intensity, flags, displacement, truth } = info.arrays;
  if (!position || !normal) throw new Error('the page has no points');
  const count = info.shown;
  const q = integers(bytes, position, count);
  const low = vector(position.low);
  const step = vector(position.step);
  const local = new Float32Array(3 * count);
  for (let i = 0; i < local.length; ++i) {
    const k = i % 3;
    local[i] = low[k]! - origin[k]! + step[k]! * q[i]!;
  }
  const cloud: Cloud = {
    info, count, local, q, low, step, normals: directions(bytes, normal, count),
  };
  if (colour) cloud.colours = Uint8Array.from(integers(bytes, colour, count));
  if (intensity) cloud.intensity = numbers(bytes, intensity, count);
  if (flags) cloud.flags = Uint8Array.from(integers(bytes, flags, count));
  if (displacement) cloud.displacement = numbers(bytes, displacement, count);
  if (truth) cloud.truth = numbers(bytes, truth, count);
  return cloud;
}

/** All clouds of a scene; the points of a pair share their displacement. */
export function decodeScene(bytes: Uint8Array, scene: SceneInfo): Cloud[] {
  const origin = sceneOrigin(scene);
  const clouds = scene.clouds.map((info) => decodeCloud(bytes, info, origin));
  const [before, after] = clouds;
  if (scene.paired && before && after?.displacement) {
    before.displacement = new Float64Array(before.count).fill(NaN);
    before.displacement.set(after.displacement);
  }
  return clouds;
}
