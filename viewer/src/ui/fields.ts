// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// Controls that know their label.
import { el } from './dom';

export function select(
  label: string, choices: [string, string][], value: string, change: (value: string) => void,
): { element: HTMLElement; field: HTMLSelectElement } {
  const field = el('select', {}, ...choices.map(([key, name]) => el('option', { value: key }, name)));
  field.value = value;
  field.addEventListener('change', () => change(field.value));
  const name = label ? el('span', {}, label) : undefined;
  return { element: el('label', { class: 'field' }, name, field), field };
}

export function checkbox(
  label: string, value: boolean, change: (value: boolean) => void,
): { element: HTMLElement; field: HTMLInputElement } {
  const field = el('input', { type: 'checkbox' });
  field.checked = value;
  field.addEventListener('change', () => change(field.checked));
  return { element: el('label', { class: 'field check' }, field, el('span', {}, label)), field };
}

export function slider(
  label: string, low: number, high: number, step: number, value: number,
  change: (value: number) => void,
): { element: HTMLElement; field: HTMLInputElement } {
  const field = el('input', { type: 'range', min: low, max: high, step, value });
  field.addEventListener('input', () => change(field.valueAsNumber));
  return { element: el('label', { class: 'field' }, el('span', {}, label), field), field };
}

export function button(label: string, press: () => void, title?: string): HTMLButtonElement {
  const element = el('button', { type: 'button', title }, label);
  element.addEventListener('click', press);
  return element;
}

/** Buttons of which one is pressed. */
export function choice<Key extends string>(
  label: string, choices: [Key, string][], change: (value: Key) => void,
): { element: HTMLElement; show: (value: Key) => void } {
  const buttons = choices.map(([key, name]) => {
    const element = button(name, () => change(key));
    element.dataset.value = key;
    return element;
  });
  return {
    element: el('div', { class: 'choice', role: 'group', 'aria-label': label }, ...buttons),
    show: (value) => {
      for (const b of buttons) b.setAttribute('aria-pressed', String(b.dataset.value === value));
    },
  };
}
