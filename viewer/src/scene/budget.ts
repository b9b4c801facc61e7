// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0

const target = 45; // milliseconds of a frame in motion: 22 in a second
const least = 20_000; // points, fewer of which show no shape

/** Chooses how many points are drawn while the view moves, from how long frames have taken. */
export class FrameBudget {
  private share = 1;
  private readonly lowest: number;

  constructor(points: number) {
    this.lowest = Math.min(1, least / Math.max(points, 1));
  }

  /** Share of the points to draw in the next frame in motion. */
  get moving(): number {
    return this.share;
  }

  /** Tells how long a frame took in which this share of the points was drawn. */
  took(milliseconds: number, drawn: number): void {
    if (!(milliseconds > 0)) return;
    const affordable = (drawn * target) / milliseconds;
    // Fast down, slow up: one slow frame is felt, a few points too few are not.
    const next = affordable < this.share ? affordable : Math.min(affordable, this.share * 1.25);
    this.share = Math.min(1, Math.max(this.lowest, next));
  }
}
