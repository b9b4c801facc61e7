// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// Without a mouse, without sight, in the dark, on paper, without WebGL.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { countPixels, deburr, difference, folder, launch, open, rows, screenshot, settled, stagePixels } from './browser';

const dir = folder();
let browser: Browser;

beforeAll(async () => {
  deburr(dir, 'synth', 'part', 'a.ply', '--points', '8000', '--truth', 'truth.ply', '--clean', 'b.ply');
  deburr(dir, 'view', 'a.ply', 'b.ply', '-o', 'view.html', '--truth', 'truth.ply');
  deburr(dir, 'view', 'b.ply', '-o', 'one.html');
  writeFileSync(join(dir, 'point.xyz'), '1 2 3\n');
  deburr(dir, 'view', 'point.xyz', '-o', 'point.html');
  browser = await launch();
});

afterAll(async () => {
  await browser.close();
});

describe('keys', () => {
  it('do what the list says', async () => {
    const { page, problems } = await open(browser, join(dir, 'view.html'));
    const canvas = page.locator('.stage canvas');
    await canvas.focus();
    const press = async (key: string) => {
      await page.keyboard.press(key);
      return stagePixels(page);
    };
    const start = await stagePixels(page);
    const turned = await press('ArrowLeft');
    expect(difference(start, turned)).toBeGreaterThan(0.01);
    expect(difference(await press('ArrowRight'), start)).toBeLessThan(0.01);
    expect(difference(await press('Shift+ArrowUp'), start)).toBeGreaterThan(0.01);
    expect(difference(await press('f'), start)).toBeLessThan(0.005);
    const near = await press('+');
    const ink = (p: typeof near) => countPixels(p, (r) => r < 200);
    expect(ink(near)).toBeGreaterThan(ink(start) * 1.1);
    await press('f');
    expect(difference(await press('o'), start)).toBeGreaterThan(0.003);
    await press('o');
    await press('w');
    expect(await page.getByRole('button', { name: 'Wipe' }).getAttribute('aria-pressed')).toBe('true');
    await press('>');
    expect(await page.getByRole('slider', { name: /Wipe/ }).getAttribute('aria-valuenow')).toBe('55');
    await press('s');
    await press('2');
    expect(await page.getByRole('combobox', { name: 'Colour' }).inputValue()).toBe('displacement');
    await press('1');
    await press('x');
    expect(await page.locator('.section').isVisible()).toBe(true);
    await press('PageUp');
    expect(await page.locator('.section').getByLabel('Position').inputValue()).toBe('0.51');
    await press('c');
    await press('Enter');
    expect(Object.keys(await rows(page, '.picked'))).toContain('after');
    await press('Escape');
    expect(await page.locator('.picked tr').count()).toBe(0);
    await page.keyboard.press('?');
    expect(await page.getByRole('dialog').isVisible()).toBe(true);
    await screenshot(page, 'keys');
    await page.keyboard.press('Escape');
    expect(problems).toEqual([]);
  });

  it('reach every control, and every control has a name', async () => {
    const { page } = await open(browser, join(dir, 'view.html'));
    await page.getByRole('checkbox', { name: 'Cross-section' }).check();
    await page.getByRole('combobox', { name: 'Colour' }).selectOption('displacement');
    const nameless = await page.$$eval('button, input, select, canvas, [role]', (elements) =>
      elements.filter((e) => {
        const field = e as HTMLInputElement;
        const labelled = field.labels && field.labels.length > 0;
        return !labelled && !e.getAttribute('aria-label') && !e.getAttribute('aria-labelledby') &&
          !e.textContent?.trim() && e.getAttribute('role') !== 'status';
      }).map((e) => e.outerHTML));
    expect(nameless).toEqual([]);
    const focusable = await page.$$eval('button, input, select, summary, [tabindex="0"]', (elements) => {
      const shown = elements.filter((e) => (e as HTMLElement).offsetParent !== null);
      shown.forEach((e, k) => e.setAttribute('data-test', String(k)));
      return shown.length;
    });
    const reached = new Set<string>();
    for (let i = 0; i < focusable + 5; ++i) {
      await page.keyboard.press('Tab');
      reached.add(await page.evaluate(() => document.activeElement?.getAttribute('data-test') ?? ''));
    }
    reached.delete('');
    expect(reached.size).toBe(focusable);
  });
});

