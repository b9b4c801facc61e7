// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
import {
  BufferAttribute, BufferGeometry, NormalBlending, Points, ShaderMaterial, Sphere, Vector2, Vector3,
  Vector4,
} from 'three';
import type { Cloud } from '../data/cloud';
import { fragmentShader, vertexShader } from './shader';

/** What all clouds are drawn with. */
export interface Look {
  diameter: { value: number };
  pixelsPerUnit: { value: number };
  smallest: { value: number };
  largest: { value: number };
  light: { value: number };
  hideOutliers: { value: boolean };
  sliced: { value: boolean };
  plane: { value: Vector4 };
  reach: { value: Vector2 };
}

export function newLook(): Look {
  return {
    diameter: { value: 1 },
    pixelsPerUnit: { value: 1 },
    smallest: { value: 1.5 },
    largest: { value: 48 },
    light: { value: 0.7 },
    hideOutliers: { value: false },
    sliced: { value: false },
    plane: { value: new Vector4(0, 0, 1, 0) },
    reach: { value: new Vector2(0, 0) },
  };
}

/** A cloud as an object of three.js, of which any first part can be drawn. */
export class CloudPoints {
  readonly object: Points<BufferGeometry, ShaderMaterial>;
  private readonly tints: BufferAttribute;

  constructor(private readonly cloud: Cloud, look: Look) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(cloud.local, 3));
    geometry.setAttribute('normal', new BufferAttribute(cloud.normals, 3, true));
    this.tints = new BufferAttribute(new Uint8Array(4 * cloud.count), 4, true);
    geometry.setAttribute('tint', this.tints);
    // Never culled, so that no sphere has to be found around a million points.
    geometry.boundingSphere = new Sphere(new Vector3(), Infinity);
    const material = new ShaderMaterial({
      uniforms: { ...look }, vertexShader, fragmentShader, blending: NormalBlending,
    });
    this.object = new Points(geometry, material);
    this.object.frustumCulled = false;
    this.object.matrixAutoUpdate = false;
  }

  setTints(bytes: Uint8Array): void {
    this.tints.array.set(bytes);
    this.tints.needsUpdate = true;
  }

  /** Draws this share of the points, spread evenly. */
  draw(share: number): number {
    const count = Math.ceil(share * this.cloud.count);
    this.object.geometry.setDrawRange(0, count);
    return count;
  }
}
