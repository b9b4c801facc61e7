// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// The page: header, picture, controls and report, tied together by the state.
import { availableModes, firstRange, mapOf, paint, valuesOf, type Range } from './colour/modes';
import { hasOutliers, sceneOrigin, type Cloud } from './data/cloud';
import type { DenoiseReport, SceneInfo } from './data/scene';
import { Stage, type Drawn } from './scene/stage';
import { upNamed } from './scene/up';
import { Store } from './state';
import { el } from './ui/dom';
import { helpDialog, press } from './ui/keys';
import { legend } from './ui/legend';
import { pickedPanel } from './ui/picked';
import { reportPanel } from './ui/report';
import { SectionPanel } from './ui/section_panel';
import { pageButtons, toolbar } from './ui/toolbar';
import { shownText, titleOf } from './ui/words';

const clickTravel = 4; // pixels that a click may move
const shapeLight = 0.75; // how much brightness tells the shape where it is all there is to see
const colourLight = 0.3; // and where colours mean something

export class App {
  private readonly store: Store;
  private readonly stage: Stage;
  private readonly overlay = el('div', { class: 'overlay', 'aria-hidden': 'true' });
  private readonly divider = el('div', {
    class: 'divider', role: 'slider', tabindex: 0, 'aria-label': 'Wipe between before and after',
    'aria-valuemin': 0, 'aria-valuemax': 100,
  });
  private readonly live = el('p', { class: 'hidden', role: 'status' });
  private readonly host = el('div', { class: 'stage' });

  constructor(
    root: HTMLElement, private readonly scene: SceneInfo, private readonly clouds: Cloud[],
    report: DenoiseReport | undefined, version: string,
  ) {
    const modes = availableModes(clouds);
    const dark = window.matchMedia('(prefers-color-scheme: dark)').matches;
    this.store = new Store({
      layout: 'side', mode: 'normals', ranges: {}, pointSize: 2.4, orthographic: false,
      up: upNamed(scene.up), hideOutliers: false, wipe: 0.5, picked: undefined, dark,
      slab: { on: false, axis: 'y', position: 0.5, thickness: 3, keepBehind: true },
    });
    this.stage = new Stage(this.host, clouds, this.store);
    // Before all who draw with the colours of the page.
    this.store.watch((state, changed) => {
      if (changed.has('dark')) this.applyTheme(state.dark);
    });
    const help = helpDialog();
    const actions = {
      fit: () => this.stage.rig.fit(),
      look: this.stage.rig.look.bind(this.stage.rig),
      help: () => help.showModal(),
      print: () => window.print(),
      pickMiddle: () => this.pickMiddle(),
    };
    const canvas = this.stage.canvas;
    canvas.tabIndex = 0;
    canvas.setAttribute('role', 'img');
    canvas.setAttribute('aria-label', `Points of ${titleOf(scene)}. Press ? for the keys.`);
    this.host.append(this.overlay, this.divider, el('p', { class: 'count' }, shownText(scene)));
    const section = new SectionPanel(
      this.store, this.stage, clouds, sceneOrigin(scene), this.stage.spacing);
    const legendHost = el('div');
    const pickedHost = el('div', { 'aria-live': 'polite' });
    root.append(
      el('header', {}, el('h1', {}, titleOf(scene)), el('p', {}, `deburr ${version}`),
        pageButtons(this.store, actions)),
      toolbar(this.store, modes, clouds.length, clouds.some(hasOutliers), actions),
      el('main', {},
        el('div', { class: 'view' }, this.host, section.element),
        el('aside', {},
          el('section', { class: 'colours', 'aria-labelledby': 'colour-title' },
            el('h2', { id: 'colour-title' }, 'Colour'), legendHost),
          el('section', { class: 'picked', 'aria-labelledby': 'picked-title' },
            el('h2', { id: 'picked-title' }, 'Point'), pickedHost),
          reportPanel(scene, report, version))),
      this.live, help);
    this.listen(modes, actions);
    this.store.watch((state, changed) => {
      if (changed.has('orthographic')) this.stage.rig.setOrthographic(state.orthographic);
      if (changed.has('mode') || changed.has('ranges')) {
        legendHost.replaceChildren(legend(state.mode, scene, this.range(), (r) => this.setRange(r)));
        this.colour();
      }
      if (changed.has('picked')) pickedHost.replaceChildren(pickedPanel(scene, clouds, state.picked));
      this.stage.request();
    });
    this.stage.onDrawn = (drawn) => this.drawn(drawn);
  }

  private range(): Range | undefined {
    const { mode, ranges } = this.store.get();
    return ranges[mode] ?? firstRange(mode, this.scene, this.clouds);
  }

