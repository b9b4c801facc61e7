// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// A slab through the clouds: where it lies, and what the points in it look like from its side.
import type { Vec3 } from '../data/cloud';
import type { Extent } from '../data/extent';
import { frameOf, type Up } from '../scene/up';
import type { Slab } from '../state';

/** Directions across the slab, to the right and up in its picture. */
export interface Frame {
  normal: Vec3;
  right: Vec3;
  up: Vec3;
}

export interface Plane extends Frame {
  /** Of the middle: normal . p = offset. */
  offset: number;
  half: number;
}

export function dot(a: Vec3, b: Vec3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

const axes: Record<'x' | 'y' | 'z', Vec3> = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };

/** A slab across an axis, with what is up in the view up in its picture; across that one, as seen
 * from above. */
export function axisFrame(axis: 'x' | 'y' | 'z', upAxis: Up): Frame {
  const { right, forward, up } = frameOf(upAxis);
  const normal = axes[axis];
  if (dot(normal, up) !== 0) return { normal, right, up: forward };
  const other = (['x', 'y', 'z'] as const).find((name) =>
    name !== axis && dot(axes[name], up) === 0)!;
  return { normal, right: axes[other], up };
}

/** @param facing  the directions of the viewer, for a slab that faces them */
export function planeOf(
  slab: Slab, extent: Extent, spacing: number, facing: Frame, up: Up,
): Plane {
  const frame = slab.axis === 'view' ? facing : axisFrame(slab.axis, up);
  // The box has its farthest corner in this distance from its middle, along the normal.
  const reach = dot(frame.normal.map(Math.abs) as Vec3,
    extent.high.map((v, k) => (v - extent.low[k]!) / 2) as Vec3);
  const offset = dot(frame.normal, extent.centre) + (2 * slab.position - 1) * reach;
  return { ...frame, offset, half: (slab.thickness * spacing) / 2 };
}

export interface Projected {
  /** Pairs of coordinates to the right and up. */
  places: Float32Array;
  /** Numbers of the points in their cloud. */
  points: Uint32Array;
}

/** The points in the slab, as seen from its side. */
export function project(
  local: Float32Array, plane: Plane, visible: (point: number) => boolean,
): Projected {
  const places: number[] = [];
  const points: number[] = [];
  const [nx, ny, nz] = plane.normal;
  for (let i = 0; 3 * i < local.length; ++i) {
    const p: Vec3 = [local[3 * i]!, local[3 * i + 1]!, local[3 * i + 2]!];
    const across = nx * p[0] + ny * p[1] + nz * p[2] - plane.offset;
    if (Math.abs(across) > plane.half || !visible(i)) continue;
    places.push(dot(p, plane.right), dot(p, plane.up));
    points.push(i);
  }
  return { places: Float32Array.from(places), points: Uint32Array.from(points) };
}
