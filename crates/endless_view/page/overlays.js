// What is drawn over a picture. Places are pixels of the image; `s` turns them into those of the canvas.

import { ofObject, onPicture } from './colors.js';

/** All overlays: name, title and key. `layer` is that of the dataset which it needs, if it needs one. */
export const OVERLAYS = [
  { name: 'boxes', title: 'Boxes', key: '1' },
  { name: 'ids', title: 'Ids', key: '2' },
  { name: 'masks', title: 'Masks', key: '3', layers: ['instance', 'panoptic'] },
  { name: 'keypoints', title: 'Keypoints', key: '4' },
  { name: 'boxes3d', title: '3D boxes', key: '5' },
  { name: 'tracks', title: 'Tracks', key: '6' },
  { name: 'lanes', title: 'Lanes', key: '7' },
  { name: 'lights', title: 'Lights', key: '8' },
];
export const DEFAULT_SHOW = ['boxes', 'ids'];

/** Frames of a track that are drawn. */
export const TRACK_FRAMES = 40;

const EDGES = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4], [0, 4], [1, 5], [2, 6], [3, 7]];
const FRONT = new Set([0, 3, 4, 7]);
const ASPECTS = { red: '#ff4d4d', yellow: '#ffc83d', green: '#3ddc74', red_yellow: '#ff8a3d' };
const css = ([r, g, b], alpha = 1) => `rgba(${r}, ${g}, ${b}, ${alpha})`;

/** Draws all overlays that are on. */
export function drawOverlays(canvas, what) {
  const { size, ratio, show, objects, chosen, hovered } = what;
  const context = canvas.getContext('2d');
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.clearRect(0, 0, canvas.width, canvas.height);
  const s = canvas.width / size.width;
  const pen = { context, s, ratio, at: ([x, y]) => [x * s, y * s] };
  context.lineJoin = 'round';
  context.lineCap = 'round';
  if (show.has('lanes')) drawLanes(pen, what.map);
  if (show.has('tracks')) drawTracks(pen, what.tracks, objects, chosen);
  if (show.has('boxes3d')) for (const object of objects) drawBox3d(pen, object, object.id === chosen);
  if (show.has('boxes')) for (const object of objects) drawBox(pen, object, object.id === chosen);
  if (show.has('keypoints')) for (const object of objects) drawKeypoints(pen, object, what.skeleton);
  if (show.has('lights')) drawLights(pen, objects, what.map, what.aspects);
  const marked = objects.filter((object) => object.id === chosen || object.id === hovered);
  for (const object of marked) if (!show.has('boxes') || object.id === chosen) drawMarked(pen, object, object.id === chosen);
  drawIds(pen, show.has('ids') ? objects : marked, new Set(marked.map((object) => object.id)), chosen);
}

/** Labels of near objects first; one that would lie on another is left out, unless it is asked for. */
function drawIds(pen, objects, marked, chosen) {
  const taken = [];
  const rank = (object) => (marked.has(object.id) ? Infinity : object.bbox[2] * object.bbox[3]);
  const labels = [...objects].sort((a, b) => rank(b) - rank(a)).map((object) => idLabel(pen, object, chosen));
  const free = labels.filter((label) => {
    const { left, top, width, height } = label;
    const covers = taken.some((other) => left < other.left + other.width && other.left < left + width
      && top < other.top + other.height && other.top < top + height);
    if (covers && !marked.has(label.object.id)) return false;
    taken.push(label);
    return true;
  });
  for (const label of free.reverse()) drawLabel(pen, label, chosen);
}

function line(pen, points, close = false) {
  const { context, at } = pen;
  context.beginPath();
  for (const [i, point] of points.entries()) context[i ? 'lineTo' : 'moveTo'](...at(point));
  if (close) context.closePath();
}

/** A line that can be seen on light and on dark. */
function stroke(pen, color, width, dark = 0.45) {
  const { context, ratio } = pen;
  context.strokeStyle = `rgba(0, 0, 0, ${dark})`;
  context.lineWidth = (width + 1.6) * ratio;
  context.stroke();
  context.strokeStyle = color;
  context.lineWidth = width * ratio;
  context.stroke();
}

function drawBox(pen, object, chosen) {
  const { context, s } = pen;
  const [x, y, w, h] = object.bbox;
  context.beginPath();
  context.rect(x * s, y * s, w * s, h * s);
  stroke(pen, onPicture(object.class), chosen ? 2.4 : 1.4, 0.35);
}

function drawMarked(pen, object, chosen) {
  const { context, s, ratio } = pen;
  const [x, y, w, h] = object.bbox;
  const gap = 3 * ratio;
  context.beginPath();
  context.roundRect(x * s - gap, y * s - gap, w * s + 2 * gap, h * s + 2 * gap, 3 * ratio);
  stroke(pen, '#fff', chosen ? 2 : 1.2, 0.6);
}

