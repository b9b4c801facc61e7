// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// The one camera of all panes, with or without perspective, and what moves it.
import { OrthographicCamera, PerspectiveCamera, Spherical, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { Vec3 } from '../data/cloud';
import type { Extent } from '../data/extent';
import { frameOf, fromFile, toFile, type Up } from './up';

const fieldOfView = 35; // degrees
const margin = 1.05;
const halfAngle = Math.tan(((fieldOfView / 2) * Math.PI) / 180);

/** Where the viewer stands: to the right, behind and above what is looked at. */
export const views = {
  iso: [1, -1.6, 1],
  front: [0, -1, 0],
  back: [0, 1, 0],
  left: [-1, 0, 0],
  right: [1, 0, 0],
  top: [0, 0, 1],
  bottom: [0, 0, -1],
} as const;
export type ViewName = keyof typeof views;

export class Rig {
  readonly perspective = new PerspectiveCamera(fieldOfView, 1, 0.01, 100);
  readonly orthographic = new OrthographicCamera(-1, 1, 1, -1, 0, 100);
  private controls: OrbitControls;
  private frame;
  private aspect = 1; // of the pane that was drawn last

  constructor(
    private readonly element: HTMLElement, private readonly extent: Extent, up: Up,
    private readonly moved: () => void, private readonly held: (held: boolean) => void,
  ) {
    this.frame = frameOf(up);
    this.controls = this.newControls(this.perspective);
    this.look('iso');
  }

  /** Controls have to know at birth what is up. */
  private newControls(camera: PerspectiveCamera | OrthographicCamera): OrbitControls {
    this.perspective.up.fromArray(this.frame.up);
    this.orthographic.up.fromArray(this.frame.up);
    const controls = new OrbitControls(camera, this.element);
    controls.addEventListener('change', this.moved);
    controls.addEventListener('start', () => this.held(true));
    controls.addEventListener('end', () => this.held(false));
    return controls;
  }

  /** Turns the whole: what was seen from the front is seen from the new front. */
  setUp(up: Up): void {
    const next = frameOf(up);
    if (next === this.frame) return;
    const target = this.target.clone();
    const from = this.camera.position.clone().sub(target).toArray() as Vec3;
    const camera = this.camera;
    const turned = toFile(fromFile(from, this.frame), next);
    this.frame = next;
    this.controls.dispose();
    this.held(false);
    this.element.style.cursor = ''; // that of the style sheet
    this.controls = this.newControls(camera);
    this.controls.target.copy(target);
    camera.position.copy(target).add(new Vector3(...turned));
    this.controls.update();
    this.moved();
  }

  get camera(): PerspectiveCamera | OrthographicCamera {
    return this.controls.object as PerspectiveCamera | OrthographicCamera;
  }

  get target(): Vector3 {
    return this.controls.target;
  }

  /** How far the viewer stands away; without perspective, where they would have to stand. */
  private get distance(): number {
    return this.camera === this.orthographic
      ? 1 / (this.orthographic.zoom * halfAngle)
      : this.camera.position.distanceTo(this.target);
  }

  /** Shows everything from one side. */
  look(name: ViewName): void {
    this.controls.target.fromArray(this.extent.centre);
    this.place(new Vector3(...toFile([...views[name]], this.frame)).normalize());
  }

  /** Shows everything from where the viewer is. */
  fit(): void {
    const direction = this.camera.position.clone().sub(this.target).normalize();
    this.controls.target.fromArray(this.extent.centre);
    this.place(direction);
  }

  private place(direction: Vector3): void {
    // Straight from above nothing tells where the top of the picture is.
    const { up, forward } = this.frame;
    if (Math.abs(direction.dot(new Vector3(...up))) > 0.999) {
      direction.addScaledVector(new Vector3(...forward), -1e-3).normalize();
    }
    const { half, distance } = this.needed(direction);
    this.orthographic.zoom = 1 / half;
    this.camera.position.copy(this.target).addScaledVector(direction, distance);
    this.controls.update();
  }

  /** Half the height without perspective, and the distance with it, that show the whole box. */
  private needed(direction: Vector3): { half: number; distance: number } {
    const right = new Vector3().crossVectors(this.perspective.up, direction).normalize();
    const up = new Vector3().crossVectors(direction, right);
    const { low, high, centre, radius } = this.extent;
    let half = 0;
    let distance = 0;
    for (let corner = 0; corner < 8; ++corner) {
      const at = new Vector3().fromArray([0, 1, 2].map((k) =>
        ((corner >> k) & 1 ? high[k]! : low[k]!) - centre[k]!));
      // A tall pane shows the whole width, a wide one the whole height; see aim().
      const wide = Math.abs(at.dot(right)) / Math.max(this.aspect, 1);
      const tall = Math.abs(at.dot(up)) / Math.max(1, 1 / this.aspect);
      const reach = margin * Math.max(wide, tall);
      half = Math.max(half, reach);
      distance = Math.max(distance, at.dot(direction) + reach / halfAngle);
    }
    // A single point, or a line from its end, is shown with what a cloud of its size would need.
    return half > 1e-6 * radius ? { half, distance } : { half: radius, distance: radius / halfAngle };
  }

  setOrthographic(on: boolean): void {
    const wanted = on ? this.orthographic : this.perspective;
    const now = this.camera;
    if (wanted === now) return;
    const distance = this.distance;
    const direction = now.position.clone().sub(this.target).normalize();
    this.orthographic.zoom = 1 / (distance * halfAngle);
    wanted.position.copy(this.target).addScaledVector(direction, distance);
    this.controls.object = wanted;
    this.controls.update();
  }

  /** Turns around the target, angles in radians. */
  orbit(right: number, up: number): void {
    // Spherical has y up.
    const [x, away, height] =
      fromFile(this.camera.position.clone().sub(this.target).toArray() as Vec3, this.frame);
    const around = new Spherical().setFromVector3(new Vector3(x, height, -away));
    around.theta += right;
    around.phi = Math.min(Math.max(around.phi - up, 1e-3), Math.PI - 1e-3);
    const offset = new Vector3().setFromSpherical(around);
    this.camera.position.copy(this.target)
      .add(new Vector3(...toFile([offset.x, -offset.z, offset.y], this.frame)));
    this.controls.update();
  }

  /** Moves sideways, in shares of the height of the view. */
  pan(right: number, up: number): void {
    const height = 2 * this.distance * halfAngle;
    this.camera.updateMatrix();
    const axis = (column: number, by: number) =>
      new Vector3().setFromMatrixColumn(this.camera.matrix, column).multiplyScalar(by * height);
    const shift = axis(0, right).add(axis(1, up));
    this.camera.position.add(shift);
    this.controls.target.add(shift);
    this.controls.update();
  }

  /** Comes nearer by a factor. */
  zoom(factor: number): void {
    if (this.camera === this.orthographic) {
      this.orthographic.zoom *= factor;
    } else {
      const offset = this.camera.position.clone().sub(this.target).divideScalar(factor);
      this.camera.position.copy(this.target).add(offset);
    }
    this.controls.update();
    this.controls.dispatchEvent({ type: 'change' });
  }

  /** Makes the camera ready for a pane of this shape. */
  aim(aspect: number): void {
    this.aspect = aspect;
    const distance = this.camera.position.distanceTo(this.target);
    const centre = new Vector3().fromArray(this.extent.centre);
    const depth = this.extent.radius * 6 + this.camera.position.distanceTo(centre);
    if (this.camera === this.orthographic) {
      // A tall pane shows the whole width, a wide one the whole height.
      const x = Math.max(aspect, 1);
      const y = Math.max(1, 1 / aspect);
      Object.assign(this.orthographic, { left: -x, right: x, top: y, bottom: -y, near: -depth, far: depth });
    } else {
      this.perspective.aspect = aspect;
      this.perspective.fov =
        (360 / Math.PI) * Math.atan(halfAngle * Math.max(1, 1 / aspect));
      this.perspective.near = Math.max(distance * 1e-3, depth * 1e-5);
      this.perspective.far = depth;
    }
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
  }
}
