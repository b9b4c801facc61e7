// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
// The picture of a slab from its side: the noisy points as a cloud of dots, the clean ones as an
// outline, over a grid in file units.
import type { Vec3 } from '../data/cloud';
import { short } from '../ui/format';
import type { Segments } from './outline';
import type { Projected } from './slab';

/** An axis of the file in the picture: its coordinates are sign * place + origin. */
export interface PictureAxis {
  name: string;
  sign: number;
  origin: number;
}

/** The axis along a direction that is one, with the file coordinates of the middle of the scene. */
export function pictureAxis(direction: Vec3, origin: Vec3): PictureAxis {
  const k = direction.findIndex((v) => v !== 0);
  return { name: 'xyz'[k]!, sign: Math.sign(direction[k]!), origin: origin[k]! };
}

export interface SectionPicture {
  before?: Projected | undefined;
  after?: Projected | undefined;
  /** Of the clean points, or of the only ones. */
  lines: Segments;
  /** To the right and upwards, one axis of the file each; none where the picture faces the view. */
  axes?: [PictureAxis, PictureAxis] | undefined;
  names: [string, string];
}

export interface Colours {
  before: string;
  after: string;
  text: string;
  grid: string;
}

/** A round number not below a value: 1, 2 or 5 times a power of ten. */
export function roundUp(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  const lead = value / power;
  return power * (lead <= 1 ? 1 : lead <= 2 ? 2 : lead <= 5 ? 5 : 10);
}

/** What part of the plane is seen: its middle, and pixels per unit. */
export interface Window2 {
  x: number;
  y: number;
  scale: number;
}

/** Shows all places. */
export function fitWindow(sets: Float32Array[], width: number, height: number): Window2 {
  let [x0, x1, y0, y1] = [Infinity, -Infinity, Infinity, -Infinity];
  for (const places of sets) {
    for (let i = 0; i < places.length; i += 2) {
      x0 = Math.min(x0, places[i]!);
      x1 = Math.max(x1, places[i]!);
      y0 = Math.min(y0, places[i + 1]!);
      y1 = Math.max(y1, places[i + 1]!);
    }
  }
  if (!(x1 >= x0)) return { x: 0, y: 0, scale: 1 };
  const scale = 0.88 * Math.min(width / (x1 - x0 || 1e-9), height / (y1 - y0 || 1e-9));
  return { x: (x0 + x1) / 2, y: (y0 + y1) / 2, scale };
}

function drawGrid(
  paper: CanvasRenderingContext2D, width: number, height: number, seen: Window2,
  picture: SectionPicture, colours: Colours,
): void {
  const step = roundUp(70 / seen.scale);
  paper.strokeStyle = colours.grid;
  paper.fillStyle = colours.text;
  paper.font = '11px system-ui, sans-serif';
  paper.lineWidth = 1;
  const decimals = Math.max(0, -Math.floor(Math.log10(step)));
  const lines = (middle: number, span: number, axis: PictureAxis | undefined, each: (at: number, text: string) => void) => {
    const { sign, origin } = axis ?? { sign: 1, origin: 0 };
    const half = span / seen.scale / 2;
    const low = sign * middle + origin - half; // of the coordinates that are seen
    for (let k = Math.ceil(low / step); k * step <= low + 2 * half; ++k) {
      const along = (k * step - low) * seen.scale;
      each(sign > 0 ? along : span - along, (k * step).toFixed(decimals));
    }
  };
  lines(seen.x, width, picture.axes?.[0], (at, text) => {
    paper.beginPath();
    paper.moveTo(Math.round(at) + 0.5, 0);
    paper.lineTo(Math.round(at) + 0.5, height);
    paper.stroke();
    if (at > 50) paper.fillText(text, at + 3, height - 4); // not over those of the other axis
  });
  lines(seen.y, height, picture.axes?.[1], (at, text) => {
    const y = Math.round(height - at) + 0.5;
    paper.beginPath();
    paper.moveTo(0, y);
    paper.lineTo(width, y);
    paper.stroke();
    if (y > 30) paper.fillText(text, 3, y - 3); // not over the name of the axis
  });
  if (!picture.axes) return;
  paper.font = 'bold 12px system-ui, sans-serif';
  paper.textAlign = 'right';
  paper.fillText(axisName(picture.axes[0], '→', '←'), width - 5, height - 18);
  paper.textAlign = 'left';
  paper.fillText(axisName(picture.axes[1], '↑', '↓'), 3, 13);
}

/** An arrow to where its coordinates grow. */
function axisName({ name, sign }: PictureAxis, along: string, against: string): string {
  return `${name} ${sign > 0 ? along : against}`;
}

export function drawSection(
  paper: CanvasRenderingContext2D, width: number, height: number, seen: Window2,
  picture: SectionPicture, colours: Colours,
): void {
  paper.clearRect(0, 0, width, height);
  drawGrid(paper, width, height, seen, picture, colours);
  const px = (x: number) => width / 2 + (x - seen.x) * seen.scale;
  const py = (y: number) => height / 2 - (y - seen.y) * seen.scale;
  const dots = (places: Float32Array | undefined, colour: string, size: number, alpha: number) => {
    if (!places) return;
    paper.fillStyle = colour;
    paper.globalAlpha = alpha;
    for (let i = 0; i < places.length; i += 2) {
      paper.fillRect(px(places[i]!) - size / 2, py(places[i + 1]!) - size / 2, size, size);
    }
    paper.globalAlpha = 1;
  };
  dots(picture.before?.places, colours.before, 2, 0.75);
  paper.strokeStyle = colours.after;
  paper.lineWidth = 1;
  paper.beginPath();
  for (let i = 0; i < picture.lines.length; i += 4) {
    paper.moveTo(px(picture.lines[i]!), py(picture.lines[i + 1]!));
    paper.lineTo(px(picture.lines[i + 2]!), py(picture.lines[i + 3]!));
  }
  paper.stroke();
  dots(picture.after?.places, colours.after, 2.5, 1);
}

/** What the picture shows, for those who cannot see it. */
export function describeSection(picture: SectionPicture, thickness: number): string {
  const parts = [picture.before, picture.after]
    .map((set, k) => (set ? `${set.points.length} points ${picture.names[k]}` : ''))
    .filter((part) => part !== '');
  return `Cross-section, ${short(thickness)} thick: ${parts.join(', ')}`;
}
