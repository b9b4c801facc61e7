// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// Outliers that are not in the result any more can be found all the same.
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { DenoiseReport } from '../../src/data/scene';
import {
  countPixels, deburr, folder, launch, open, rows, screenshot, stagePixels, type Opened,
} from './browser';

const dir = folder();
let browser: Browser;
let opened: Opened;
let page: Page;
let summary: Required<DenoiseReport>;

beforeAll(async () => {
  deburr(dir, 'synth', 'part', 'part.ply', '--points', '8000', '--outliers', '0.01');
  summary = JSON.parse(deburr(dir, 'denoise', 'part.ply', 'clean.ply', '--json', '--outliers',
    'remove', '--report', 'report.html')) as Required<DenoiseReport>;
  browser = await launch();
  opened = await open(browser, join(dir, 'report.html'));
  page = opened.page;
});

afterAll(async () => {
  await browser.close();
});

/** Purple, in any light. */
async function purple(): Promise<number> {
  return countPixels(await stagePixels(page), (r, g, b) => r > g + 35 && b > g + 15 && r > 100);
}

describe('removed outliers', () => {
  it('are counted', async () => {
    expect(summary.outliers).toBeGreaterThan(50);
    const told = `${summary.outliers} outliers were removed`;
    expect(await page.textContent('.count')).toContain(told);
    expect((await rows(page, '.report'))['Outliers']).toBe(`${summary.outliers}, removed`);
    await page.getByRole('combobox', { name: 'Colour' }).selectOption('labels');
    expect(await page.textContent('.legend')).toContain(told);
  });

  it('are seen before, and not after', async () => {
    await page.getByRole('button', { name: 'Before' }).click();
    expect(await purple()).toBeGreaterThan(500);
    await screenshot(page, 'removed');
    await page.getByRole('button', { name: 'After' }).click();
    expect(await purple()).toBe(0);
  });

  it('can be picked', async () => {
    await page.getByRole('button', { name: 'Before' }).click();
    const picture = await stagePixels(page);
    const stage = (await page.locator('.stage').boundingBox())!;
    // The first pixel that is purple, and lies in the middle of its point.
    const is = (x: number, y: number) => {
      const [r, g, b] = picture.data.subarray(4 * (y * picture.width + x), 4 * (y * picture.width + x) + 3);
      return r! > g! + 35 && b! > g! + 15 && r! > 100;
    };
    let at: [number, number] | undefined;
    for (let y = 40; y < picture.height - 60 && !at; ++y) {
      for (let x = 10; x < picture.width - 10 && !at; ++x) {
        if (is(x - 2, y) && is(x + 2, y) && is(x, y - 2) && is(x, y + 2)) at = [x, y];
      }
    }
    await page.mouse.click(stage.x + at![0], stage.y + at![1]);
    await page.waitForSelector('.picked tr');
    const told = await rows(page, '.picked');
    expect(told['label']).toBe('outlier');
    expect(told['after']).toBe('removed');
    await page.keyboard.press('Escape');
  });

  it('can be hidden', async () => {
    await page.getByLabel('Hide outliers').check();
    expect(await purple()).toBe(0);
    expect(opened.problems).toEqual([]);
  });
});
