// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// What the page says of the clouds as a whole.
import type { SceneInfo } from '../data/scene';
import { baseName, count } from './format';

/** What became of points that are in the first cloud only. */
export function removedText(points: number): string {
  return points === 1 ? '1 outlier was removed' : `${count(points)} outliers were removed`;
}

export function titleOf(scene: SceneInfo): string {
  return scene.clouds.map((cloud) => baseName(cloud.name)).join(' → ');
}

export function shownText(scene: SceneInfo): string {
  const shown = scene.clouds.map((cloud) => cloud.shown);
  const all = scene.clouds.map((cloud) => cloud.points);
  const same = new Set(shown).size === 1 && new Set(all).size === 1;
  const one = (k: number) => `${count(shown[k])} of ${count(all[k])}`;
  if (shown.length < 2) return `Shows ${one(0)} points`;
  const text = same ? `Shows ${one(0)} points, before and after`
    : `Shows ${one(0)} points before and ${one(1)} after`;
  return scene.removed ? `${text}; ${removedText(scene.removed)}` : text;
}