describe('the page', () => {
  it('is dark where the reader wants it', async () => {
    const { page, problems } = await open(browser, join(dir, 'view.html'), true);
    const dark = await stagePixels(page);
    expect(countPixels(dark, (r, g, b) => r + g + b < 120)).toBeGreaterThan(dark.width * dark.height * 0.4);
    await page.getByRole('combobox', { name: 'Colour' }).selectOption('truth');
    await page.getByRole('checkbox', { name: 'Cross-section' }).check();
    await settled(page);
    await screenshot(page, 'dark');
    const section = () => page.$eval('.section canvas', (canvas) =>
      (canvas as HTMLCanvasElement).toDataURL());
    const before = await section();
    await page.getByRole('button', { name: 'Light' }).click();
    expect(await section()).not.toBe(before);
    const light = await stagePixels(page);
    expect(countPixels(light, (r, g, b) => r + g + b < 120)).toBeLessThan(light.width * light.height * 0.2);
    expect(problems).toEqual([]);
  });

  it('shows a single point', async () => {
    const { page, problems } = await open(browser, join(dir, 'point.html'));
    const seen = await stagePixels(page);
    // Between what the page says at its sides.
    expect(countPixels(seen, (r, _g, _b, x) => r < 200 && x > 300 && x < 700)).toBeGreaterThan(20);
    expect(problems).toEqual([]);
  });

  it('shows one cloud alone', async () => {
    const { page, problems } = await open(browser, join(dir, 'one.html'));
    expect(await page.title()).toBe('b.ply – deburr');
    expect(await page.getByRole('button', { name: 'Wipe' }).count()).toBe(0);
    await screenshot(page, 'one');
    expect(problems).toEqual([]);
  });

  it('can be printed', async () => {
    const { page } = await open(browser, join(dir, 'view.html'));
    await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')));
    await page.emulateMedia({ media: 'print' });
    expect(await page.locator('.toolbar').first().isVisible()).toBe(false);
    expect(await page.locator('.report').isVisible()).toBe(true);
    const drawn = await page.$eval('.paper', (img) => (img as HTMLImageElement).naturalWidth);
    expect(drawn).toBeGreaterThan(300);
    await screenshot(page, 'print');
    expect((await page.pdf()).length).toBeGreaterThan(10_000);
  });

  it('is printed on white paper from a dark screen, and dark again after it', async () => {
    const { page } = await open(browser, join(dir, 'view.html'), true);
    await page.getByRole('checkbox', { name: 'Cross-section' }).check();
    await page.locator('.stage canvas').focus();
    await page.keyboard.press('Enter');
    await settled(page);
    // Around the point on paper too, where the picture has another size.
    expect(await page.$eval('.ring', (mark) => (mark as HTMLElement).style.left)).toMatch(/%$/);
    const theme = () => page.getAttribute('html', 'data-theme');
    const drawn = () => page.$eval('.section canvas', (canvas) => (canvas as HTMLCanvasElement).toDataURL());
    const onScreen = await drawn();
    await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')));
    expect(await theme()).toBe('light');
    expect(await drawn()).not.toBe(onScreen);
    await page.emulateMedia({ media: 'print' });
    await screenshot(page, 'print-dark');
    expect(await page.locator('.on-screen').isVisible()).toBe(false);
    await page.emulateMedia({ media: 'screen' });
    await page.evaluate(() => window.dispatchEvent(new Event('afterprint')));
    expect(await theme()).toBe('dark');
    expect(await drawn()).toBe(onScreen);
    expect(await page.locator('.paper').count()).toBe(0);
  });

  it('shows still pictures and the report where there is no WebGL', async () => {
    const without = await launch('--disable-3d-apis');
    const { page } = await open(without, join(dir, 'view.html'));
    expect(await page.getAttribute('html', 'data-ready')).toBe('still');
    expect(await page.getByRole('alert').textContent()).toContain('cannot be shown');
    const widths = await page.$$eval('#stills img', (images) =>
      images.map((img) => (img as HTMLImageElement).naturalWidth));
    expect(widths).toEqual([480, 480]);
    expect(await page.locator('.report').isVisible()).toBe(true);
    await screenshot(page, 'no-webgl');
    await without.close();
  });
});
