// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0

export interface PickView {
  /** Projection times view, by columns. */
  matrix: ArrayLike<number>;
  width: number;
  height: number;
}

/** The point nearest to the viewer of those within some pixels of a place; -1 for none. */
export function pickPoint(
  local: Float32Array, count: number, view: PickView, x: number, y: number, radius: number,
  visible: (point: number) => boolean,
): number {
  const m = view.matrix;
  let best = -1;
  let nearest = Infinity;
  for (let i = 0; i < count; ++i) {
    const px = local[3 * i]!;
    const py = local[3 * i + 1]!;
    const pz = local[3 * i + 2]!;
    const w = m[3]! * px + m[7]! * py + m[11]! * pz + m[15]!;
    if (w <= 0) continue;
    const depth = (m[2]! * px + m[6]! * py + m[10]! * pz + m[14]!) / w;
    if (depth >= nearest || depth < -1 || depth > 1) continue;
    const sx = ((m[0]! * px + m[4]! * py + m[8]! * pz + m[12]!) / w * 0.5 + 0.5) * view.width;
    const sy = (0.5 - (m[1]! * px + m[5]! * py + m[9]! * pz + m[13]!) / w * 0.5) * view.height;
    if (Math.abs(sx - x) > radius || Math.abs(sy - y) > radius || !visible(i)) continue;
    best = i;
    nearest = depth;
  }
  return best;
}
