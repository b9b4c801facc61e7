// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// A page in a frame of no origin, as the Python package puts it into a notebook.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { deburr, folder, launch, screenshot } from './browser';

const dir = folder();
let browser: Browser;

beforeAll(async () => {
  deburr(dir, 'synth', 'cube', 'cube.csv', '--points', '2000');
  deburr(dir, 'view', 'cube.csv', '-o', 'cube.html');
  const html = readFileSync(join(dir, 'cube.html'), 'utf8');
  const text = html.replaceAll('&', '&amp;').replaceAll('"', '&quot;');
  writeFileSync(join(dir, 'notebook.html'), `<!doctype html><p>A notebook.</p>
    <iframe sandbox="allow-scripts allow-modals" style="width:100%;height:500px"
      srcdoc="${text}"></iframe>`);
  browser = await launch();
});

afterAll(async () => {
  await browser.close();
});

it('draws in a frame that cannot reach what is around it', async () => {
  const page = await browser.newPage({ viewport: { width: 1000, height: 600 } });
  const problems: string[] = [];
  page.on('pageerror', (error) => problems.push(error.message));
  page.on('console', (message) => {
    if (message.type() === 'error') problems.push(message.text());
  });
  await page.goto(pathToFileURL(join(dir, 'notebook.html')).href);
  const frame = page.frameLocator('iframe');
  await frame.locator('html[data-ready="true"]').waitFor();
  await frame.locator('.stage canvas:not([data-frames="0"])').waitFor();
  expect(await frame.locator('.count').textContent()).toContain('Shows 2,000 of 2,000 points');
  await frame.locator('.stage canvas').focus();
  const reached = await page.frames()[1]!.evaluate(() => {
    try {
      return window.parent.document.title;
    } catch {
      return 'nothing';
    }
  });
  expect(reached).toBe('nothing');
  expect(problems).toEqual([]);
  await screenshot(page, 'frame');
});
