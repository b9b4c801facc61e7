// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// Colours that people with any kind of colour vision can tell apart. src/view/colours.cpp has the
// same ones.

export type Rgb = [number, number, number];

/** Moreland, Diverging Color Maps for Scientific Visualization, 2009: cool to warm. */
export const diverging: Rgb[] = [
  [59, 76, 192], [98, 130, 234], [141, 176, 254], [184, 208, 249], [221, 221, 221],
  [245, 196, 173], [244, 154, 123], [222, 96, 77], [180, 4, 38],
];

/** Viridis, of van der Walt and Smith. */
export const sequential: Rgb[] = [
  [68, 1, 84], [71, 45, 123], [59, 82, 139], [44, 114, 142], [33, 145, 140],
  [40, 174, 128], [94, 201, 98], [173, 220, 48], [253, 231, 37],
];

/** Okabe and Ito: what a label is called, and its colour. */
export const labels: { name: string; colour: Rgb }[] = [
  { name: 'surface', colour: [190, 190, 190] },
  { name: 'edge', colour: [213, 94, 0] },
  { name: 'corner', colour: [0, 114, 178] },
  { name: 'isolated', colour: [0, 158, 115] },
];
export const outlier = { name: 'outlier', colour: [204, 121, 167] as Rgb };
export const unknown = { name: 'unknown', colour: [128, 128, 128] as Rgb };

/** The colour at a share of the way along a map; what is no number is grey. */
export function sample(map: Rgb[], share: number): Rgb {
  if (Number.isNaN(share)) return unknown.colour;
  const along = Math.min(Math.max(share, 0), 1) * (map.length - 1);
  const at = Math.min(Math.floor(along), map.length - 2);
  const rest = along - at;
  const from = map[at]!;
  const to = map[at + 1]!;
  return [0, 1, 2].map((k) => Math.round(from[k]! + rest * (to[k]! - from[k]!))) as Rgb;
}

/** As a CSS background. */
export function gradient(map: Rgb[]): string {
  const stops = map.map((c) => `rgb(${c.join(' ')})`);
  return `linear-gradient(to right, ${stops.join(', ')})`;
}

/** A map as bytes, for many look-ups. */
export function table(map: Rgb[], size: number): Uint8Array {
  const bytes = new Uint8Array(3 * size);
  for (let i = 0; i < size; ++i) bytes.set(sample(map, i / (size - 1)), 3 * i);
  return bytes;
}