  private setRange(range: Range | undefined): void {
    const { mode, ranges } = this.store.get();
    const next = { ...ranges };
    if (range) next[mode] = range;
    else delete next[mode];
    this.store.set({ ranges: next });
  }

  private colour(): void {
    const { mode } = this.store.get();
    const map = mapOf(mode, this.scene);
    this.clouds.forEach((cloud, k) => this.stage.setTints(k, paint(cloud, mode, map, this.range())));
    const shaded = mode === 'normals' || !this.clouds.some((c) => valuesOf(c, mode) ?? c.flags ?? c.colours);
    this.stage.setLight(shaded ? shapeLight : colourLight);
  }

  private applyTheme(dark: boolean): void {
    document.documentElement.dataset.theme = dark ? 'dark' : 'light';
    const style = getComputedStyle(document.documentElement);
    this.stage.setBackground(style.getPropertyValue('--stage').trim());
  }

  private pickMiddle(): void {
    const pane = this.host.getBoundingClientRect();
    const pair = this.clouds.length > 1 && this.store.get().layout === 'side';
    const picked = this.stage.pick(pane.width * (pair ? 0.75 : 0.5), pane.height / 2);
    this.store.set({ picked });
    this.live.textContent = picked ? '' : 'No point in the middle of the view';
  }

  private listen(modes: ReturnType<typeof availableModes>, actions: { pickMiddle: () => void; help: () => void }): void {
    const canvas = this.stage.canvas;
    let down: PointerEvent | undefined;
    canvas.addEventListener('pointerdown', (event) => {
      canvas.focus();
      down = event;
    });
    canvas.addEventListener('pointerup', (event) => {
      const still = down && Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) < clickTravel;
      if (still && event.button === 0) {
        this.store.set({ picked: this.stage.pick(event.offsetX, event.offsetY) });
      }
      down = undefined;
    });
    canvas.addEventListener('keydown', (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      if (press(event.key, event.shiftKey, this.store, this.stage.rig, modes,
        this.clouds.length > 1, actions)) event.preventDefault();
    });
    const wipeTo = (x: number) =>
      this.store.set({ wipe: Math.min(Math.max(x / this.host.clientWidth, 0), 1) });
    this.divider.addEventListener('pointerdown', (event) => this.divider.setPointerCapture(event.pointerId));
    this.divider.addEventListener('pointermove', (event) => {
      if (event.buttons !== 0) wipeTo(event.clientX - this.host.getBoundingClientRect().left);
    });
    this.divider.addEventListener('keydown', (event) => {
      const by = { ArrowLeft: -0.02, ArrowRight: 0.02 }[event.key];
      if (by === undefined) return;
      event.preventDefault();
      wipeTo((this.store.get().wipe + by) * this.host.clientWidth);
    });
    let dark: boolean | undefined; // before the print
    window.addEventListener('beforeprint', () => {
      dark ??= this.store.get().dark;
      this.store.set({ dark: false }); // also for the colours of the cross-section
      this.stillForPaper();
    });
    window.addEventListener('afterprint', () => {
      this.host.querySelector('img')?.remove();
      if (dark !== undefined) this.store.set({ dark });
      dark = undefined;
    });
  }

  /** Browsers print a picture, but not always what WebGL has drawn. */
  private stillForPaper(): void {
    this.stage.setBackground('#fff');
    this.stage.draw();
    this.host.querySelector('img')?.remove();
    this.host.append(el('img', { alt: '', class: 'paper', src: this.stage.canvas.toDataURL() }));
    this.applyTheme(false);
  }

  private drawn({ panes }: Drawn): void {
    const state = this.store.get();
    const wipes = state.layout === 'wipe' && panes.length > 1;
    this.divider.hidden = !wipes;
    this.divider.style.left = `${100 * state.wipe}%`;
    this.divider.setAttribute('aria-valuenow', String(Math.round(100 * state.wipe)));
    const marks: Node[] = [];
    // In shares of the picture, which has another size on paper.
    const { clientWidth, clientHeight } = this.host;
    for (const pane of panes) {
      const { clip } = pane;
      if (this.clouds.length > 1) {
        const name = el('span', { class: 'name' }, pane.cloud === 0 ? 'before' : 'after');
        name.style.left = `${(100 * clip.x) / clientWidth}%`;
        name.hidden = clip.width < 60;
        marks.push(name);
      }
      const { picked } = state;
      const here = picked && (this.scene.paired || picked.cloud === pane.cloud);
      const place = here ? this.stage.place(pane, picked.point) : undefined;
      if (!place) continue;
      const ring = el('span', { class: 'ring' });
      ring.style.left = `${(100 * place.x) / clientWidth}%`;
      ring.style.top = `${(100 * place.y) / clientHeight}%`;
      marks.push(ring);
    }
    this.overlay.replaceChildren(...marks);
  }
}
