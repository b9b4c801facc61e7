// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { singlePage } from './bundle/inline';

const path = (name: string) => fileURLToPath(new URL(name, import.meta.url));

export default defineConfig({
  plugins: [singlePage(path('./template.html'), path('./node_modules/three/LICENSE'))],
  build: {
    target: 'es2022',
    cssCodeSplit: false,
    modulePreload: false,
    rollupOptions: {
      input: path('./src/main.ts'),
      output: { format: 'iife', inlineDynamicImports: true, entryFileNames: 'main.js' },
    },
  },
});
