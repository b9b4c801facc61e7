// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
import { sample, type Rgb } from '../colour/maps';
import type { Histogram } from '../data/scene';
import { svg } from './dom';
import { count, short } from './format';

const width = 320;
const height = 110;
const foot = 16;

export function binMiddle(histogram: Histogram, bin: number): number {
  const { low, high, counts } = histogram;
  return low + ((bin + 0.5) * (high - low)) / counts.length;
}

/** Bars in the colours that the map gives their values. */
export function histogramChart(
  histogram: Histogram, map: Rgb[], range: { low: number; high: number },
): SVGSVGElement {
  const { low, high, counts } = histogram;
  const most = Math.max(...counts, 1);
  const total = counts.reduce((sum, n) => sum + n, 0) + histogram.below + histogram.above;
  const label = `Histogram of ${count(total)} points from ${short(low)} to ${short(high)}; ` +
    `${count(histogram.below)} lie below, ${count(histogram.above)} above`;
  const chart = svg('svg', {
    viewBox: `0 0 ${width} ${height}`, class: 'histogram', role: 'img', 'aria-label': label,
  });
  const bar = width / counts.length;
  counts.forEach((n, i) => {
    const tall = (n / most) * (height - foot - 4);
    const middle = binMiddle(histogram, i);
    const colour = sample(map, (middle - range.low) / (range.high - range.low || 1));
    chart.append(svg('rect', {
      x: (i * bar).toFixed(2), y: (height - foot - tall).toFixed(2), width: (bar + 0.05).toFixed(2),
      height: tall.toFixed(2), fill: `rgb(${colour.join(' ')})`,
    }, svg('title', {}, `${short(middle)}: ${count(n)}`)));
  });
  chart.append(svg('line', {
    x1: 0, x2: width, y1: height - foot, y2: height - foot, class: 'axis',
  }));
  const ticks: [number, string, string][] = [
    [0, 'start', short(low, 3)], [width, 'end', short(high, 3)],
  ];
  if (low < 0) ticks.push([width / 2, 'middle', '0']);
  for (const [x, anchor, text] of ticks) {
    chart.append(svg('text', { x, y: height - 3, 'text-anchor': anchor }, text));
  }
  return chart;
}
