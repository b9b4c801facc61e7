// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// Which cloud is drawn where.
import type { Layout } from '../state';

export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** A cloud, the area that the camera fills, and the part of it that is drawn; pixels from the top
 * left. */
export interface Pane {
  cloud: number;
  view: Box;
  clip: Box;
}

const gap = 2;

export function panesOf(
  layout: Layout, clouds: number, width: number, height: number, wipe: number,
): Pane[] {
  const whole = { x: 0, y: 0, width, height };
  if (clouds < 2 || layout === 'before') return [{ cloud: 0, view: whole, clip: whole }];
  if (layout === 'after') return [{ cloud: 1, view: whole, clip: whole }];
  if (layout === 'wipe') {
    const at = Math.round(wipe * width);
    return [
      { cloud: 0, view: whole, clip: { ...whole, width: at } },
      { cloud: 1, view: whole, clip: { ...whole, x: at, width: width - at } },
    ];
  }
  const half = Math.floor((width - gap) / 2);
  const left = { ...whole, width: half };
  const right = { ...whole, x: width - half, width: half };
  return [
    { cloud: 0, view: left, clip: left },
    { cloud: 1, view: right, clip: right },
  ];
}

/** The pane under a place; none in the gap. */
export function paneAt(panes: Pane[], x: number, y: number): Pane | undefined {
  return panes.find(({ clip }) =>
    x >= clip.x && x < clip.x + clip.width && y >= clip.y && y < clip.y + clip.height);
}
