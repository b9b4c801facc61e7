// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from 'vitest';
import { diverging, gradient, labels, outlier, sample, sequential, unknown } from '../../src/colour/maps';
import { availableModes, firstRange, paint } from '../../src/colour/modes';
import type { Cloud } from '../../src/data/cloud';

function cloud(extra: Partial<Cloud>): Cloud {
  return {
    info: {} as Cloud['info'], count: 3, local: new Float32Array(9), q: new Uint32Array(9),
    low: [0, 0, 0], step: [1, 1, 1], normals: new Int8Array(9), ...extra,
  };
}

/** Lightness of CIE L*, 0 to 100. */
function lightness(rgb: number[]): number {
  const linear = rgb.map((v) => (v / 255 <= 0.04045 ? v / 3294.6 : ((v / 255 + 0.055) / 1.055) ** 2.4));
  const y = 0.2126 * linear[0]! + 0.7152 * linear[1]! + 0.0722 * linear[2]!;
  return y > 0.008856 ? 116 * Math.cbrt(y) - 16 : 903.3 * y;
}

describe('maps', () => {
  it('go from end to end', () => {
    expect(sample(diverging, 0)).toEqual(diverging[0]);
    expect(sample(diverging, 0.5)).toEqual([221, 221, 221]);
    expect(sample(diverging, 9)).toEqual(diverging[8]);
    expect(sample(sequential, NaN)).toEqual(unknown.colour);
    expect(gradient(diverging)).toContain('rgb(59 76 192)');
  });

  // Without hue, as nobody may see it: lightness alone tells the order.
  it('can be read by lightness', () => {
    const steps = sequential.map(lightness);
    for (let i = 1; i < steps.length; ++i) expect(steps[i]!).toBeGreaterThan(steps[i - 1]! + 4);
    const sides = diverging.map(lightness);
    for (let i = 1; i <= 4; ++i) {
      expect(sides[i]!).toBeGreaterThan(sides[i - 1]!);
      expect(sides[8 - i]!).toBeGreaterThan(sides[9 - i]!);
    }
  });

  // Red-green blindness (Viénot 1999) leaves blue against the rest: the ends stay apart.
  it('have ends that a red-green blind person can tell apart', () => {
    const seen = ([r, g, b]: number[]) => [0.11 * r! + 0.89 * g!, b!];
    const [low, high] = [seen(diverging[0]!), seen(diverging[8]!)];
    expect(Math.abs(low[1]! - high[1]!)).toBeGreaterThan(100);
  });
});

describe('painting', () => {
  const scene = {
    format: 1, paired: true, clouds: [],
    displacement: {
      count: 3, mean: 1, rms: 1, p95: 1, max: 3, range: 2, signed: true,
      histogram: { low: -2, high: 2, counts: [1], below: 0, above: 0 },
    },
  };

  it('puts values between the ends of their range', () => {
    const c = cloud({ displacement: Float64Array.of(-2, 0, NaN) });
    const range = firstRange('displacement', scene, [c]);
    expect(range).toEqual({ low: -2, high: 2 });
    const tints = paint(c, 'displacement', diverging, range);
    expect([...tints.slice(0, 3)]).toEqual(diverging[0]);
    expect(Math.abs(tints[4]! - 221)).toBeLessThan(3);
    expect([...tints.slice(8, 11)]).toEqual(unknown.colour);
  });

  it('marks outliers in every mode', () => {
    const c = cloud({ flags: Uint8Array.of(0, 1, 3 + 8) });
    const tints = paint(c, 'labels', diverging, undefined);
    expect([...tints]).toEqual([
      ...labels[0]!.colour, 0, ...labels[1]!.colour, 0, ...outlier.colour, 255,
    ]);
    expect(paint(c, 'normals', diverging, undefined)[11]).toBe(255);
  });

  it('offers what there is', () => {
    expect(availableModes([cloud({})])).toEqual(['normals']);
    expect(availableModes([cloud({}), cloud({
      colours: new Uint8Array(9), flags: new Uint8Array(3), truth: new Float64Array(3),
    })])).toEqual(['normals', 'colours', 'labels', 'truth']);
  });

  it('takes the range of intensities from most of them', () => {
    const intensity = Float64Array.from({ length: 1000 }, (_, i) => (i === 999 ? 1e9 : i));
    const range = firstRange('intensity', scene, [cloud({ intensity })]);
    expect(range?.low).toBeCloseTo(20, 0);
    expect(range?.high).toBeCloseTo(979, 0);
  });
});
