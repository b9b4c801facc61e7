// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// A real browser, and pages that the program has made.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { chromium, type Browser, type Page } from 'playwright-core';
import { PNG } from 'pngjs';

const root = resolve(dirname(fileURLToPath(import.meta.url)), '../../..');
const program = process.env.DEBURR ?? join(root, 'build/dev/deburr');
const browserPath = process.env.CHROMIUM ?? '/usr/bin/chromium';
const screenshots = process.env.DEBURR_SCREENSHOTS ?? join(root, 'build/viewer/screenshots');

export function folder(): string {
  return mkdtempSync(join(tmpdir(), 'deburr-viewer-'));
}

/** Runs the program and returns what it prints. */
export function deburr(cwd: string, ...args: string[]): string {
  if (!existsSync(program)) throw new Error(`${program} is missing: build it, or set DEBURR`);
  return execFileSync(program, args, { cwd, encoding: 'utf8', maxBuffer: 1e9 });
}

/** Rows of a text file, by the names of its columns: those of its header, or x y z. */
export function readTable(path: string): Record<string, number>[] {
  const lines = readFileSync(path, 'utf8').trim().split('\n');
  const named = Number.isNaN(Number(lines[0]!.split(',')[0]));
  const names = named ? lines.shift()!.split(',') : ['x', 'y', 'z'];
  return lines.map((line) => {
    const values = line.split(',').map(Number);
    return Object.fromEntries(names.map((name, k) => [name, values[k]!]));
  });
}

export function launch(...more: string[]): Promise<Browser> {
  return chromium.launch({
    executablePath: browserPath,
    args: [
      '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
      '--disable-background-networking', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
      ...more,
    ],
  });
}

/** A page, and everything that went wrong on it. */
export interface Opened {
  page: Page;
  problems: string[];
  /** Milliseconds until the points could be turned. */
  readyAfter: number;
}

// Chromium tells of waiting for a picture, which the page does on purpose.
const expected = /GPU stall due to ReadPixels/;

export async function open(browser: Browser, path: string, dark = false): Promise<Opened> {
  const context = await browser.newContext({
    viewport: { width: 1280, height: 800 }, colorScheme: dark ? 'dark' : 'light',
  });
  const page = await context.newPage();
  const problems: string[] = [];
  page.on('console', (message) => {
    const serious = message.type() === 'error' || message.type() === 'warning';
    if (serious && !expected.test(message.text())) problems.push(message.text());
  });
  page.on('pageerror', (error) => problems.push(error.message));
  page.on('dialog', (dialog) => {
    problems.push(`dialog: ${dialog.message()}`);
    void dialog.dismiss();
  });
  const url = pathToFileURL(path).href;
  page.on('request', (request) => {
    const local = request.url() === url || /^(data|blob):/.test(request.url());
    if (!local) problems.push(`request: ${request.url()}`);
  });
  const began = performance.now();
  await page.goto(url);
  await page.waitForSelector('html[data-ready]');
  const still = await page.getAttribute('html', 'data-ready') === 'still';
  if (!still) await frames(page, 1);
  return { page, problems, readyAfter: performance.now() - began };
}

/** Waits until so many pictures have been drawn. */
export async function frames(page: Page, count: number): Promise<void> {
  await page.waitForFunction(
    (n) => Number(document.querySelector<HTMLElement>('.stage canvas')?.dataset.frames ?? 0) >= n,
    count);
}

/** Waits until nothing moves and everything is drawn. */
export async function settled(page: Page): Promise<void> {
  let before = '';
  for (let i = 0; i < 50; ++i) {
    await page.waitForTimeout(120);
    const { drawn, moving, frames: n } = await page.$eval('.stage canvas', (c) => ({ ...(c as HTMLElement).dataset }));
    const now = `${drawn} ${n}`;
    if (moving === 'false' && now === before) return;
    before = now;
  }
  throw new Error('the picture does not settle');
}

export async function screenshot(page: Page, name: string): Promise<void> {
  mkdirSync(screenshots, { recursive: true });
  await page.screenshot({ path: join(screenshots, `${name}.png`) });
}

export interface Pixels {
  width: number;
  height: number;
  data: Uint8Array;
}

/** Pixels of the picture of the points, once nothing moves. */
export async function stagePixels(page: Page): Promise<Pixels> {
  await settled(page);
  return PNG.sync.read(await page.locator('.stage').screenshot());
}

/** How many pixels are as wanted. */
export function countPixels(
  { width, height, data }: Pixels, wanted: (r: number, g: number, b: number, x: number) => boolean,
): number {
  let count = 0;
  for (let i = 0; i < width * height; ++i) {
    if (wanted(data[4 * i]!, data[4 * i + 1]!, data[4 * i + 2]!, i % width)) ++count;
  }
  return count;
}

/** Share of the pixels that differ visibly between two pictures of one size. */
export function difference(a: Pixels, b: Pixels): number {
  let count = 0;
  for (let i = 0; i < a.width * a.height; ++i) {
    const far = [0, 1, 2].some((k) => Math.abs(a.data[4 * i + k]! - b.data[4 * i + k]!) > 24);
    if (far) ++count;
  }
  return count / (a.width * a.height);
}

/** The table of a panel: what its rows are called, and what they tell. */
export async function rows(page: Page, selector: string): Promise<Record<string, string>> {
  const pairs = await page.$$eval(`${selector} tr`, (lines) => lines.map((line) =>
    [line.querySelector('th')?.textContent ?? '', line.querySelector('td')?.textContent ?? '']));
  return Object.fromEntries(pairs);
}
