// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
import { App } from './app';
import { fromBase64 } from './data/bytes';
import { decodeScene } from './data/cloud';
import { parseScene, type DenoiseReport } from './data/scene';
import './page.css';
import { el } from './ui/dom';
import { reportPanel } from './ui/report';
import { titleOf } from './ui/words';

function block(name: string): string | undefined {
  return document.getElementById(`deburr-${name}`)?.textContent ?? undefined;
}

function hasWebGl(): boolean {
  return document.createElement('canvas').getContext('webgl2') !== null;
}

function start(): void {
  const root = document.getElementById('app')!;
  const stills = document.getElementById('stills');
  const version = block('version') ?? '';
  const scene = parseScene(block('scene') ?? '');
  const reportText = block('report');
  const report = reportText ? (JSON.parse(reportText) as DenoiseReport) : undefined;
  document.title = `${titleOf(scene)} – deburr`;
  try {
    const points = document.getElementById('deburr-points')!;
    const clouds = decodeScene(fromBase64(points.textContent ?? ''), scene);
    points.remove(); // twice the memory for nothing
    new App(root, scene, clouds, report, version);
    stills?.remove();
    document.documentElement.dataset.ready = 'true';
  } catch (error) {
    // Without WebGL the still pictures stay, and what can be told without it.
    const reason = hasWebGl() ? String(error) : 'this browser has no WebGL 2.';
    root.replaceChildren(
      el('header', {}, el('h1', {}, titleOf(scene)), el('p', {}, `deburr ${version}`)),
      el('p', { class: 'warning failure', role: 'alert' }, `The points cannot be shown: ${reason}`));
    document.body.append(reportPanel(scene, report, version));
    document.documentElement.dataset.ready = 'still';
  }
}

start();
