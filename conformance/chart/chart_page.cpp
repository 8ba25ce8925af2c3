#include "conformance/chart/chart_page.h"

namespace gouraud::chart {

const std::string_view chart_page_head = R"(<!doctype html>
<html lang="en"><meta charset="utf-8"><title>Gouraud: speed against accuracy</title>
<style>
body { font: 14px/1.45 system-ui, sans-serif; margin: 2em; color: #222; max-width: 1300px }
nav a { margin-right: .8em } h2 { margin-top: 2em; border-top: 1px solid #ccc; padding-top: .6em }
svg { background: #fff; border: 1px solid #ddd } svg text { font-size: 11px; fill: #444 }
svg circle { cursor: pointer; stroke: #fff } svg circle:hover { stroke: #000 }
.grid { stroke: #e6e6e6 } .front { fill: none; stroke: #888; stroke-dasharray: 4 3 }
.detail { display: flex; flex-wrap: wrap; gap: 10px; margin: .6em 0 }
figure { margin: 0 } figcaption { font-size: 12px; color: #555 } img { image-rendering: pixelated; border: 1px solid #ccc; display: block }
table { border-collapse: collapse; font-size: 13px } td, th { padding: 1px 9px; text-align: right } td:first-child, th:first-child { text-align: left }
tr:nth-child(even) { background: #f5f5f5 } tbody tr { cursor: pointer } .failure { color: #b00020; cursor: default }
</style>
<h1>Speed against accuracy</h1>
<p>Each point is one way to draw the scene: Gouraud's default (red), Gouraud's other methods (blue), Mesa's llvmpipe and
softpipe (green). Time is the median processor time of a frame on one core, relative to llvmpipe's in the same run, taken
in turns. Error is against the oracle, which computes in double and exact integers. Both axes are logarithmic; points
below the plot's last line have an error of less than that. The dashed line is the Pareto front. Click on a point or a
row for its picture and error map: black is right to rounding, brighter is worse, magenta is drawn in excess, cyan is missing.</p>
<p>Error on the y axis: <select id="axis"></select></p>
<nav id="nav"></nav><div id="scenes"></div>
)";

const std::string_view chart_page_script = R"(
const make = (tag, parent, text) => { const e = document.createElement(tag); if (text !== undefined) e.textContent = text; parent.append(e); return e };
const draw = (tag, parent, attributes, text) => {
  const e = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) e.setAttribute(name, value);
  if (text !== undefined) e.textContent = text;
  parent.append(e);
  return e;
};
const least = 1e-5, colors = { default: '#c62828', method: '#1565c0', llvmpipe: '#2e7d32', softpipe: '#66a66a' };
const short = value => value === undefined ? '' : value === 0 ? '0' : value.toPrecision(3);

function isOnFront(point, points) {
  return !points.some(o => o.time <= point.time && o.error <= point.error && (o.time < point.time || o.error < point.error));
}

function plot(parent, points, label, open) {
  const width = 760, height = 430, left = 70, right = 150, top = 14, bottom = 44;
  const svg = draw('svg', parent, { width, height });
  const times = points.map(p => Math.log10(p.time)), errors = points.map(p => Math.log10(Math.max(p.error, least)));
  const x0 = Math.floor(Math.min(...times, 0) * 2) / 2, x1 = Math.ceil(Math.max(...times, 0.1) * 2) / 2;
  const y0 = Math.floor(Math.min(...errors)), y1 = Math.max(Math.ceil(Math.max(...errors)), y0 + 1);
  const x = v => left + (v - x0) / (x1 - x0) * (width - left - right), y = v => top + (y1 - v) / (y1 - y0) * (height - top - bottom);
  for (let v = x0; v <= x1 + 1e-9; v += 0.5) {
    draw('line', svg, { class: 'grid', x1: x(v), x2: x(v), y1: top, y2: height - bottom });
    draw('text', svg, { x: x(v), y: height - bottom + 14, 'text-anchor': 'middle' }, short(10 ** v));
  }
  for (let v = y0; v <= y1; ++v) {
    draw('line', svg, { class: 'grid', x1: left, x2: width - right, y1: y(v), y2: y(v) });
    draw('text', svg, { x: left - 6, y: y(v) + 4, 'text-anchor': 'end' }, '1e' + v);
  }
  draw('text', svg, { x: (left + width - right) / 2, y: height - 8, 'text-anchor': 'middle' }, 'processor time, relative to llvmpipe');
  draw('text', svg, { x: 14, y: height / 2, 'text-anchor': 'middle', transform: `rotate(-90 14 ${height / 2})` }, label);
  const front = points.filter(p => isOnFront(p, points)).sort((a, b) => a.time - b.time);
  let path = '';
  front.forEach((p, i) => {
    const px = x(Math.log10(p.time)), py = y(Math.log10(Math.max(p.error, least)));
    path += i === 0 ? `M${px} ${py}` : `H${px} V${py}`;
  });
  draw('path', svg, { class: 'front', d: path });
  // Labels that would lie over each other move up.
  const placed = [];
  const freeHeight = (px, py) => {
    let free = py;
    while (placed.some(o => Math.abs(o.px - px) < 120 && Math.abs(o.py - free) < 11) && free > top) free -= 11;
    placed.push({ px, py: free });
    return free;
  };
  for (const p of points) {
    const px = x(Math.log10(p.time)), py = y(Math.log10(Math.max(p.error, least)));
    const dot = draw('circle', svg, { cx: px, cy: py, r: p.owner === 'default' ? 7 : 5, fill: colors[p.owner] });
    draw('title', dot, {}, `${p.name}: time ${short(p.time)}, error ${short(p.error)}`);
    draw('text', svg, { x: px + 8, y: freeHeight(px, py) + 4 }, p.name);
    if (open) dot.addEventListener('click', () => open(p.entry));
  }
}

function figure(parent, image, caption) {
  const f = make('figure', parent);
  const img = make('img', f);
  img.src = images[image];
  img.alt = caption;
  make('figcaption', f, caption);
}

function table(parent, scene, open) {
  const t = make('table', parent), head = make('tr', make('thead', t)), body = make('tbody', t);
  for (const title of ['', 'ms', 'relative', 'coverage, %', 'colour mean', 'max', 'beyond rounding', 'depth mean', 'max', '1 - SSIM']) make('th', head, title);
  for (const e of [...scene.entries].sort((a, b) => (a.relative_time ?? 1e9) - (b.relative_time ?? 1e9))) {
    const row = make('tr', body);
    make('td', row, e.contestant);
    if (e.failure) { const cell = make('td', row, e.failure); cell.colSpan = 9; cell.className = 'failure'; continue; }
    for (const value of [e.frame_ms, e.relative_time, e.errors.coverage, e.color_mean, e.color_max, e.errors.color, e.depth_mean, e.depth_max, e.errors.perceptual]) make('td', row, short(value));
    row.addEventListener('click', () => open(e));
  }
}

function show(axis) {
  const nav = document.getElementById('nav'), all = document.getElementById('scenes');
  nav.replaceChildren();
  all.replaceChildren();
  const owners = Object.fromEntries(chart.scenes.flatMap(s => s.entries.map(e => [e.contestant, e.owner])));
  make('h2', all, 'All scenes with an exact reference');
  make('p', all, 'Time: the geometric mean over the scenes. Error: the mean.');
  const overall = chart.overall[axis].map(p => ({ name: p.contestant, owner: owners[p.contestant], time: p.relative_time, error: p.error }));
  if (overall.length) plot(all, overall, chart.axes[axis]);
  for (const scene of chart.scenes) {
    const link = make('a', nav, scene.name);
    link.href = '#' + scene.name;
    make('h2', all, scene.name).id = scene.name;
    make('p', all, scene.shows + '. Reference: ' + scene.reference + '.');
    const points = scene.entries.filter(e => !e.failure && e.errors[axis] !== undefined)
        .map(e => ({ name: e.contestant, owner: e.owner, time: e.relative_time, error: e.errors[axis], entry: e }));
    const place = make('div', all), detail = make('div', all);
    detail.className = 'detail';
    const open = e => {
      detail.replaceChildren();
      figure(detail, e.picture, `${e.contestant}: ${short(e.frame_ms)} ms, ${short(e.relative_time)} of llvmpipe's time`);
      figure(detail, e.error_map, `error: mean ${short(e.color_mean)}/255, largest ${short(e.color_max)}/255`);
      figure(detail, scene.reference_picture, 'the reference');
    };
    if (points.length) plot(place, points, chart.axes[axis], open);
    else make('p', place, 'The reference of this scene does not know this error.');
    table(all, scene, open);
  }
}

const select = document.getElementById('axis');
for (const [name, label] of Object.entries(chart.axes)) { const option = make('option', select, label); option.value = name; }
select.addEventListener('change', () => show(select.value));
show('color');
)";

}  // namespace gouraud::chart
