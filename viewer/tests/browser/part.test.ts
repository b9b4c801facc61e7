// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// The report of a run on a part: what the page shows is what the files hold.
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { DenoiseReport } from '../../src/data/scene';
import {
  countPixels, deburr, difference, folder, launch, open, readTable, rows, screenshot, settled,
  stagePixels, type Opened,
} from './browser';

const dir = folder();
let browser: Browser;
let opened: Opened;
let page: Page;
let summary: Required<DenoiseReport>;
let noisy: Record<string, number>[];
let clean: Record<string, number>[];

/** The part, in coordinates of a survey. */
function makeFiles(): void {
  deburr(dir, 'synth', 'part', 'part.csv', '--points', '20000', '--outliers', '0.002', '--truth', 'truth.ply');
  summary = JSON.parse(deburr(dir, 'denoise', 'part.csv', 'clean.csv', '--json', '--add',
    'normals,label,displacement,outlier', '--report', 'report.html')) as Required<DenoiseReport>;
  noisy = readTable(join(dir, 'part.csv'));
  clean = readTable(join(dir, 'clean.csv'));
}

async function mode(value: string): Promise<void> {
  await page.getByRole('combobox', { name: 'Colour' }).selectOption(value);
  await settled(page);
}

async function layout(name: string): Promise<void> {
  await page.getByRole('button', { name, exact: true }).click();
  await settled(page);
}

beforeAll(async () => {
  makeFiles();
  browser = await launch();
  opened = await open(browser, join(dir, 'report.html'));
  page = opened.page;
});

afterAll(async () => {
  await browser.close();
});

