// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// Draws the clouds in their panes, when something has changed.
import { Color, ColorManagement, Matrix4, Scene, Vector3, WebGLRenderer } from 'three';
import { isOutlier, type Cloud, type Vec3 } from '../data/cloud';
import { meanSpacing, robustExtent, type Extent } from '../data/extent';
import type { Frame, Plane } from '../section/slab';
import type { Store } from '../state';
import { FrameBudget } from './budget';
import { CloudPoints, newLook } from './cloud_points';
import { paneAt, panesOf, type Pane } from './panes';
import { pickPoint } from './pick';
import { Rig } from './rig';

const settleAfter = 220; // milliseconds without motion until everything is drawn again
const pickRadius = 7; // pixels
const mostPixels = 2; // per pixel of the page

export interface Drawn {
  panes: Pane[];
  points: number;
  moving: boolean;
}

export class Stage {
  readonly canvas = document.createElement('canvas');
  readonly extent: Extent;
  /** Of the points that are shown. */
  readonly spacing: number;
  readonly rig: Rig;
  private readonly renderer: WebGLRenderer;
  private readonly points: CloudPoints[];
  private readonly scenes: Scene[];
  private readonly look = newLook();
  private readonly budget: FrameBudget;
  private panes: Pane[] = [];
  private queued = false;
  private first = true;
  private lastMoved = -Infinity;
  private coarse = false; // whether the last picture lacks points
  private held = false; // by a pointer: to draw everything then would stop it on a slow machine
  private settle = 0;
  private background = new Color(0xffffff);

  /** Called after every picture. */
  onDrawn: (drawn: Drawn) => void = () => undefined;

  constructor(
    private readonly host: HTMLElement,
    private readonly clouds: Cloud[],
    private readonly store: Store,
  ) {
    ColorManagement.enabled = false;
    this.renderer = new WebGLRenderer({ canvas: this.canvas, antialias: false });
    this.renderer.autoClear = false;
    const shown = clouds[clouds.length - 1]!;
    this.extent = robustExtent(shown.local);
    this.spacing = meanSpacing(shown.local, this.extent);
    this.points = clouds.map((cloud) => new CloudPoints(cloud, this.look));
    this.scenes = this.points.map(({ object }) => {
      const scene = new Scene();
      scene.add(object);
      return scene;
    });
    this.budget = new FrameBudget(clouds.reduce((sum, cloud) => sum + cloud.count, 0));
    host.prepend(this.canvas);
    this.rig = new Rig(this.canvas, this.extent, store.get().up, () => this.moved(), (held) => {
      this.held = held;
      if (!held && this.coarse) this.moved();
    });
    store.watch((state, changed) => {
      if (changed.has('up')) this.rig.setUp(state.up);
    });
    new ResizeObserver(() => this.request()).observe(host);
  }

  setTints(cloud: number, tints: Uint8Array): void {
    this.points[cloud]!.setTints(tints);
    this.request();
  }

  setBackground(colour: string): void {
    this.background = new Color(colour);
    this.request();
  }

  /** @param light  how much of the brightness depends on the normal */
  setLight(light: number): void {
    this.look.light.value = light;
    this.request();
  }

  setPlane(plane: Plane | undefined, keepBehind: boolean): void {
    this.look.sliced.value = plane !== undefined;
    if (plane) {
      // What the viewer looks at is the side that faces them.
      const towards = this.rig.camera.position.clone().sub(this.rig.target);
      const side = towards.dot(new Vector3().fromArray(plane.normal)) < 0 ? -1 : 1;
      const [x, y, z] = plane.normal;
      this.look.plane.value.set(side * x, side * y, side * z, side * plane.offset);
      this.look.reach.value.set(plane.half, keepBehind ? 1e30 : plane.half);
    }
    this.request();
  }

  /** Draws soon. */
  request(): void {
    if (this.queued) return;
    this.queued = true;
    requestAnimationFrame(() => this.draw());
  }

  private moved(): void {
    this.lastMoved = performance.now();
    window.clearTimeout(this.settle);
    this.settle = window.setTimeout(() => this.request(), settleAfter);
    this.request();
  }

  /** Draws now; also for paper, where nobody waits. */
  draw(): void {
    this.queued = false;
    const state = this.store.get();
    const { clientWidth: width, clientHeight: height } = this.host;
    if (width === 0 || height === 0) return;
    const began = performance.now();
    const moving = this.held || began - this.lastMoved < settleAfter;
    const share = moving ? this.budget.moving : 1;
    this.coarse = moving;
    this.resize(width, height);
    this.look.hideOutliers.value = state.hideOutliers;
    // Fewer points have to be larger to close the surface.
    this.look.diameter.value = (state.pointSize * this.spacing) / Math.sqrt(share);
    this.panes = panesOf(state.layout, this.clouds.length, width, height, state.wipe);
    if (this.first) {
      const { view } = this.panes[0]!;
      this.first = false;
      this.rig.aim(view.width / view.height);
      this.rig.look('iso');
    }
    this.renderer.setScissorTest(false);
    this.renderer.setClearColor(this.background);
    this.renderer.clear();
    let drawn = 0;
    for (const pane of this.panes) drawn += this.drawPane(pane, height, share);
    if (moving) {
      this.wait();
      this.budget.took(performance.now() - began, share);
    }
    this.report(drawn, moving, performance.now() - began);
    this.onDrawn({ panes: this.panes, points: drawn, moving });
  }

