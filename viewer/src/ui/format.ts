// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0

/** A number for people, with this many digits that count. */
export function short(value: number | undefined, digits = 4): string {
  if (value === undefined || !Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const size = Math.floor(Math.log10(Math.abs(value)));
  if (size < -4 || size > 6) return value.toExponential(Math.max(digits - 3, 0));
  return value.toFixed(Math.max(0, digits - 1 - size));
}

/** A time in seconds, to the millisecond. */
export function seconds(value: number): string {
  return value < 0.0005 ? '< 0.001 s' : `${short(value, value < 1 ? 2 : 3)} s`;
}

/** A count with its thousands apart. */
export function count(value: number | undefined): string {
  return value === undefined ? '–' : value.toLocaleString('en-US');
}

/** A coordinate with the decimals that its step can tell. */
export function coordinate(value: number, step: number): string {
  const decimals = step > 0 ? Math.min(Math.max(Math.ceil(-Math.log10(step)), 0), 12) : 6;
  return value.toFixed(decimals);
}

/** The last part of a path. */
export function baseName(path: string): string {
  return path.split('/').pop() || path;
}
