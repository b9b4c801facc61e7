// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// Which axis of a file points up. src/view/up.cpp has the same table.
import type { Vec3 } from '../data/cloud';

export const upAxes = ['z', 'y', 'x', '-z', '-y', '-x'] as const;
export type Up = (typeof upAxes)[number];

/** What somebody sees who stands in front of a thing: directions, right x forward = up. */
export interface UpFrame {
  right: Vec3;
  /** Away from the viewer. */
  forward: Vec3;
  up: Vec3;
}

const frames: Record<Up, UpFrame> = {
  'z': { right: [1, 0, 0], forward: [0, 1, 0], up: [0, 0, 1] },
  'y': { right: [1, 0, 0], forward: [0, 0, -1], up: [0, 1, 0] },
  'x': { right: [0, 1, 0], forward: [0, 0, 1], up: [1, 0, 0] },
  '-z': { right: [-1, 0, 0], forward: [0, 1, 0], up: [0, 0, -1] },
  '-y': { right: [1, 0, 0], forward: [0, 0, 1], up: [0, -1, 0] },
  '-x': { right: [0, -1, 0], forward: [0, 0, 1], up: [-1, 0, 0] },
};

export function frameOf(up: Up): UpFrame {
  return frames[up];
}

/** The axis of that name, or z. */
export function upNamed(name: string | undefined): Up {
  return upAxes.find((up) => up === name) ?? 'z';
}

export function nextUp(up: Up): Up {
  return upAxes[(upAxes.indexOf(up) + 1) % upAxes.length]!;
}

/** With the minus sign of printed text. */
export function upName(up: Up): string {
  return up.replace('-', '−');
}

/** A direction to the right, forward and up, in the axes of the file. */
export function toFile([right, forward, up]: Vec3, frame: UpFrame): Vec3 {
  return [0, 1, 2].map((k) =>
    right * frame.right[k]! + forward * frame.forward[k]! + up * frame.up[k]!) as Vec3;
}

/** How far a direction of the file goes to the right, forward and up. */
export function fromFile(v: Vec3, frame: UpFrame): Vec3 {
  return [frame.right, frame.forward, frame.up].map((axis) =>
    v[0] * axis[0] + v[1] * axis[1] + v[2] * axis[2]) as Vec3;
}
