// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// What the page says of clouds and points; which way is up.
import { describe, expect, it } from 'vitest';
import type { Cloud, Vec3 } from '../../src/data/cloud';
import type { CloudInfo, SceneInfo } from '../../src/data/scene';
import { frameOf, fromFile, nextUp, toFile, upAxes, upNamed } from '../../src/scene/up';
import { pickedRows } from '../../src/ui/picked';
import { shownText, titleOf } from '../../src/ui/words';

function info(name: string, points: number, shown: number): CloudInfo {
  return { name, points, shown, nonFinite: 0, comments: [], estimatedNormals: false, arrays: {} };
}

const pair = (removed: number): SceneInfo => ({
  format: 1, paired: true, removed,
  clouds: [info('a/scan.ply', 2000, 1000), info('clean.ply', 2000 - removed, 1000 - removed)],
});

describe('the page says', () => {
  it('what it shows', () => {
    expect(titleOf(pair(0))).toBe('scan.ply → clean.ply');
    expect(shownText(pair(0))).toBe('Shows 1,000 of 2,000 points, before and after');
    expect(shownText({ ...pair(0), clouds: [info('a', 5, 5)] })).toBe('Shows 5 of 5 points');
  });

  it('how many outliers were removed', () => {
    expect(shownText(pair(3))).toBe(
      'Shows 1,000 of 2,000 points before and 997 of 1,997 after; 3 outliers were removed');
    expect(shownText(pair(1))).toContain('; 1 outlier was removed');
  });
});

describe('a point', () => {
  function cloud(count: number, flags: number[]): Cloud {
    return {
      info: info('', count, count), count, local: new Float32Array(3 * count),
      q: new Uint32Array(3 * count), low: [0, 0, 0], step: [1, 1, 1],
      normals: new Int8Array(3 * count), flags: Uint8Array.from(flags),
    };
  }
  const clouds = [cloud(2, [1, 7 + 8]), cloud(1, [1])];

  it('has the label of its pair', () => {
    const rows = Object.fromEntries(pickedRows(pair(1), clouds, 0, 0));
    expect(rows['label']).toBe('edge');
    expect(rows['after']).toBe('0  0  0');
  });

  it('tells whole numbers as such, and directions as exactly as they are known', () => {
    const [before, after] = clouds;
    const bright = { ...after!, intensity: Float64Array.of(7), normals: Int8Array.of(0, -127, 64) };
    const rows = Object.fromEntries(pickedRows(pair(1), [before!, bright], 1, 0));
    expect(rows['intensity']).toBe('7');
    expect(rows['normal']).toBe('0.00  -1.00  0.50');
  });

  it('that was removed is told to be', () => {
    const rows = Object.fromEntries(pickedRows(pair(1), clouds, 0, 1));
    expect(rows['label']).toBe('outlier');
    expect(rows['after']).toBe('removed');
  });
});

describe('up', () => {
  it('is a right-handed frame for every axis', () => {
    for (const name of upAxes) {
      const { right: r, forward: f, up } = frameOf(name);
      const cross = [r[1] * f[2] - r[2] * f[1], r[2] * f[0] - r[0] * f[2], r[0] * f[1] - r[1] * f[0]];
      cross.forEach((value, k) => expect(value).toBeCloseTo(up[k]!, 12));
      const axis = 'xyz'.indexOf(name.replace('-', ''));
      expect(up[axis]).toBe(name.startsWith('-') ? -1 : 1);
      const v: Vec3 = [1, 2, 3];
      fromFile(toFile(v, frameOf(name)), frameOf(name))
        .forEach((value, k) => expect(value).toBeCloseTo(v[k]!, 12));
    }
  });

  it('is z where a page tells nothing of use, and goes around', () => {
    expect(upNamed(undefined)).toBe('z');
    expect(upNamed('<b>')).toBe('z');
    expect(upNamed('-y')).toBe('-y');
    expect(new Set(upAxes.map(nextUp)).size).toBe(6);
  });
});
