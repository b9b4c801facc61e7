// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from 'vitest';
import { directions, fromBase64, integers, numbers } from '../../src/data/bytes';
import { coordinates, decodeScene, isOutlier, labelOf } from '../../src/data/cloud';
import { meanSpacing, robustExtent } from '../../src/data/extent';
import { parseScene, type SceneInfo } from '../../src/data/scene';

describe('bytes', () => {
  it('reads base64', () => {
    expect([...fromBase64('//4A')]).toEqual([255, 254, 0]);
    expect(() => fromBase64('!')).toThrow();
  });

  it('reads numbers with their lowest byte first', () => {
    const bytes = Uint8Array.of(9, 0x56, 0x34, 0x12, 0xff, 0xff, 0xff);
    expect([...integers(bytes, { type: 'u24', offset: 1, components: 1 }, 2)])
      .toEqual([0x123456, 0xffffff]);
    expect([...integers(bytes, { type: 'u16', offset: 1, components: 1 }, 1)]).toEqual([0x3456]);
  });

  it('says so where the data end early', () => {
    const info = { type: 'u24', offset: 0, components: 3 } as const;
    expect(() => integers(new Uint8Array(8), info, 1)).toThrow('end early');
  });

  it('scales', () => {
    const info = { type: 'u16', offset: 0, components: 1, low: [-1], step: [0.5] } as const;
    expect([...numbers(Uint8Array.of(0, 0, 3, 0), { ...info, low: [-1], step: [0.5] }, 2)])
      .toEqual([-1, 0.5]);
  });

  it('unpacks directions of every octant', () => {
    const axes = Uint8Array.of(254, 127, 127, 0, 127, 127, 254, 254);
    const info = { type: 'octahedral', offset: 0, components: 2 } as const;
    expect([...directions(axes, info, 4)]).toEqual([
      127, 0, 0, 0, -127, 0, 0, 0, 127, 0, 0, -127,
    ]);
  });
});

/** Two points before and after, far from the origin. */
function pair(): { scene: SceneInfo; bytes: Uint8Array } {
  const q = (...values: number[]) => values.flatMap((v) => [v & 255, (v >> 8) & 255, v >> 16]);
  const before = q(0, 0, 0, 1000, 2000, 3000);
  const after = q(0, 0, 10, 1000, 2000, 3010);
  const bytes = Uint8Array.from([...before, ...after, 127, 127, 127, 127, 1, 15, 0, 0, 255, 255]);
  const position = (offset: number) => ({
    type: 'u24' as const, offset, components: 3, low: [5e5, 4.5e6, 100], step: [0.001, 0.001, 0.001],
  });
  const cloud = (offset: number) => ({
    name: 'a', points: 2, nonFinite: 0, shown: 2, comments: [], estimatedNormals: false,
    arrays: {
      position: position(offset),
      normal: { type: 'octahedral' as const, offset: 36, components: 2 },
      flags: { type: 'u8' as const, offset: 40, components: 1 },
    },
  });
  const second = cloud(18);
  Object.assign(second.arrays, {
    displacement: { type: 'u16', offset: 42, components: 1, low: [0], step: [1] },
  });
  return { scene: { format: 1, paired: true, clouds: [cloud(0), second] }, bytes };
}

it('unpacks a direction that is folded over', () => {
  // -x, +y, -z of equal size: (1 - 1/3) towards both signs, in steps of 1/127.
  const packed = Uint8Array.of(127 - 85, 127 + 85);
  const info = { type: 'octahedral', offset: 0, components: 2 } as const;
  const [x, y, z] = directions(packed, info, 1);
  expect(x! / 127).toBeCloseTo(-0.577, 1);
  expect(y! / 127).toBeCloseTo(0.577, 1);
  expect(z! / 127).toBeCloseTo(-0.577, 1);
});

describe('clouds', () => {
  it('keep coordinates of surveys', () => {
    const { scene, bytes } = pair();
    const [before, after] = decodeScene(bytes, scene);
    expect(coordinates(before!, 1)).toEqual([500001, 4500002, 103]);
    expect(coordinates(after!, 1)[2]).toBeCloseTo(103.01, 9);
    expect(after!.local[5]! - before!.local[5]!).toBeCloseTo(0.01, 2);
  });

  it('share what is known of a pair', () => {
    const { scene, bytes } = pair();
    const [before, after] = decodeScene(bytes, scene);
    expect([...before!.displacement!]).toEqual([0, 65535]);
    expect(labelOf(after!, 0)).toBe(1);
    expect(isOutlier(after!, 0)).toBe(false);
    expect(labelOf(after!, 1)).toBe(7);
    expect(isOutlier(after!, 1)).toBe(true);
  });

  it('refuse another format', () => {
    expect(() => parseScene('{"format": 2}')).toThrow('format 2');
  });
});

describe('extent', () => {
  it('does not count a few points far off', () => {
    const local = new Float32Array(3 * 1000);
    for (let i = 0; i < 1000; ++i) local.set([i / 999, 0, 0], 3 * i);
    local.set([1e6, 0, 0], 0);
    const extent = robustExtent(local);
    expect(extent.radius).toBeGreaterThan(0.49);
    expect(extent.radius).toBeLessThan(0.51);
    expect(extent.centre[0]).toBeCloseTo(0.5, 1);
  });

  it('is there for a cloud without points', () => {
    expect(robustExtent(new Float32Array()).radius).toBe(1);
    expect(meanSpacing(new Float32Array(), robustExtent(new Float32Array()))).toBe(1);
  });

  it('tells the spacing of a sheet', () => {
    const side = 200;
    const local = new Float32Array(3 * side * side);
    for (let i = 0; i < side * side; ++i) {
      const at = (i * 7919) % (side * side); // the order of a page is spread as well
      const u = at % side;
      const v = Math.floor(at / side);
      local.set([u, 0.8 * v, 0.6 * v], 3 * i);
    }
    const spacing = meanSpacing(local, robustExtent(local));
    // A grid is not random: its 6th neighbours lie a little farther off.
    expect(spacing).toBeGreaterThan(0.9);
    expect(spacing).toBeLessThan(1.2);
  });
});
