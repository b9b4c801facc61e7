// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// Names and comments of files that want to be more than text.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { deburr, folder, launch, open, screenshot } from './browser';

const dir = folder();
const name = `<img src=x onerror=alert(1)>"'&amp;.ply`;
const comments = [
  '</script><script>alert(2)</script>',
  '<!--<script>',
  '<svg onload=alert(3)>',
  'javascript:alert(4)',
  '${alert(5)} {{alert(6)}}',
];
let browser: Browser;

beforeAll(async () => {
  deburr(dir, 'synth', 'cube', 'plain.csv', '--points', '2000');
  const header = ['ply', 'format ascii 1.0', ...comments.map((c) => `comment ${c}`),
    'element vertex 8', 'property double x', 'property double y', 'property double z', 'end_header'];
  const corners = Array.from({ length: 8 }, (_, i) => `${i & 1} ${(i >> 1) & 1} ${i >> 2}`);
  writeFileSync(join(dir, name), [...header, ...corners, ''].join('\n'));
  deburr(dir, 'denoise', name, `clean ${name}`, '--report', 'report.html');
  browser = await launch();
});

afterAll(async () => {
  await browser.close();
});

describe('a hostile file', () => {
  it('is shown as text', async () => {
    const { page, problems } = await open(browser, join(dir, 'report.html'));
    await page.waitForTimeout(300);
    expect(await page.title()).toContain(name);
    expect(await page.textContent('h1')).toContain(name);
    await page.locator('.report details').first().click();
    const shown = await page.$$eval('.comments li', (items) => items.map((item) => item.textContent));
    for (const comment of comments) expect(shown).toContain(comment);
    await screenshot(page, 'hostile');
    expect(await page.locator('img[src="x"], svg[onload], iframe').count()).toBe(0);
    const scripts = await page.$$eval('script', (all) => all.filter((s) => !s.type).length);
    expect(scripts).toBe(1);
    expect(problems).toEqual([]);
  });

  it('could not run a script or reach a network if it were markup', async () => {
    const { page } = await open(browser, join(dir, 'report.html'));
    const done = await page.evaluate(async () => {
      const script = document.createElement('script');
      script.textContent = 'window.ran = true';
      document.body.append(script);
      document.body.insertAdjacentHTML('beforeend', '<img src="x" onerror="window.ran = true">');
      await new Promise((resolve) => setTimeout(resolve, 200));
      const reached = await fetch('data:text/plain,hello').then(() => true, () => false);
      return { ran: 'ran' in window, reached };
    });
    expect(done).toEqual({ ran: false, reached: false });
  });
});
