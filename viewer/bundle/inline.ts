// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// Puts script and style into the one HTML file that the program fills in, and lets nothing but
// them run there.
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import type { Plugin } from 'vite';

/** The source expression of a content security policy for this text between its tags. */
export function hashOf(text: string): string {
  return `'sha256-${createHash('sha256').update(text, 'utf8').digest('base64')}'`;
}

/** The policy of a page with one script and one style sheet. Pictures are those in the page. */
export function policy(script: string, style: string): string {
  return [
    "default-src 'none'",
    `script-src ${hashOf(script)}`,
    `style-src ${hashOf(style)}`,
    'img-src data: blob:',
    "base-uri 'none'",
    "form-action 'none'",
  ].join('; ');
}

/** A script in which no tag can end or begin. */
export function tagSafe(script: string): string {
  return script.replace(/<\/(script)/gi, '<\\/$1').replace(/<!--/g, '<\\!--');
}

/** A licence that has to go with the code, as a comment of HTML. */
export function licenceComment(name: string, text: string): string {
  return `<!-- With parts of ${name}:\n${text.replace(/--+>?/g, '-').trim()}\n-->`;
}

export function fillTemplate(
  template: string, script: string, style: string, licence: string,
): string {
  const safe = tagSafe(script);
  const parts: [string, string][] = [
    ['<!--app:policy-->', policy(safe, style)],
    ['<!--app:licence-->', licence],
    ['<!--app:style-->', style],
    ['<!--app:script-->', safe],
  ];
  let page = template;
  for (const [mark, text] of parts) {
    if (page.split(mark).length !== 2) throw new Error(`template.html must have one ${mark}`);
    page = page.replace(mark, () => text);
  }
  return page;
}

/** Replaces everything that Vite built by template.html with script and style in it.
 * @param licencePath  of three.js, the one package whose code is in the page */
export function singlePage(templatePath: string, licencePath: string): Plugin {
  return {
    name: 'deburr-single-page',
    enforce: 'post',
    generateBundle(_options, bundle) {
      let script = '';
      let style = '';
      for (const [name, part] of Object.entries(bundle)) {
        if (part.type === 'chunk') script += part.code;
        else if (name.endsWith('.css')) style += String(part.source);
        else throw new Error(`no place in the page for ${name}`);
        delete bundle[name];
      }
      const licence = licenceComment('three.js', readFileSync(licencePath, 'utf8'));
      const source = fillTemplate(readFileSync(templatePath, 'utf8'), script, style, licence);
      this.emitFile({ type: 'asset', fileName: 'template.html', source });
    },
  };
}
