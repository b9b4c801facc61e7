// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// What was found and done, as text, tables and charts.
import { labels as labelColours, outlier, sequential, diverging } from '../colour/maps';
import type { DenoiseReport, SceneInfo, Summary } from '../data/scene';
import { barTable } from './bars';
import { el, table } from './dom';
import { count, seconds, short } from './format';
import { histogramChart } from './histogram';

function filesPart(scene: SceneInfo, report: DenoiseReport | undefined, version: string): Node[] {
  const rows: [string, string][] = scene.clouds.map((cloud, k) => [
    scene.clouds.length > 1 ? ['Before', 'After'][k]! : 'File', cloud.name,
  ]);
  if (report?.output) rows.push(['Written to', report.output]);
  rows.push(['Made by', `deburr ${report?.deburr_version ?? version}`]);
  for (const [k, cloud] of scene.clouds.entries()) {
    const name = scene.clouds.length > 1 ? ['before', 'after'][k]! : '';
    rows.push([`Points ${name}`.trim(), `${count(cloud.points)}, ${count(cloud.shown)} shown`]);
    if (cloud.nonFinite > 0) rows.push([`Not finite ${name}`.trim(), count(cloud.nonFinite)]);
  }
  const parts: Node[] = [table('Files', rows)];
  const comments = scene.clouds.flatMap((cloud) => cloud.comments);
  if (comments.length > 0) {
    parts.push(el('details', {}, el('summary', {}, `${comments.length} comments in the files`),
      el('ul', { class: 'comments' }, ...comments.map((comment) => el('li', {}, comment)))));
  }
  return parts;
}

function foundPart(report: DenoiseReport, removed: boolean): Node {
  const rows: [string, string][] = [
    ['Noise (standard deviation)', short(report.noise)],
    ['Point spacing', short(report.spacing)],
    ['Noise in spacings', short((report.noise ?? NaN) / (report.spacing ?? NaN), 3)],
    ['Bound on the movement', short(report.max_move)],
    ['Moved, root mean square', short(report.rms_displacement)],
    ['Moved at most', short(report.max_displacement)],
    ['Outliers', `${count(report.outliers)}${removed ? ', removed' : ''}`],
    ['Duplicates', count(report.duplicates)],
    ['Points not finite', count(report.non_finite)],
    ['Points written', count(report.kept)],
    ['First normals', report.kept_normals ? 'of the file' : 'estimated'],
  ];
  return table('Found, lengths in file units', rows);
}

function optionsPart(report: DenoiseReport): Node | undefined {
  const options = Object.entries(report.options ?? {});
  if (options.length === 0) return undefined;
  // 0 stands for a value that is found, which is told above.
  const found = new Set(['noise', 'max_move']);
  return table('Used', options.map(([name, value]) => [
    `--${name.replace(/_/g, '-')}`,
    found.has(name) && value === 0 ? 'found' : String(value),
  ]));
}

function labelsPart(report: DenoiseReport): Node | undefined {
  const labels = Object.entries(report.labels ?? {});
  if (labels.length === 0) return undefined;
  const colour = (name: string) =>
    `rgb(${(labelColours.find((label) => label.name === name)?.colour ?? [128, 128, 128]).join(' ')})`;
  const bars = labels.map(([name, n]) => ({ name, value: n, text: count(n), colour: colour(name) }));
  const n = report.outliers ?? 0;
  bars.push({ name: 'outlier', value: n, text: count(n), colour: `rgb(${outlier.colour.join(' ')})` });
  return barTable('Points per label', bars);
}

function summaryTable(caption: string, rows: [string, Summary][]): Node {
  return el('table', { class: 'figures' },
    el('caption', {}, caption),
    el('thead', {}, el('tr', {}, ...['', 'mean', 'rms', '95 %', 'largest'].map((name) =>
      el('th', { scope: 'col' }, name)))),
    el('tbody', {}, ...rows.map(([name, s]) =>
      el('tr', {}, el('th', { scope: 'row' }, name),
        ...[s.mean, s.rms, s.p95, s.max].map((value) => el('td', {}, short(value)))))));
}

function displacementPart(scene: SceneInfo): Node[] {
  const info = scene.displacement;
  if (!info || info.count === 0) return [];
  const range = { low: info.signed ? -info.range : 0, high: info.range };
  return [
    el('h3', {}, info.signed ? 'Displacement along the normals' : 'Displacement'),
    histogramChart(info.histogram, info.signed ? diverging : sequential, range),
    summaryTable(`Of ${count(info.count)} points, in file units`, [['moved', info]]),
  ];
}

function truthPart(scene: SceneInfo): Node | undefined {
  if (!scene.truth) return undefined;
  const names = scene.truth.length > 1 ? ['before', 'after'] : ['points'];
  return summaryTable('Distance to the true surface, in file units',
    scene.truth.map((summary, k) => [names[k]!, summary]));
}

function roundsPart(report: DenoiseReport): Node | undefined {
  const rounds = report.rounds ?? [];
  if (rounds.length === 0) return undefined;
  return barTable('Movement per round: rms, largest', rounds.map((round, k) => ({
    name: String(k + 1), value: round.rms_move,
    text: `${short(round.rms_move, 3)}, ${short(round.max_move, 3)}`,
  })));
}

function stagesPart(report: DenoiseReport): Node | undefined {
  const stages = report.stages ?? [];
  if (stages.length === 0) return undefined;
  const total = stages.reduce((sum, stage) => sum + stage.seconds, 0);
  const bars = stages.map(({ stage, seconds: took }) => ({
    name: stage, value: took, text: seconds(took),
  }));
  return barTable(`Time per stage, ${seconds(total)} in all`, bars);
}

export function reportPanel(
  scene: SceneInfo, report: DenoiseReport | undefined, version: string,
): HTMLElement {
  const parts: (Node | undefined)[] = [];
  if (report) {
    for (const warning of report.warnings ?? []) parts.push(el('p', { class: 'warning' }, warning));
    parts.push(foundPart(report, (scene.removed ?? 0) > 0), labelsPart(report));
  }
  parts.push(...displacementPart(scene), truthPart(scene));
  if (report) parts.push(roundsPart(report), optionsPart(report), stagesPart(report));
  parts.push(...filesPart(scene, report, version));
  return el('section', { class: 'report', 'aria-labelledby': 'report-title' },
    el('h2', { id: 'report-title' }, 'Report'), ...parts);
}
