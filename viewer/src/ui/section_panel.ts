// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// The cross-section: where it lies, and its picture, which can be moved and enlarged on its own.
import type { Cloud, Vec3 } from '../data/cloud';
import type { Stage } from '../scene/stage';
import { outline } from '../section/outline';
import { describeSection, drawSection, fitWindow, pictureAxis, type SectionPicture, type Window2 } from '../section/plot';
import { dot, planeOf, project, type Frame, type Plane } from '../section/slab';
import type { Up } from '../scene/up';
import type { Axis, Slab, State, Store } from '../state';
import { el } from './dom';
import { button, checkbox, select, slider } from './fields';
import { coordinate } from './format';

const outlineCell = 1.4; // spacings
const wheelStep = 1.0015;

export class SectionPanel {
  readonly element: HTMLElement;
  private readonly canvas = el('canvas', { tabindex: 0, role: 'img' });
  private readonly told = el('p', { class: 'note' });
  private picture: SectionPicture | undefined;
  private plane: Plane | undefined;
  private facing: Frame | undefined;
  private seen: Window2 | undefined;

  constructor(
    private readonly store: Store, private readonly stage: Stage, private readonly clouds: Cloud[],
    private readonly origin: Vec3, private readonly spacing: number,
  ) {
    const slab = store.get().slab;
    const axis = select('Across', [['x', 'x'], ['y', 'y'], ['z', 'z'], ['view', 'the view']],
      slab.axis, (value) => store.setSlab({ axis: value as Axis }));
    const position = slider('Position', 0, 1, 0.001, slab.position,
      (value) => store.setSlab({ position: value }));
    const thickness = slider('Thickness', 0.5, 12, 0.25, slab.thickness,
      (value) => store.setSlab({ thickness: value }));
    const behind = checkbox('Keep what lies behind', slab.keepBehind,
      (value) => store.setSlab({ keepBehind: value }));
    const fit = button('Fit', () => this.fit(), 'Show the whole section');
    this.element = el('section', { class: 'section', 'aria-label': 'Cross-section' },
      el('div', { class: 'toolbar' }, axis.element, position.element, thickness.element,
        behind.element, fit),
      el('div', { class: 'plot' }, this.canvas), this.told);
    this.listen();
    store.watch((state, changed) => {
      axis.field.value = state.slab.axis;
      position.field.valueAsNumber = state.slab.position;
      thickness.field.valueAsNumber = state.slab.thickness;
      behind.field.checked = state.slab.keepBehind;
      this.element.hidden = !state.slab.on;
      if (['slab', 'hideOutliers', 'layout', 'up'].some((key) => changed.has(key as keyof State))) {
        this.update(state.slab, state.up);
      }
      if (changed.has('dark')) this.draw();
    });
    new ResizeObserver(() => this.draw()).observe(this.canvas.parentElement!);
  }

  private update(slab: Slab, up: Up): void {
    if (!slab.on) {
      this.plane = undefined;
      this.facing = undefined;
      this.stage.setPlane(undefined, false);
      return;
    }
    // A slab that faces the viewer stays where it was put when they turn.
    if (slab.axis !== 'view') this.facing = undefined;
    else this.facing ??= this.stage.facing();
    const frame = this.facing ?? this.stage.facing();
    const before = this.plane;
    this.plane = planeOf(slab, this.stage.extent, this.spacing, frame, up);
    this.stage.setPlane(this.plane, slab.keepBehind);
    const directions = (plane?: Plane) => plane && [plane.right, plane.up].join();
    if (directions(before) !== directions(this.plane)) this.seen = undefined;
    this.project(slab);
    this.draw();
  }