  private drawPane({ cloud, view, clip }: Pane, height: number, share: number): number {
    if (clip.width <= 0) return 0;
    this.rig.aim(view.width / view.height);
    const ratio = this.renderer.getPixelRatio();
    this.look.pixelsPerUnit.value =
      (this.rig.camera.projectionMatrix.elements[5]! * view.height * ratio) / 2;
    this.renderer.setViewport(view.x, height - view.y - view.height, view.width, view.height);
    this.renderer.setScissor(clip.x, height - clip.y - clip.height, clip.width, clip.height);
    this.renderer.setScissorTest(true);
    const drawn = this.points[cloud]!.draw(share);
    this.renderer.render(this.scenes[cloud]!, this.rig.camera);
    return drawn;
  }

  private resize(width: number, height: number): void {
    const ratio = Math.min(window.devicePixelRatio, mostPixels);
    if (this.renderer.getPixelRatio() !== ratio) this.renderer.setPixelRatio(ratio);
    const { width: w, height: h } = this.canvas;
    if (w !== Math.floor(width * ratio) || h !== Math.floor(height * ratio)) {
      this.renderer.setSize(width, height, false);
    }
  }

  /** Until the picture is there: reading a pixel of it needs all of it. */
  private wait(): void {
    const gl = this.renderer.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  }

  /** For those who measure: tests, and people who look at the page's elements. */
  private report(drawn: number, moving: boolean, milliseconds: number): void {
    const { dataset } = this.canvas;
    dataset.drawn = String(drawn);
    dataset.moving = String(moving);
    if (moving) dataset.frameMs = milliseconds.toFixed(1);
    dataset.frames = String(Number(dataset.frames ?? 0) + 1);
  }

  /** Directions of the viewer. */
  facing(): Frame {
    const camera = this.rig.camera;
    camera.updateMatrixWorld();
    const column = (k: number) => new Vector3().setFromMatrixColumn(camera.matrixWorld, k);
    return {
      right: column(0).toArray() as Vec3, up: column(1).toArray() as Vec3,
      normal: column(2).toArray() as Vec3,
    };
  }

  private projection(pane: Pane): Matrix4 {
    this.rig.aim(pane.view.width / pane.view.height);
    const { projectionMatrix, matrixWorldInverse } = this.rig.camera;
    return projectionMatrix.clone().multiply(matrixWorldInverse);
  }

  /** Whether a point is drawn at all, with what is hidden now. */
  visible(cloud: number, point: number): boolean {
    const data = this.clouds[cloud]!;
    if (this.look.hideOutliers.value && isOutlier(data, point)) return false;
    if (!this.look.sliced.value) return true;
    const { x, y, z, w } = this.look.plane.value;
    const at = 3 * point;
    const across = x * data.local[at]! + y * data.local[at + 1]! + z * data.local[at + 2]! - w;
    return across <= this.look.reach.value.x && across >= -this.look.reach.value.y;
  }

  /** The point at a place of the canvas, in pixels of the page. */
  pick(x: number, y: number): { cloud: number; point: number } | undefined {
    const pane = paneAt(this.panes, x, y);
    if (!pane) return undefined;
    const { cloud, view } = pane;
    const { local, count } = this.clouds[cloud]!;
    const point = pickPoint(local, count,
      { matrix: this.projection(pane).elements, width: view.width, height: view.height },
      x - view.x, y - view.y, pickRadius, (i) => this.visible(cloud, i));
    return point < 0 ? undefined : { cloud, point };
  }

  /** Where a point of a pane's cloud is on the canvas; none where it is outside of the pane. */
  place(pane: Pane, point: number): { x: number; y: number } | undefined {
    const { local, count } = this.clouds[pane.cloud]!;
    if (point >= count) return undefined;
    const at = new Vector3().fromArray(local, 3 * point).applyMatrix4(this.projection(pane));
    const { view, clip } = pane;
    const x = view.x + (at.x * 0.5 + 0.5) * view.width;
    const y = view.y + (0.5 - at.y * 0.5) * view.height;
    const inside = at.z < 1 && x >= clip.x && x <= clip.x + clip.width && y >= 0 && y <= view.height;
    return inside ? { x, y } : undefined;
  }
}