describe('the report of a part', () => {
  it('says what it shows', async () => {
    expect(await page.title()).toBe('part.csv → clean.csv – deburr');
    const shown = await page.textContent('.count');
    expect(shown).toContain(`${noisy.length.toLocaleString('en-US')} of ${noisy.length.toLocaleString('en-US')} points`);
    await screenshot(page, 'part-start');
  });

  it('tells what the run told', async () => {
    const told = await rows(page, '.report');
    expect(Number(told['Noise (standard deviation)'])).toBeCloseTo(summary.noise, 3);
    expect(Number(told['Point spacing'])).toBeCloseTo(summary.spacing, 3);
    expect(told['surface']).toBe(summary.labels['surface']!.toLocaleString('en-US'));
    expect(told['Outliers']).toBe(summary.outliers.toLocaleString('en-US'));
    expect(told['--method']).toBe('auto');
    expect(told['Written to']).toBe('clean.csv');
    expect(told['Made by']).toBe(`deburr ${summary.deburr_version}`);
    for (const { stage } of summary.stages) expect(Object.keys(told)).toContain(stage);
    expect(await page.locator('.histogram rect').count()).toBeGreaterThan(50);
  });

  it('has a picture for every colour mode', async () => {
    await mode('normals');
    const shape = await stagePixels(page);
    const grey = countPixels(shape, (r, g, b) => Math.abs(r - g) < 12 && Math.abs(g - b) < 12 && r < 215);
    expect(grey).toBeGreaterThan(20_000);

    await mode('displacement');
    await screenshot(page, 'part-displacement');
    const moved = await stagePixels(page);
    expect(countPixels(moved, (r, _g, b) => b > r + 50 && b > 120)).toBeGreaterThan(1000);
    expect(countPixels(moved, (r, _g, b) => r > b + 50 && r > 120)).toBeGreaterThan(1000);

    await mode('labels');
    await screenshot(page, 'part-labels');
    const edges = countPixels(await stagePixels(page), (r, g, b) => r > 130 && r > 1.8 * g && b < 40);
    expect(edges).toBeGreaterThan(500);
  });

  it('has colours that follow their range', async () => {
    await mode('displacement');
    const wide = await stagePixels(page);
    await page.getByLabel('Value of the last colour').fill('0.05');
    await page.keyboard.press('Tab');
    expect(await page.getByLabel('Value of the first colour').inputValue()).toBe('-0.05');
    const narrow = await stagePixels(page);
    const strong = (p: typeof wide) => countPixels(p, (r, _g, b) => Math.abs(r - b) > 90);
    expect(strong(narrow)).toBeGreaterThan(2 * strong(wide));
    await page.getByRole('button', { name: 'Auto' }).click();
    expect(difference(await stagePixels(page), wide)).toBeLessThan(0.001);
  });

  it('wipes from before to after', async () => {
    await mode('normals');
    await layout('Before');
    const before = await stagePixels(page);
    await layout('After');
    const after = await stagePixels(page);
    expect(difference(before, after)).toBeGreaterThan(0.03);
    await layout('Wipe');
    await screenshot(page, 'part-wipe');
    const divider = page.getByRole('slider', { name: /Wipe/ });
    const box = (await divider.boundingBox())!;
    const stage = (await page.locator('.stage').boundingBox())!;
    await page.mouse.move(box.x + box.width / 2, box.y + 50);
    await page.mouse.down();
    await page.mouse.move(stage.x + stage.width, box.y + 50, { steps: 4 });
    await page.mouse.up();
    expect(await divider.getAttribute('aria-valuenow')).toBe('100');
    // But for the divider and the names nothing differs.
    expect(difference(await stagePixels(page), before)).toBeLessThan(0.02);
    await page.mouse.move(stage.x + stage.width - 3, box.y + 50);
    await page.mouse.down();
    await page.mouse.move(stage.x, box.y + 50, { steps: 4 });
    await page.mouse.up();
    expect(difference(await stagePixels(page), after)).toBeLessThan(0.02);
    await layout('Side by side');
  });

  it('hides outliers', async () => {
    await mode('labels');
    // Purple, in any light.
    const purple = (p: Awaited<ReturnType<typeof stagePixels>>) =>
      countPixels(p, (r, g, b) => r > g + 35 && b > g + 15 && r > 100);
    const shown = purple(await stagePixels(page));
    expect(shown).toBeGreaterThan(20);
    await page.getByLabel('Hide outliers').check();
    expect(purple(await stagePixels(page))).toBeLessThan(shown / 10);
    await page.getByLabel('Hide outliers').uncheck();
    await mode('normals');
  });

  it('picks a point and tells what the files hold of it', async () => {
    await page.getByRole('combobox', { name: 'View' }).selectOption('iso');
    await settled(page);
    const stage = (await page.locator('.stage').boundingBox())!;
    for (const [x, y] of [[0.75, 0.5], [0.7, 0.48], [0.22, 0.52]] as const) {
      await page.mouse.click(stage.x + x * stage.width, stage.y + y * stage.height);
      await page.waitForSelector('.picked tr');
      const told = await rows(page, '.picked');
      const place = told['before']!.trim().split(/\s+/).map(Number);
      const at = noisy.findIndex((row) =>
        Math.hypot(row['x']! - place[0]!, row['y']! - place[1]!, row['z']! - place[2]!) < 3e-5);
      expect(at).toBeGreaterThanOrEqual(0);
      const row = clean[at]!;
      const after = told['after']!.trim().split(/\s+/).map(Number);
      expect(after[0]).toBeCloseTo(row['x']!, 4);
      expect(after[1]).toBeCloseTo(row['y']!, 4);
      expect(after[2]).toBeCloseTo(row['z']!, 4);
      expect(Number(told['moved by'])).toBeCloseTo(row['deburr_displacement']!, 3);
      expect(told['label']).toContain(['surface', 'edge', 'corner', 'isolated'][row['deburr_label']!]);
      const normal = told['normal']!.trim().split(/\s+/).map(Number);
      const cosine = normal[0]! * row['nx']! + normal[1]! * row['ny']! + normal[2]! * row['nz']!;
      expect(cosine).toBeGreaterThan(0.999);
    }
    await screenshot(page, 'part-picked');
    await page.keyboard.press('Escape');
  });

  it('draws everything only once nobody holds the view', async () => {
    const stage = (await page.locator('.stage').boundingBox())!;
    const moving = () => page.getAttribute('.stage canvas', 'data-moving');
    await page.mouse.move(stage.x + 200, stage.y + 200);
    await page.mouse.down();
    await page.mouse.move(stage.x + 240, stage.y + 200, { steps: 3 });
    await page.waitForTimeout(500);
    expect(await moving()).toBe('true');
    await page.mouse.up();
    await settled(page);
    expect(await moving()).toBe('false');
  });

  it('cuts a slab and draws its outline', async () => {
    await page.getByRole('checkbox', { name: 'Cross-section' }).check();
    await settled(page);
    await screenshot(page, 'part-section');
    const told = () => page.textContent('.section .note');
    const first = (await told())!;
    const [, thick, before, after, y] =
      /section, ([\d.]+) thick: (\d+) points before, (\d+) points after; y = (\d+(?:\.\d+)?)/.exec(first)!;
    const inside = (table: typeof noisy) => table.filter((row) =>
      Math.abs(row['y']! - Number(y)) <= Number(thick) / 2).length;
    // The page tells the place to six digits only.
    expect(Math.abs(Number(before) - inside(noisy))).toBeLessThan(4);
    expect(Math.abs(Number(after) - inside(clean))).toBeLessThan(4);
    await page.locator('.section').getByLabel('Position').fill('0.8');
    expect(await told()).not.toBe(first);
    await page.locator('.section').getByLabel('Across').selectOption('z');
    expect(await told()).toContain('z = ');
    const dark = await page.$eval('.section canvas', (canvas) => {
      const { width, height } = canvas as HTMLCanvasElement;
      const { data } = (canvas as HTMLCanvasElement).getContext('2d')!.getImageData(0, 0, width, height);
      let blue = 0;
      for (let i = 0; i < data.length; i += 4) if (data[i + 2]! > data[i]! + 60 && data[i + 3]! > 128) ++blue;
      return blue;
    });
    expect(dark).toBeGreaterThan(200);
    await page.getByRole('checkbox', { name: 'Cross-section' }).uncheck();
  });

  it('had no problem, and asked nothing of any network', () => {
    expect(opened.problems).toEqual([]);
  });
});
