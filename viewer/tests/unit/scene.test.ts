// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from 'vitest';
import { FrameBudget } from '../../src/scene/budget';
import { paneAt, panesOf } from '../../src/scene/panes';
import { pickPoint } from '../../src/scene/pick';

describe('panes', () => {
  it('share the width side by side', () => {
    const panes = panesOf('side', 2, 1001, 500, 0.5);
    expect(panes.map((pane) => pane.view.width)).toEqual([499, 499]);
    expect(paneAt(panes, 10, 10)?.cloud).toBe(0);
    expect(paneAt(panes, 990, 10)?.cloud).toBe(1);
    expect(paneAt(panes, 500, 10)).toBeUndefined();
  });

  it('lie over each other in a wipe', () => {
    const panes = panesOf('wipe', 2, 1000, 500, 0.25);
    expect(panes.map((pane) => pane.view.width)).toEqual([1000, 1000]);
    expect(panes.map((pane) => pane.clip.width)).toEqual([250, 750]);
    expect(paneAt(panes, 249, 0)?.cloud).toBe(0);
    expect(paneAt(panes, 250, 0)?.cloud).toBe(1);
  });

  it('are one for one cloud', () => {
    expect(panesOf('side', 1, 100, 100, 0.5)).toHaveLength(1);
    expect(panesOf('after', 2, 100, 100, 0.5)[0]?.cloud).toBe(1);
  });
});

describe('picking', () => {
  const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const view = { matrix: identity, width: 200, height: 100 };
  const local = Float32Array.of(0, 0, 0.5, 0, 0, -0.5, 0.9, 0.9, 0);

  it('takes the nearest of those under the pointer', () => {
    expect(pickPoint(local, 3, view, 100, 50, 5, () => true)).toBe(1);
    expect(pickPoint(local, 3, view, 190, 5, 5, () => true)).toBe(2);
    expect(pickPoint(local, 3, view, 50, 50, 5, () => true)).toBe(-1);
  });

  it('sees through what is hidden', () => {
    expect(pickPoint(local, 3, view, 100, 50, 5, (i) => i !== 1)).toBe(0);
    expect(pickPoint(local, 1, view, 190, 5, 5, () => true)).toBe(-1);
  });

  it('does not pick what lies behind the viewer', () => {
    const behind = [...identity];
    behind[15] = -1;
    expect(pickPoint(local, 3, { ...view, matrix: behind }, 100, 50, 500, () => true)).toBe(-1);
  });
});

describe('the budget of a frame', () => {
  it('is kept by drawing fewer points', () => {
    const budget = new FrameBudget(1_000_000);
    expect(budget.moving).toBe(1);
    budget.took(1000, 1);
    expect(budget.moving).toBeCloseTo(0.045, 3);
    for (let i = 0; i < 50; ++i) budget.took(budget.moving * 200, budget.moving);
    expect(budget.moving * 200).toBeCloseTo(45, 0);
  });

  it('never draws too few to see a shape, and all where it can', () => {
    const budget = new FrameBudget(1_000_000);
    budget.took(1e6, 1);
    expect(budget.moving).toBe(0.02);
    for (let i = 0; i < 50; ++i) budget.took(1, budget.moving);
    expect(budget.moving).toBe(1);
    expect(new FrameBudget(100).moving).toBe(1);
  });
});
