// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// A million points with everything that a page can show of them, drawn in software: the page
// chooses how many it can move.
import { readFileSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { deburr, folder, launch, open, screenshot, settled } from './browser';

const dir = folder();
const attempts = 3; // others may use the processor too
let browser: Browser;

const million = 1_000_000;
const mark = 'end_header\n';

/** Adds normals, colours, intensity and labels to the coordinates of a binary PLY file. */
function addEverything(file: string, output: string): void {
  const input = readFileSync(join(dir, file));
  const start = input.indexOf(mark) + mark.length;
  const row = (input.length - start) / million;
  const fields = ['double x', 'double y', 'double z', 'char nx', 'char ny', 'char nz', 'uchar red',
    'uchar green', 'uchar blue', 'ushort intensity', 'uchar deburr_label', 'uchar deburr_outlier'];
  const header = ['ply', 'format binary_little_endian 1.0', `element vertex ${million}`,
    ...fields.map((field) => `property ${field}`), mark].join('\n');
  const size = 34;
  const rows = Buffer.alloc(size * million);
  for (let i = 0; i < million; ++i) {
    const at = size * i;
    input.copy(rows, at, start + row * i, start + row * i + 24);
    // Of no meaning, but not all alike.
    for (let k = 24; k < 32; ++k) rows[at + k] = (i * (k + 1)) & 127;
    rows[at + 32] = i & 3;
    rows[at + 33] = i % 100 === 0 ? 1 : 0;
  }
  writeFileSync(join(dir, output), Buffer.concat([Buffer.from(header), rows]));
}

beforeAll(async () => {
  deburr(dir, 'synth', 'part', 'a.ply', '--points', String(million), '--clean', 'b.ply', '--truth',
    'truth.ply', '--quiet');
  addEverything('a.ply', 'noisy.ply');
  addEverything('b.ply', 'clean.ply');
  deburr(dir, 'view', 'noisy.ply', 'clean.ply', '-o', 'million.html', '--truth', 'truth.ply', '--quiet');
  browser = await launch();
});

afterAll(async () => {
  await browser.close();
});

/** Frames per second while the view is turned, after a second to find out what can be drawn. */
async function turn(page: Page): Promise<{ fps: number; drawn: number }> {
  const box = (await page.locator('.stage canvas').boundingBox())!;
  const data = () => page.$eval('.stage canvas', (c) => ({ ...(c as HTMLElement).dataset }));
  await page.mouse.move(box.x + 200, box.y + 200);
  await page.mouse.down();
  const drag = async (milliseconds: number) => {
    const began = performance.now();
    let elapsed = 0;
    while (elapsed < milliseconds) {
      await page.mouse.move(box.x + 200 + elapsed / 8, box.y + 200 + elapsed / 40);
      elapsed = performance.now() - began;
    }
    return elapsed;
  };
  await drag(1000);
  const before = await data();
  const elapsed = await drag(2000);
  const after = await data();
  await page.mouse.up();
  const count = Number(after['frames']) - Number(before['frames']);
  return { fps: (1000 * count) / elapsed, drawn: Number(after['drawn']) };
}

describe('a page of a million points', () => {
  it('is small, soon there and moves', async () => {
    const bytes = statSync(join(dir, 'million.html')).size;
    expect(bytes).toBeLessThanOrEqual(12_000_000);
    expect(bytes).toBeGreaterThan(11_000_000);
    let readyAfter = Infinity;
    let best = { fps: 0, drawn: 0 };
    for (let i = 0; i < attempts && !(readyAfter < 5000 && best.fps > 10); ++i) {
      const opened = await open(browser, join(dir, 'million.html'));
      readyAfter = Math.min(readyAfter, opened.readyAfter);
      const shown = await opened.page.textContent('.count');
      expect(shown).toMatch(/Shows 2\d\d,\d{3}/);
      const modes = await opened.page.$$eval('.toolbar select', ([colour]) =>
        [...(colour as HTMLSelectElement).options].map((option) => option.value));
      expect(modes).toEqual(['normals', 'colours', 'intensity', 'displacement', 'labels', 'truth']);
      expect(shown).toContain('of 1,000,000 points');
      const turned = await turn(opened.page);
      if (turned.fps > best.fps) best = turned;
      await settled(opened.page);
      await screenshot(opened.page, 'million');
      expect(opened.problems).toEqual([]);
      await opened.page.close();
    }
    const figures = { bytes, readyMs: Math.round(readyAfter), fps: Math.round(best.fps), drawn: best.drawn };
    console.log(JSON.stringify(figures));
    expect(best.drawn).toBeGreaterThanOrEqual(20_000); // no fewer, however slow the machine
    expect(readyAfter).toBeLessThan(5000);
    expect(best.fps).toBeGreaterThan(10);
  });
});
