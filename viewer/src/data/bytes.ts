// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// From the text in the page to numbers.
import type { ArrayInfo } from './scene';

export function fromBase64(text: string): Uint8Array {
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = characters.charCodeAt(i);
  return bytes;
}

const widths = { u24: 3, u16: 2, u8: 1, octahedral: 1 } as const;

/** The integers of an array, `count` items of its components. */
export function integers(bytes: Uint8Array, info: ArrayInfo, count: number): Uint32Array {
  const width = widths[info.type];
  const length = count * info.components;
  if (info.offset + length * width > bytes.length) throw new Error('the data of the page end early');
  const values = new Uint32Array(length);
  let at = info.offset;
  for (let i = 0; i < length; ++i) {
    let value = bytes[at++]!;
    if (width > 1) value |= bytes[at++]! << 8;
    if (width > 2) value |= bytes[at++]! << 16;
    values[i] = value;
  }
  return values;
}

/** The numbers that the integers of an array with one component stand for. */
export function numbers(bytes: Uint8Array, info: ArrayInfo, count: number): Float64Array {
  const low = info.low?.[0] ?? 0;
  const step = info.step?.[0] ?? 1;
  return Float64Array.from(integers(bytes, info, count), (q) => low + step * q);
}

const byteScale = 127;

/** Unit vectors of the octahedral map, three small integers of [-127, 127] each. */
export function directions(bytes: Uint8Array, info: ArrayInfo, count: number): Int8Array {
  const packed = integers(bytes, info, count);
  const normals = new Int8Array(3 * count);
  for (let i = 0; i < count; ++i) {
    let x = packed[2 * i]! / byteScale - 1;
    let y = packed[2 * i + 1]! / byteScale - 1;
    const z = 1 - Math.abs(x) - Math.abs(y);
    if (z < 0) {
      const folded = (1 - Math.abs(y)) * (x < 0 ? -1 : 1);
      y = (1 - Math.abs(x)) * (y < 0 ? -1 : 1);
      x = folded;
    }
    const scale = byteScale / Math.hypot(x, y, z);
    normals[3 * i] = Math.round(x * scale);
    normals[3 * i + 1] = Math.round(y * scale);
    normals[3 * i + 2] = Math.round(z * scale);
  }
  return normals;
}
