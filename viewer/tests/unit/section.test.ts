// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from 'vitest';
import { outline } from '../../src/section/outline';
import { drawSection, fitWindow, pictureAxis, roundUp } from '../../src/section/plot';
import { axisFrame, planeOf, project } from '../../src/section/slab';

const extent = { low: [0, 0, 0], high: [10, 20, 30], centre: [5, 10, 15], radius: 18 } as const;
const box = { low: [0, 0, 0] as [number, number, number], high: [10, 20, 30] as [number, number, number],
  centre: [5, 10, 15] as [number, number, number], radius: extent.radius };
const facing = { normal: [0, 0, 1] as [number, number, number],
  right: [1, 0, 0] as [number, number, number], up: [0, 1, 0] as [number, number, number] };
const slab = { on: true, axis: 'y' as const, position: 0.25, thickness: 2, keepBehind: false };

describe('the slab', () => {
  it('goes through the cloud from end to end', () => {
    expect(planeOf(slab, box, 0.5, facing, 'z').offset).toBe(5);
    expect(planeOf({ ...slab, position: 1 }, box, 0.5, facing, 'z').offset).toBe(20);
    expect(planeOf({ ...slab, axis: 'x', position: 0 }, box, 0.5, facing, 'z').offset).toBe(0);
    expect(planeOf({ ...slab, axis: 'view', position: 0.5 }, box, 0.5, facing, 'z').offset).toBe(15);
  });

  it('holds the points that are not farther than half its thickness', () => {
    const plane = planeOf(slab, box, 0.5, facing, 'z');
    const local = Float32Array.of(1, 5, 2, 3, 5.5, 4, 7, 5.6, 8, 9, 5, 9);
    const seen = project(local, plane, (i) => i !== 3);
    expect([...seen.points]).toEqual([0, 1]);
    expect([...seen.places]).toEqual([1, 2, 3, 4]);
  });
});

describe('the picture of a slab', () => {
  it('has up what is up in the view', () => {
    expect(axisFrame('x', 'z')).toEqual({ normal: [1, 0, 0], right: [0, 1, 0], up: [0, 0, 1] });
    expect(axisFrame('z', 'z')).toEqual({ normal: [0, 0, 1], right: [1, 0, 0], up: [0, 1, 0] });
    expect(axisFrame('z', 'y')).toEqual({ normal: [0, 0, 1], right: [1, 0, 0], up: [0, 1, 0] });
    expect(axisFrame('x', '-y')).toEqual({ normal: [1, 0, 0], right: [0, 0, 1], up: [0, -1, 0] });
    expect(axisFrame('y', 'y')).toEqual({ normal: [0, 1, 0], right: [1, 0, 0], up: [0, 0, -1] });
  });

  it('is labelled with the coordinates of the file, also where these grow downwards', () => {
    const written: { text: string; x: number; y: number }[] = [];
    const nothing = () => undefined;
    const paper = {
      clearRect: nothing, beginPath: nothing, moveTo: nothing, lineTo: nothing, stroke: nothing,
      fillRect: nothing, fillText: (text: string, x: number, y: number) => written.push({ text, x, y }),
    } as unknown as CanvasRenderingContext2D;
    const picture = {
      lines: new Float32Array(), names: ['', ''] as [string, string],
      axes: [pictureAxis([1, 0, 0], [1000, 0, 0]), pictureAxis([0, -1, 0], [0, 50, 0])] as
        [ReturnType<typeof pictureAxis>, ReturnType<typeof pictureAxis>],
    };
    // 200 pixels are 20 units: x from 990 to 1010, y from 60 at the foot up to 40.
    drawSection(paper, 200, 200, { x: 0, y: 0, scale: 10 }, picture,
      { before: '', after: '', text: '', grid: '' });
    const at = (text: string) => written.find((w) => w.text === text);
    expect(at('1000')?.x).toBeCloseTo(103, 5);
    expect(at('50')?.y).toBeCloseTo(97.5, 5);
    expect(at('60')?.y).toBeCloseTo(197.5, 5);
    expect(at('40')).toBeUndefined(); // where the name of the axis stands
    expect(at('x →')).toBeDefined();
    expect(at('y ↓')).toBeDefined();
  });
});

describe('the outline', () => {
  it('joins neighbours on a line, and nothing across a gap', () => {
    const places: number[] = [];
    for (let i = 0; i < 40; ++i) places.push(i + 0.5, 0.5);
    for (let i = 42; i < 62; ++i) places.push(i + 0.4, 0.5); // 2.9 cells on
    const segments = outline(Float32Array.from(places), 1);
    expect(segments.length / 4).toBe(39 + 19);
    for (let i = 0; i < segments.length; i += 4) {
      expect(Math.abs(segments[i + 2]! - segments[i]!)).toBeLessThan(2.5);
    }
  });

  it('closes a circle', () => {
    const places: number[] = [];
    for (let i = 0; i < 628; ++i) places.push(50 * Math.cos(i / 100), 50 * Math.sin(i / 100));
    const segments = outline(Float32Array.from(places), 1);
    let length = 0;
    for (let i = 0; i < segments.length; i += 4) {
      length += Math.hypot(segments[i + 2]! - segments[i]!, segments[i + 3]! - segments[i + 1]!);
    }
    expect(length).toBeGreaterThan(0.97 * 2 * Math.PI * 50);
    expect(length).toBeLessThan(1.05 * 2 * Math.PI * 50);
  });

  it('is empty where there is nothing', () => {
    expect(outline(new Float32Array(), 1)).toHaveLength(0);
  });
});

describe('its picture', () => {
  it('has round steps', () => {
    expect(roundUp(0.7)).toBe(1);
    expect(roundUp(1.3)).toBe(2);
    expect(roundUp(31)).toBe(50);
    expect(roundUp(0.0013)).toBeCloseTo(0.002, 12);
  });

  it('shows all places', () => {
    const seen = fitWindow([Float32Array.of(0, 0, 10, 5), Float32Array.of(-10, 0)], 200, 100);
    expect(seen.x).toBe(0);
    expect(seen.y).toBe(2.5);
    expect(20 * seen.scale).toBeLessThanOrEqual(200);
    expect(fitWindow([], 10, 10)).toEqual({ x: 0, y: 0, scale: 1 });
  });
});
