// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// What the program wrote into the page; docs/view.md describes it.

export interface ArrayInfo {
  type: 'u24' | 'u16' | 'u8' | 'octahedral';
  offset: number;
  components: number;
  low?: number[];
  step?: number[];
}

export interface CloudInfo {
  name: string;
  points: number;
  nonFinite: number;
  shown: number;
  comments: string[];
  estimatedNormals: boolean;
  arrays: Record<string, ArrayInfo>;
}

export interface Summary {
  count: number;
  mean: number;
  rms: number;
  p95: number;
  max: number;
}

export interface Histogram {
  low: number;
  high: number;
  counts: number[];
  below: number;
  above: number;
}

export interface DisplacementInfo extends Summary {
  range: number;
  signed: boolean;
  histogram: Histogram;
}

export interface SceneInfo {
  format: number;
  /** The axis that points up at first. */
  up?: string;
  paired: boolean;
  /** Points of the first cloud that were left out of the second; of pairs only. */
  removed?: number;
  clouds: CloudInfo[];
  displacement?: DisplacementInfo;
  truth?: Summary[];
  truthRange?: number;
}

/** What `deburr denoise --json` tells. */
export interface DenoiseReport {
  deburr_version?: string;
  input?: string;
  output?: string;
  options?: Record<string, unknown>;
  points?: number;
  non_finite?: number;
  duplicates?: number;
  outliers?: number;
  kept?: number;
  spacing?: number;
  noise?: number;
  max_move?: number;
  kept_normals?: boolean;
  labels?: Record<string, number>;
  rms_displacement?: number;
  max_displacement?: number;
  rounds?: { rms_move: number; max_move: number }[];
  stages?: { stage: string; seconds: number }[];
  added_fields?: string[];
  warnings?: string[];
}

const knownFormat = 1;

export function parseScene(text: string): SceneInfo {
  const scene = JSON.parse(text) as SceneInfo;
  if (scene.format !== knownFormat) {
    throw new Error(`the data have format ${String(scene.format)}, this page reads ${knownFormat}`);
  }
  return scene;
}