  private project(slab: Slab): void {
    const plane = this.plane!;
    const hide = this.store.get().hideOutliers;
    const sets = this.clouds.map((cloud) =>
      project(cloud.local, plane, (i) => !hide || ((cloud.flags?.[i] ?? 0) & 8) === 0));
    const last = sets[sets.length - 1];
    const file = slab.axis !== 'view';
    this.picture = {
      before: sets.length > 1 ? sets[0] : undefined,
      after: last,
      lines: last ? outline(last.places, outlineCell * this.spacing) : new Float32Array(),
      axes: file
        ? [pictureAxis(plane.right, this.origin), pictureAxis(plane.up, this.origin)] : undefined,
      names: this.clouds.length > 1 ? ['before', 'after'] : ['', ''],
    };
    const thickness = slab.thickness * this.spacing;
    const described = describeSection(this.picture, thickness);
    this.canvas.setAttribute('aria-label', described);
    const at = file ? `${slab.axis} = ${coordinate(plane.offset + dot(this.origin, plane.normal), thickness / 1000)}` : 'facing the view';
    this.told.replaceChildren(`${described}; ${at}. `,
      el('span', { class: 'on-screen' }, 'Wheel and drag enlarge and move it.'));
  }

  private fit(): void {
    this.seen = undefined;
    this.draw();
  }

  private sets(): Float32Array[] {
    return [this.picture?.before, this.picture?.after].flatMap((set) => (set ? [set.places] : []));
  }

  private draw(): void {
    const host = this.canvas.parentElement!;
    const { clientWidth: width, clientHeight: height } = host;
    const paper = this.canvas.getContext('2d');
    if (!this.picture || !paper || width === 0 || height === 0) return;
    const ratio = window.devicePixelRatio;
    this.canvas.width = width * ratio;
    this.canvas.height = height * ratio;
    paper.setTransform(ratio, 0, 0, ratio, 0, 0);
    // The view is kept while the slab moves, so that the eye can follow.
    this.seen ??= fitWindow(this.sets(), width, height);
    const style = getComputedStyle(document.documentElement);
    const colour = (name: string) => style.getPropertyValue(name).trim();
    drawSection(paper, width, height, this.seen, this.picture, {
      before: colour('--before'), after: colour('--after'), text: colour('--muted'),
      grid: colour('--line'),
    });
  }

  private listen(): void {
    const enlarge = (factor: number, x: number, y: number) => {
      if (!this.seen) return;
      const { clientWidth, clientHeight } = this.canvas.parentElement!;
      const dx = (x - clientWidth / 2) / this.seen.scale;
      const dy = (clientHeight / 2 - y) / this.seen.scale;
      this.seen = {
        x: this.seen.x + dx * (1 - 1 / factor), y: this.seen.y + dy * (1 - 1 / factor),
        scale: this.seen.scale * factor,
      };
      this.draw();
    };
    const shift = (dx: number, dy: number) => {
      if (!this.seen) return;
      this.seen = {
        ...this.seen, x: this.seen.x - dx / this.seen.scale, y: this.seen.y + dy / this.seen.scale,
      };
      this.draw();
    };
    this.canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      enlarge(wheelStep ** -event.deltaY, event.offsetX, event.offsetY);
    }, { passive: false });
    this.canvas.addEventListener('pointerdown', (event) => this.canvas.setPointerCapture(event.pointerId));
    this.canvas.addEventListener('pointermove', (event) => {
      if (event.buttons !== 0) shift(event.movementX, event.movementY);
    });
    this.canvas.addEventListener('dblclick', () => this.fit());
    this.canvas.addEventListener('keydown', (event) => {
      const { clientWidth, clientHeight } = this.canvas.parentElement!;
      const moves: Record<string, () => void> = {
        ArrowLeft: () => shift(30, 0), ArrowRight: () => shift(-30, 0),
        ArrowUp: () => shift(0, 30), ArrowDown: () => shift(0, -30),
        '+': () => enlarge(1.25, clientWidth / 2, clientHeight / 2),
        '-': () => enlarge(0.8, clientWidth / 2, clientHeight / 2),
        f: () => this.fit(),
      };
      if (!moves[event.key]) return;
      event.preventDefault();
      moves[event.key]!();
    });
  }
}
