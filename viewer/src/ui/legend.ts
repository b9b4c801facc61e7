// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// What the colours mean, and between which values they run.
import { gradient, labels, outlier } from '../colour/maps';
import { mapOf, modeNames, type Mode, type Range } from '../colour/modes';
import type { SceneInfo } from '../data/scene';
import { el } from './dom';
import { short } from './format';
import { removedText } from './words';

const meanings: Record<Mode, string> = {
  normals: 'Brightness tells how a place faces the viewer.',
  colours: 'As the file has them.',
  intensity: 'In units of the file.',
  displacement: 'How far each point was moved, in file units.',
  labels: 'What each point lies on.',
  truth: 'Distance of each point from the true surface, in file units.',
};

function labelKeys(): Node {
  return el('ul', { class: 'keys' }, ...[...labels, outlier].map(({ name, colour }) => {
    const patch = el('span', { class: 'patch', 'aria-hidden': 'true' });
    patch.style.backgroundColor = `rgb(${colour.join(' ')})`;
    return el('li', {}, patch, name);
  }));
}

/** A bar of the colours with the values at its ends, which can be typed. */
function scale(mode: Mode, scene: SceneInfo, range: Range, change: (range?: Range) => void): Node[] {
  const bar = el('div', { class: 'bar-of-colours', role: 'img',
    'aria-label': `Colours from ${short(range.low)} to ${short(range.high)}` });
  bar.style.backgroundImage = gradient(mapOf(mode, scene));
  const symmetric = range.low === -range.high;
  const input = (name: string, value: number, apply: (value: number) => Range) => {
    const field = el('input', { type: 'number', step: 'any', value: Number(value.toPrecision(5)),
      'aria-label': name });
    field.addEventListener('change', () => {
      const next = apply(field.valueAsNumber);
      if (Number.isFinite(next.low) && next.high > next.low) change(next);
      else field.value = String(value);
    });
    return field;
  };
  const low = input('Value of the first colour', range.low, (v) =>
    symmetric ? { low: -Math.abs(v), high: Math.abs(v) } : { low: v, high: range.high });
  const high = input('Value of the last colour', range.high, (v) =>
    symmetric ? { low: -Math.abs(v), high: Math.abs(v) } : { low: range.low, high: v });
  const reset = el('button', { type: 'button', title: 'Range that holds 98 % of the points' }, 'Auto');
  reset.addEventListener('click', () => change(undefined));
  const ends = el('div', { class: 'ends' }, low, reset, high);
  return [bar, ends];
}

export function legend(
  mode: Mode, scene: SceneInfo, range: Range | undefined, change: (range?: Range) => void,
): HTMLElement {
  const parts: Node[] = [];
  if (mode === 'labels') parts.push(labelKeys());
  if (range) parts.push(...scale(mode, scene, range, change));
  let meaning = meanings[mode];
  if (mode === 'displacement' && scene.displacement?.signed) {
    meaning = 'How far each point was moved along its normal, in file units: ' +
      'outwards is positive.';
  }
  if (mode === 'displacement' && scene.removed) meaning += ' What was removed is grey.';
  if (mode === 'labels' && scene.removed) {
    meaning += ` ${removedText(scene.removed)}: they are shown before, not after.`;
  }
  return el('div', { class: 'legend', role: 'group', 'aria-label': `Legend: ${modeNames[mode]}` },
    ...parts, el('p', { class: 'note' }, meaning));
}
