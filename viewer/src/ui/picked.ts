// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// What is known of the point that was picked.
import { labels } from '../colour/maps';
import { coordinates, isOutlier, labelOf, type Cloud, type Vec3 } from '../data/cloud';
import type { SceneInfo } from '../data/scene';
import { el, table } from './dom';
import { coordinate, short } from './format';

const axes = ['x', 'y', 'z'];
const byteScale = 127;

function place(cloud: Cloud, point: number): string {
  return coordinates(cloud, point).map((v, k) => coordinate(v, cloud.step[k]!)).join('  ');
}

function labelText(cloud: Cloud, point: number): string {
  const label = labels[labelOf(cloud, point)]?.name;
  const known = [label, isOutlier(cloud, point) ? 'outlier' : undefined].filter((name) => name);
  return known.join(', ') || 'unknown';
}

/** The rows of the panel for one point; also what tests compare with the file. */
export function pickedRows(
  scene: SceneInfo, clouds: Cloud[], cloud: number, point: number,
): [string, string][] {
  const rows: [string, string][] = [];
  const shown = clouds[cloud]!;
  const [before, after] = clouds;
  const isPair = scene.paired && before && after && point < before.count && point < after.count;
  if (isPair) {
    rows.push(['before', place(before, point)], ['after', place(after, point)]);
    const a = coordinates(before, point);
    const moved = coordinates(after, point).map((v, k) => v - a[k]!) as Vec3;
    rows.push(['moved by', short(Math.hypot(...moved))]);
    rows.push(['as a vector', moved.map((v) => short(v)).join('  ')]);
  } else {
    rows.push([axes.join(' '), place(shown, point)]);
  }
  const known = isPair ? after : shown;
  const value = known.displacement?.[point];
  if (value !== undefined && Number.isFinite(value)) {
    rows.push([scene.displacement?.signed ? 'along the normal' : 'displacement', short(value)]);
  }
  // A page holds directions to about a degree.
  const normal = [0, 1, 2].map((k) => (known.normals[3 * point + k]! / byteScale).toFixed(2));
  rows.push([known.info.estimatedNormals ? 'normal (estimated)' : 'normal', normal.join('  ')]);
  if (known.flags) rows.push(['label', labelText(known, point)]);
  if (scene.paired && !isPair) rows.push(['after', 'removed']);
  const intensity = known.intensity?.[point];
  if (intensity !== undefined) {
    rows.push(['intensity', Number.isInteger(intensity) ? String(intensity) : short(intensity, 6)]);
  }
  if (known.colours) {
    rows.push(['colour', Array.from(known.colours.subarray(3 * point, 3 * point + 3)).join(' ')]);
  }
  if (isPair && before.truth) rows.push(['to the truth, before', short(before.truth[point])]);
  if (known.truth) rows.push([isPair ? 'to the truth, after' : 'to the truth', short(known.truth[point])]);
  return rows;
}

export function pickedPanel(
  scene: SceneInfo, clouds: Cloud[], picked: { cloud: number; point: number } | undefined,
): Node {
  if (!picked) {
    return el('p', { class: 'note' }, 'Click on a point, or press Enter for the one in the middle.');
  }
  return table('In file units', pickedRows(scene, clouds, picked.cloud, picked.point));
}
