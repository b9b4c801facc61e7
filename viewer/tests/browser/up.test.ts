// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// A part that lies on its side in its file looks as the upright one, once its up is chosen.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import {
  deburr, difference, folder, launch, open, readTable, screenshot, settled, stagePixels, type Pixels,
} from './browser';

const dir = folder();
let browser: Browser;

beforeAll(async () => {
  deburr(dir, 'synth', 'part', 'z.csv', '--points', '8000', '--noise', '0');
  const points = readTable(join(dir, 'z.csv'));
  const lines = (place: (x: number, y: number, z: number) => number[]) =>
    points.map((p) => place(p['x']!, p['y']!, p['z']!).join(',')).join('\n');
  writeFileSync(join(dir, 'y.csv'), lines((x, y, z) => [x, z, -y]));
  writeFileSync(join(dir, 'down.csv'), lines((x, y, z) => [x, -z, y]));
  deburr(dir, 'view', 'z.csv', '-o', 'z.html');
  deburr(dir, 'view', 'y.csv', '-o', 'y.html');
  deburr(dir, 'view', 'down.csv', '-o', 'down.html', '--up', '-y');
  browser = await launch();
});

afterAll(async () => {
  await browser.close();
});

async function look(page: Page, view: string): Promise<Pixels> {
  await page.getByRole('combobox', { name: 'View' }).selectOption(view);
  return stagePixels(page);
}

/** What a part looks like from some sides. */
async function sides(page: Page): Promise<Pixels[]> {
  const seen: Pixels[] = [await stagePixels(page)];
  for (const view of ['front', 'right', 'top']) seen.push(await look(page, view));
  return seen;
}

/** What it looks like turned by keys and mouse. */
async function turned(page: Page): Promise<Pixels[]> {
  const seen: Pixels[] = [await look(page, 'iso')];
  await page.locator('.stage canvas').focus();
  for (const key of ['ArrowLeft', 'ArrowUp', 'o']) {
    await page.keyboard.press(key);
    seen.push(await stagePixels(page));
  }
  const stage = (await page.locator('.stage').boundingBox())!;
  await page.mouse.move(stage.x + 300, stage.y + 300);
  await page.mouse.down();
  await page.mouse.move(stage.x + 380, stage.y + 340, { steps: 3 });
  await page.mouse.up();
  seen.push(await stagePixels(page));
  return seen;
}

function expectAlike(a: Pixels[], b: Pixels[]): void {
  expect(b.length).toBe(a.length);
  // The size of points is measured on a few of them, and these are others: outlines differ by up
  // to 0.03, other views by 0.09 and more.
  a.forEach((picture, k) => expect(difference(picture, b[k]!), `picture ${k}`).toBeLessThan(0.05));
}

describe('up', () => {
  it('is an axis that the user chooses, and all views follow', async () => {
    const upright = await open(browser, join(dir, 'z.html'));
    const lying = await open(browser, join(dir, 'y.html'));
    const expected = [...await sides(upright.page), ...await turned(upright.page)];
    expect(difference(await stagePixels(lying.page), expected[0]!)).toBeGreaterThan(0.05);
    await screenshot(lying.page, 'up-lying');
    const up = lying.page.getByRole('combobox', { name: 'Up', exact: true });
    await up.selectOption('y');
    await lying.page.getByRole('button', { name: 'Fit', exact: true }).click();
    expectAlike(expected, [...await sides(lying.page), ...await turned(lying.page)]);
    await screenshot(lying.page, 'up-chosen');
    // It is kept, and its key goes on to the next axis.
    expect(await up.inputValue()).toBe('y');
    await lying.page.locator('.stage canvas').focus();
    await lying.page.keyboard.press('u');
    expect(await up.inputValue()).toBe('x');
    expect([...upright.problems, ...lying.problems]).toEqual([]);
  });

  it('can come with the page', async () => {
    const upright = await open(browser, join(dir, 'z.html'));
    const given = await open(browser, join(dir, 'down.html'));
    expect(await given.page.getByRole('combobox', { name: 'Up', exact: true }).inputValue()).toBe('-y');
    expectAlike(await sides(upright.page), await sides(given.page));
  });

  it('is up in the cross-section too', async () => {
    const { page } = await open(browser, join(dir, 'y.html'));
    await page.getByRole('checkbox', { name: 'Cross-section' }).check();
    const section = page.locator('.section');
    const drawn = () => section.locator('canvas').evaluate((canvas) =>
      (canvas as HTMLCanvasElement).toDataURL());
    await section.getByLabel('Across').selectOption('z');
    await settled(page);
    const lying = await drawn();
    await page.getByRole('combobox', { name: 'Up', exact: true }).selectOption('-y');
    await settled(page);
    expect(await drawn()).not.toBe(lying);
    expect(await page.textContent('.section .note')).toContain('z = ');
  });
});
