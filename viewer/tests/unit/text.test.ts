// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
import { createHash } from 'node:crypto';
import { describe, expect, it } from 'vitest';
import { fillTemplate, licenceComment, policy, tagSafe } from '../../bundle/inline';
import { baseName, coordinate, count, seconds, short } from '../../src/ui/format';
import { binMiddle } from '../../src/ui/histogram';

describe('numbers for people', () => {
  it('have as many digits as count', () => {
    expect(short(0.0123456)).toBe('0.01235');
    expect(short(123.456)).toBe('123.5');
    expect(short(-2)).toBe('-2.000');
    expect(short(0)).toBe('0');
    expect(short(1.5e-9)).toBe('1.5e-9');
    expect(seconds(8e-5)).toBe('< 0.001 s');
    expect(seconds(0.0137)).toBe('0.014 s');
    expect(seconds(12.34)).toBe('12.3 s');
    expect(short(NaN)).toBe('–');
    expect(short(undefined)).toBe('–');
    expect(count(1234567)).toBe('1,234,567');
  });

  it('show coordinates as exactly as they are known', () => {
    expect(coordinate(4500000.1234567, 6e-5)).toBe('4500000.12346');
    expect(coordinate(1, 0)).toBe('1.000000');
    expect(coordinate(12345.6, 20)).toBe('12346');
  });

  it('name a file without its folder', () => {
    expect(baseName('/a/b.ply')).toBe('b.ply');
    expect(baseName('-')).toBe('-');
  });

  it('tell the middle of a bin', () => {
    expect(binMiddle({ low: -1, high: 1, counts: [0, 0], below: 0, above: 0 }, 1)).toBe(0.5);
  });
});

describe('the single page', () => {
  const template = '<!--app:licence--><meta content="<!--app:policy-->"><style><!--app:style--></style>' +
    '<script><!--app:script--></script>';

  it('allows its own script and style by their hashes, and nothing else', () => {
    const page = fillTemplate(template, 'let a = "$&";', 'p{}', '');
    expect(page).toContain('<script>let a = "$&";</script>');
    const hash = createHash('sha256').update('let a = "$&";').digest('base64');
    expect(page).toContain(`script-src 'sha256-${hash}'`);
    expect(policy('', '')).toContain("default-src 'none'");
    expect(policy('', '')).not.toContain('unsafe');
  });

  it('holds no tag in its script', () => {
    expect(tagSafe('"</script><!-- "')).toBe('"<\\/script><\\!-- "');
  });

  it('carries the licence of what is in it, as a comment that nothing ends', () => {
    const comment = licenceComment('three', 'MIT --> <b> ---- x');
    expect(comment.startsWith('<!-- With parts of three:')).toBe(true);
    expect(comment.indexOf('-->')).toBe(comment.length - 3);
    expect(comment).toContain('MIT');
    expect(fillTemplate(template, '', '', comment).startsWith(comment)).toBe(true);
  });

  it('needs every mark once', () => {
    expect(() => fillTemplate('<!--app:style-->', '', '', '')).toThrow('app:policy');
    expect(() => fillTemplate(template + '<!--app:script-->', '', '', '')).toThrow('app:script');
  });
});
