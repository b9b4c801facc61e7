// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0

/** Lines of an outline: pairs of places, x y x y each. */
export type Segments = Float32Array;

function cellKey(x: number, y: number): string {
  return `${x},${y}`;
}

/** Means of the places within each cell of a grid, so that a band of points becomes thin. */
function thinned(places: Float32Array, cell: number): Float32Array {
  const cells = new Map<string, [number, number, number]>();
  for (let i = 0; i < places.length; i += 2) {
    const x = places[i]!;
    const y = places[i + 1]!;
    const key = cellKey(Math.floor(x / cell), Math.floor(y / cell));
    const sum = cells.get(key) ?? [0, 0, 0];
    cells.set(key, [sum[0] + x, sum[1] + y, sum[2] + 1]);
  }
  return Float32Array.from([...cells.values()].flatMap(([x, y, n]) => [x / n, y / n]));
}

/** Lines between neighbours that nothing stands between (the Gabriel graph), no longer than
 * 2.5 cells: along the outline of a thin slab, and not across it. */
export function outline(places: Float32Array, cell: number): Segments {
  const nodes = thinned(places, cell);
  const reach = 2.5 * cell;
  const grid = new Map<string, number[]>();
  for (let i = 0; i < nodes.length; i += 2) {
    const key = cellKey(Math.floor(nodes[i]! / reach), Math.floor(nodes[i + 1]! / reach));
    const list = grid.get(key);
    if (list) list.push(i);
    else grid.set(key, [i]);
  }
  const near = (i: number): number[] => {
    const gx = Math.floor(nodes[i]! / reach);
    const gy = Math.floor(nodes[i + 1]! / reach);
    const found: number[] = [];
    for (let dx = -1; dx <= 1; ++dx) {
      for (let dy = -1; dy <= 1; ++dy) found.push(...(grid.get(cellKey(gx + dx, gy + dy)) ?? []));
    }
    return found;
  };
  const segments: number[] = [];
  for (let i = 0; i < nodes.length; i += 2) {
    const around = near(i);
    for (const j of around) {
      if (j <= i) continue;
      const mx = (nodes[i]! + nodes[j]!) / 2;
      const my = (nodes[i + 1]! + nodes[j + 1]!) / 2;
      const half = Math.hypot(nodes[i]! - mx, nodes[i + 1]! - my);
      if (2 * half > reach) continue;
      const between = around.some((k) => k !== i && k !== j &&
        Math.hypot(nodes[k]! - mx, nodes[k + 1]! - my) < half);
      if (!between) segments.push(nodes[i]!, nodes[i + 1]!, nodes[j]!, nodes[j + 1]!);
    }
  }
  return Float32Array.from(segments);
}
