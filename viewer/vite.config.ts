// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { singlePage } from './bundle/inline';

export default defineConfig({
  plugins: [singlePage(fileURLToPath(new URL('./template.html', import.meta.url)))],
  build: {
    target: 'es2022',
    cssCodeSplit: false,
    modulePreload: false,
    rollupOptions: {
      input: fileURLToPath(new URL('./src/main.ts', import.meta.url)),
      output: { format: 'iife', inlineDynamicImports: true, entryFileNames: 'main.js' },
    },
  },
});
