// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
import { modeNames, type Mode } from '../colour/modes';
import { views, type ViewName } from '../scene/rig';
import { upAxes, upName, type Up } from '../scene/up';
import type { Layout, Store } from '../state';
import { el } from './dom';
import { button, checkbox, choice, select, slider } from './fields';

export interface ToolbarActions {
  fit: () => void;
  look: (view: ViewName) => void;
}

export interface PageActions {
  help: () => void;
  print: () => void;
}

export const layoutNames: [Layout, string][] = [
  ['side', 'Side by side'], ['wipe', 'Wipe'], ['before', 'Before'], ['after', 'After'],
];

export function toolbar(
  store: Store, modes: Mode[], clouds: number, outliers: boolean, actions: ToolbarActions,
): HTMLElement {
  const layout = choice('What is shown', layoutNames, (value) => store.set({ layout: value }));
  const mode = select('Colour', modes.map((m) => [m, modeNames[m]]), modes[0]!,
    (value) => store.set({ mode: value as Mode }));
  const size = slider('Point size', 0.4, 4, 0.1, store.get().pointSize,
    (value) => store.set({ pointSize: value }));
  const parallel = checkbox('Parallel', store.get().orthographic,
    (value) => store.set({ orthographic: value }));
  const hide = checkbox('Hide outliers', store.get().hideOutliers,
    (value) => store.set({ hideOutliers: value }));
  const cut = checkbox('Cross-section', store.get().slab.on, (value) => store.setSlab({ on: value }));
  const look = select('', [['', 'View …'], ...Object.keys(views).map((name): [string, string] =>
    [name, name])], '', (value) => {
    if (value) actions.look(value as ViewName);
    look.field.value = '';
  });
  look.field.setAttribute('aria-label', 'View');
  const up = select('Up', upAxes.map((axis): [string, string] => [axis, upName(axis)]),
    store.get().up, (value) => store.set({ up: value as Up }));
  store.watch((state) => {
    layout.show(state.layout);
    up.field.value = state.up;
    mode.field.value = state.mode;
    size.field.valueAsNumber = state.pointSize;
    parallel.field.checked = state.orthographic;
    hide.field.checked = state.hideOutliers;
    cut.field.checked = state.slab.on;
  });
  return el('div', { class: 'toolbar', role: 'toolbar', 'aria-label': 'View' },
    clouds > 1 ? layout.element : undefined,
    mode.element, cut.element, outliers ? hide.element : undefined, parallel.element, size.element,
    look.element, up.element, button('Fit', actions.fit, 'Show everything (F)'));
}

/** What concerns the page, not the picture. */
export function pageButtons(store: Store, actions: PageActions): HTMLElement {
  const theme = button('Dark', () => store.set({ dark: !store.get().dark }), 'Dark or light page');
  store.watch((state) => {
    theme.textContent = state.dark ? 'Light' : 'Dark';
  });
  return el('div', { class: 'group' }, theme,
    button('Print', actions.print, 'Print the report with the picture'),
    button('Keys', actions.help, 'What mouse and keys do (?)'));
}