/** Text and place of an object's label. On small objects a long one would hide more than it tells. */
function idLabel({ context, s, ratio }, object, chosen) {
  const [x, y, w] = object.bbox;
  const small = w * s < 26 * ratio && object.id !== chosen;
  const size = (small ? 9 : 11) * ratio;
  const font = `600 ${size}px system-ui, sans-serif`;
  context.font = font;
  const text = small ? `${object.id}` : `${object.class} ${object.id}`;
  const width = context.measureText(text).width + 6 * ratio;
  const height = size + 4 * ratio;
  const left = Math.max(0, Math.min(x * s - 0.5 * ratio, context.canvas.width - width));
  const above = y * s - height - ratio;
  return { object, text, font, small, left, top: above < 0 ? y * s + ratio : above, width, height };
}

function drawLabel({ context, ratio }, { object, text, font, small, left, top, width, height }, chosen) {
  context.fillStyle = object.id === chosen ? '#fff' : onPicture(object.class);
  context.globalAlpha = small ? 0.85 : 0.94;
  context.beginPath();
  context.roundRect(left, top, width, height, 2.5 * ratio);
  context.fill();
  context.globalAlpha = 1;
  context.font = font;
  context.fillStyle = '#0b0e13';
  context.textBaseline = 'middle';
  context.fillText(text, left + 3 * ratio, top + height / 2 + 0.5 * ratio);
}

function drawKeypoints(pen, object, skeleton) {
  const { context, s, ratio } = pen;
  const values = object.keypoints;
  if (!values) return;
  const points = Array.from({ length: values.length / 3 }, (_, i) => values.slice(3 * i, 3 * i + 3));
  const height = object.bbox[3] * s / ratio;
  const width = height < 60 ? 1.2 : 2;
  for (const [a, b] of skeleton) {
    const [from, to] = [points[a - 1], points[b - 1]];
    if (!from?.[2] || !to?.[2]) continue;
    line(pen, [from, to]);
    const hidden = from[2] === 1 || to[2] === 1;
    context.globalAlpha = hidden ? 0.55 : 1;
    stroke(pen, a === b ? '#fff' : limbColor(a, b), width, 0.3);
    context.globalAlpha = 1;
  }
  if (height < 40) return;
  for (const [x, y, v] of points) {
    if (!v) continue;
    context.beginPath();
    context.arc(x * s, y * s, (height < 90 ? 1.6 : 2.4) * ratio, 0, 7);
    context.fillStyle = v === 2 ? '#fff' : '#222a';
    context.fill();
    context.strokeStyle = '#000a';
    context.lineWidth = 0.8 * ratio;
    context.stroke();
  }
}

/** Left and right of a body in two colours; odd numbers above 1 are on its right. */
function limbColor(a, b) {
  if (a <= 5 && b <= 5) return '#ffd43b';
  if (a % 2 === b % 2) return a % 2 ? '#ff922b' : '#4dd4fa';
  return '#b2f2bb';
}

function drawBox3d(pen, object, chosen) {
  const corners = object.box3d?.corners;
  if (!corners) return;
  const color = onPicture(object.class);
  const face = [0, 3, 7, 4].map((i) => corners[i]);
  if (face.every(Boolean)) {
    line(pen, face, true);
    pen.context.globalAlpha = 0.22;
    pen.context.fillStyle = color;
    pen.context.fill();
    pen.context.globalAlpha = 1;
  }
  for (const [a, b] of EDGES) {
    if (!corners[a] || !corners[b]) continue;
    line(pen, [corners[a], corners[b]]);
    const front = FRONT.has(a) && FRONT.has(b);
    stroke(pen, front ? '#fff' : color, (front ? 1.5 : 1.2) + (chosen ? 0.8 : 0), 0.3);
  }
}

/** `tracks` are the places of each object in the frames before, the last one first. */
function drawTracks(pen, tracks, objects, chosen) {
  const { context, ratio } = pen;
  const there = new Map(objects.map((object) => [object.id, object]));
  for (const [id, points] of tracks ?? []) {
    const object = there.get(id);
    if (!object || (object.parked && id !== chosen) || points.length < 2) continue;
    const color = ofObject(id);
    for (let i = 1; i < points.length; i += 1) {
      line(pen, [points[i - 1], points[i]]);
      context.strokeStyle = css(color, 1 - 0.85 * (i / TRACK_FRAMES));
      context.lineWidth = (id === chosen ? 4 : 2.6) * ratio;
      context.stroke();
    }
    context.beginPath();
    context.arc(...pen.at(points[0]), 2.6 * ratio, 0, 7);
    context.fillStyle = css(color);
    context.fill();
  }
}

function drawLanes(pen, map) {
  if (!map) return;
  const { context, ratio } = pen;
  for (const { image } of map.sidewalks) {
    line(pen, image, true);
    context.fillStyle = 'rgba(190, 160, 255, 0.14)';
    context.fill();
  }
  for (const { image } of map.crosswalks) {
    line(pen, image, true);
    context.fillStyle = 'rgba(126, 231, 135, 0.22)';
    context.fill();
    stroke(pen, '#7ee787', 1.2, 0.2);
  }
  for (const lane of map.lanes) {
    for (const side of [lane.left, lane.right]) {
      for (const { image } of side ?? []) {
        line(pen, image);
        context.strokeStyle = 'rgba(120, 200, 255, 0.42)';
        context.lineWidth = ratio;
        context.stroke();
      }
    }
    for (const { image } of lane.center) {
      line(pen, image);
      stroke(pen, lane.junction === undefined ? '#58c4ff' : '#9ad8ff', 1.5, 0.25);
      arrow(pen, image);
    }
  }
  for (const { pieces } of map.stop_lines) {
    for (const { image } of pieces) {
      line(pen, image);
      stroke(pen, '#ff6b6b', 2.2, 0.3);
    }
  }
}

