// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
import { el } from './dom';

export interface Bar {
  name: string;
  value: number;
  text: string;
  /** A CSS colour; that of the page without it. */
  colour?: string;
}

/** A table whose values are drawn as bars beside their numbers. */
export function barTable(caption: string, bars: Bar[]): HTMLTableElement {
  const most = Math.max(...bars.map((bar) => bar.value), Number.MIN_VALUE);
  const rows = bars.map((bar) => {
    const drawn = el('div', { class: 'bar' });
    drawn.style.width = `${(100 * bar.value) / most}%`;
    if (bar.value > 0) drawn.style.minWidth = '1px';
    if (bar.colour) drawn.style.backgroundColor = bar.colour;
    return el('tr', {},
      el('th', { scope: 'row' }, bar.name),
      el('td', {}, bar.text),
      el('td', { class: 'drawn', 'aria-hidden': 'true' }, drawn));
  });
  return el('table', { class: 'bars' }, el('caption', {}, caption), el('tbody', {}, ...rows));
}
