// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// What the keys do. They act while the picture has the focus, so that none is taken from the fields
// of the page.
import type { Mode } from '../colour/modes';
import type { Rig } from '../scene/rig';
import { nextUp } from '../scene/up';
import type { Layout, Store } from '../state';
import { el } from './dom';
import { button } from './fields';

const turn = Math.PI / 24;
const step = 0.05;
const nearer = 1.15;
const slabStep = 0.01;

export interface KeyActions {
  pickMiddle: () => void;
  help: () => void;
}

export const keyHelp: [string, string][] = [
  ['Arrows', 'turn the view'],
  ['Shift + arrows', 'move the view'],
  ['+  −', 'nearer, farther'],
  ['F', 'show everything'],
  ['1 – 6', 'colour modes, in the order of the list'],
  ['S  W  B  A', 'side by side, wipe, before, after'],
  ['<  >', 'move the wipe'],
  ['C', 'cross-section on or off'],
  ['X  Y  Z  V', 'axis of the cross-section; V faces the viewer'],
  ['Page up, page down', 'move the cross-section'],
  ['O', 'with or without perspective'],
  ['U', 'another axis up'],
  ['H', 'hide outliers'],
  ['[  ]', 'smaller, larger points'],
  ['Enter', 'pick the point in the middle'],
  ['Escape', 'pick nothing'],
  ['?', 'this list'],
];

function clamp(value: number): number {
  return Math.min(Math.max(value, 0), 1);
}

/** What a key does; false for one that does nothing here. */
export function press(
  key: string, shift: boolean, store: Store, rig: Rig, modes: Mode[], pair: boolean,
  actions: KeyActions,
): boolean {
  const state = store.get();
  const move = (right: number, up: number) =>
    shift ? rig.pan(right * step, up * step) : rig.orbit(-right * turn, -up * turn);
  const layouts: Record<string, Layout> = { s: 'side', w: 'wipe', b: 'before', a: 'after' };
  const lower = key.length === 1 ? key.toLowerCase() : key;
  switch (lower) {
    case 'ArrowLeft': move(-1, 0); return true;
    case 'ArrowRight': move(1, 0); return true;
    case 'ArrowUp': move(0, 1); return true;
    case 'ArrowDown': move(0, -1); return true;
    case '+': case '=': rig.zoom(nearer); return true;
    case '-': case '−': rig.zoom(1 / nearer); return true;
    case 'f': rig.fit(); return true;
    case '<': case ',': store.set({ wipe: clamp(state.wipe - step) }); return true;
    case '>': case '.': store.set({ wipe: clamp(state.wipe + step) }); return true;
    case 'c': store.setSlab({ on: !state.slab.on }); return true;
    case 'x': case 'y': case 'z': store.setSlab({ axis: lower, on: true }); return true;
    case 'v': store.setSlab({ axis: 'view', on: true }); return true;
    case 'PageUp': store.setSlab({ position: clamp(state.slab.position + slabStep) }); return true;
    case 'PageDown': store.setSlab({ position: clamp(state.slab.position - slabStep) }); return true;
    case 'o': store.set({ orthographic: !state.orthographic }); return true;
    case 'u': store.set({ up: nextUp(state.up) }); return true;
    case 'h': store.set({ hideOutliers: !state.hideOutliers }); return true;
    case '[': store.set({ pointSize: Math.max(0.4, state.pointSize - 0.2) }); return true;
    case ']': store.set({ pointSize: Math.min(4, state.pointSize + 0.2) }); return true;
    case 'Enter': actions.pickMiddle(); return true;
    case 'Escape': store.set({ picked: undefined }); return true;
    case '?': actions.help(); return true;
  }
  const layout = layouts[lower];
  if (layout && pair) {
    store.set({ layout });
    return true;
  }
  const mode = modes[Number(lower) - 1];
  if (mode) store.set({ mode });
  return mode !== undefined;
}

export function helpDialog(): HTMLDialogElement {
  const dialog = el('dialog', { 'aria-labelledby': 'keys-title' },
    el('h2', { id: 'keys-title' }, 'Mouse and keys'),
    el('p', {}, 'Drag to turn, drag with the right button (or two fingers) to move, wheel to come ' +
      'nearer, click to pick a point. Keys act once the picture was clicked or reached with Tab.'),
    el('table', {}, el('tbody', {}, ...keyHelp.map(([keys, what]) =>
      el('tr', {}, el('th', { scope: 'row' }, keys), el('td', {}, what))))));
  dialog.append(button('Close', () => dialog.close()));
  return dialog;
}