/** The direction of travel, in the middle of a line. */
function arrow(pen, image) {
  const { context, ratio, s } = pen;
  let [half, place] = [0, null];
  const lengths = image.slice(1).map(([x, y], i) => Math.hypot(x - image[i][0], y - image[i][1]));
  const total = lengths.reduce((sum, length) => sum + length, 0);
  if (total * s < 50 * ratio) return;
  for (const [i, length] of lengths.entries()) {
    half += length;
    if (half < total / 2 || !length) continue;
    place = [image[i + 1], Math.atan2(image[i + 1][1] - image[i][1], image[i + 1][0] - image[i][0])];
    break;
  }
  if (!place) return;
  const [[x, y], angle] = place;
  const size = 6 * ratio;
  context.beginPath();
  for (const [i, turn] of [0, 2.5, -2.5].entries()) {
    context[i ? 'lineTo' : 'moveTo'](x * s + size * Math.cos(angle + turn), y * s + size * Math.sin(angle + turn));
  }
  context.closePath();
  context.fillStyle = '#58c4ff';
  context.fill();
}

function drawLights(pen, objects, map, aspects) {
  const { context, s, ratio } = pen;
  for (const head of map?.signals ?? []) {
    const color = ASPECTS[aspects?.get(head.group)];
    if (!color) continue;
    const [x, y, w, h] = head.bbox;
    context.beginPath();
    context.roundRect(x * s - ratio, y * s - ratio, w * s + 2 * ratio, h * s + 2 * ratio, 2 * ratio);
    stroke(pen, color, 1.8, 0.5);
    if (!head.front_seen) continue;
    glow(pen, [x + w / 2, y + h / 2], color, Math.max(3.5, (w * s) / ratio));
  }
  for (const object of objects) for (const [place, color] of lamps(object)) glow(pen, place, color, lampSize(pen, object));
}

const lampSize = ({ s, ratio }, object) => Math.max(2.2, Math.min(7, (object.bbox[3] * s) / ratio / 9));

/** Where a vehicle's lit lamps are, about: at the corners of its box in space, a third of the way up. */
function lamps(object) {
  const corners = object.box3d?.corners;
  if (!corners || !object.lights?.length) return [];
  const at = (i, up, inwards = 0.12) => {
    const other = { 0: 3, 3: 0, 1: 2, 2: 1 }[i];
    const [low, high, lowOther, highOther] = [corners[i], corners[i + 4], corners[other], corners[other + 4]];
    if (!low || !high || !lowOther || !highOther) return null;
    return [0, 1].map((k) => {
      const [mine, across] = [low[k] + (high[k] - low[k]) * up, lowOther[k] + (highOther[k] - lowOther[k]) * up];
      return mine + (across - mine) * inwards;
    });
  };
  const lit = new Set(object.lights);
  const found = [];
  const put = (corner, up, color, inwards) => {
    const place = at(corner, up, inwards);
    if (place) found.push([place, color]);
  };
  if (lit.has('low_beam') || lit.has('high_beam')) for (const corner of [0, 3]) put(corner, 0.42, '#fff7c2');
  else if (lit.has('position')) for (const corner of [0, 3]) put(corner, 0.42, '#d9d3a5');
  if (lit.has('brake')) for (const corner of [1, 2]) put(corner, 0.52, '#ff2d2d');
  else if (lit.has('position')) for (const corner of [1, 2]) put(corner, 0.52, '#b3262a');
  if (lit.has('reverse')) for (const corner of [1, 2]) put(corner, 0.4, '#ffffff', 0.2);
  if (lit.has('left_blinker')) for (const corner of [0, 1]) put(corner, 0.46, '#ffa51f', 0.02);
  if (lit.has('right_blinker')) for (const corner of [3, 2]) put(corner, 0.46, '#ffa51f', 0.02);
  if (lit.has('special1')) put(0, 1, '#4a7dff', 0.3);
  if (lit.has('special2')) put(3, 1, '#4a7dff', 0.3);
  return found;
}

function glow(pen, [x, y], color, radius) {
  const { context, s, ratio } = pen;
  const [cx, cy, r] = [x * s, y * s, radius * ratio];
  const light = context.createRadialGradient(cx, cy, 0, cx, cy, r);
  light.addColorStop(0, '#fff');
  light.addColorStop(0.35, color);
  light.addColorStop(1, `${color}00`);
  context.fillStyle = light;
  context.beginPath();
  context.arc(cx, cy, r, 0, 7);
  context.fill();
}
