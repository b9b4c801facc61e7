// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// What the user has chosen. Everything that is shown follows from it.
import type { Mode, Range } from './colour/modes';
import type { Up } from './scene/up';

export type Layout = 'side' | 'wipe' | 'before' | 'after';
export type Axis = 'x' | 'y' | 'z' | 'view';

export interface Slab {
  on: boolean;
  axis: Axis;
  /** Of its middle, as a share of the way through the cloud. */
  position: number;
  /** In mean spacings. */
  thickness: number;
  /** Whether what lies behind the plane stays. */
  keepBehind: boolean;
}

export interface State {
  layout: Layout;
  mode: Mode;
  ranges: Partial<Record<Mode, Range>>;
  /** Diameter of a point in mean spacings. */
  pointSize: number;
  orthographic: boolean;
  /** The axis of the file that points up. */
  up: Up;
  hideOutliers: boolean;
  /** Where the wipe stands, as a share of the width. */
  wipe: number;
  slab: Slab;
  /** The point that the user has picked. */
  picked: { cloud: number; point: number } | undefined;
  dark: boolean;
}

export type Listener = (state: State, changed: Set<keyof State>) => void;

export class Store {
  private listeners: Listener[] = [];

  constructor(private state: State) {}

  get(): State {
    return this.state;
  }

  set(change: Partial<State>): void {
    const changed = new Set<keyof State>();
    for (const key of Object.keys(change) as (keyof State)[]) {
      if (this.state[key] !== change[key]) changed.add(key);
    }
    if (changed.size === 0) return;
    this.state = { ...this.state, ...change };
    for (const listener of this.listeners) listener(this.state, changed);
  }

  setSlab(change: Partial<Slab>): void {
    this.set({ slab: { ...this.state.slab, ...change } });
  }

  /** Calls the listener now, and after every change. */
  watch(listener: Listener): void {
    this.listeners.push(listener);
    listener(this.state, new Set(Object.keys(this.state) as (keyof State)[]));
  }
}
