// The street from above: lanes, what each camera sees of the ground, and who moves.

import { onPage, themeColor } from './colors.js';
import { el, icon } from './dom.js';

/** How far a field of view is drawn, metres. */
const REACH_M = 70;
const CAMERA_COLORS = ['#e8590c', '#0c8599', '#9c36b5', '#2b8a3e', '#c2255c', '#1971c2', '#e67700', '#5c940d'];

/** Turns, shifts and clicks on a map, north up. */
export class WorldMap {
  /** `act` is told of `choose(id)`. */
  constructor(act) {
    this.act = act;
    this.canvas = el('canvas', { class: 'map', role: 'img', 'aria-label': 'Map with cameras, their fields of view and all objects seen', tabIndex: 0 });
    const button = (name, label, click) => el('button', {
      type: 'button', class: 'icon-button small', 'aria-label': label, title: label, on: { click },
    }, icon(name, 15));
    this.scaleText = el('span', { class: 'map-scale' });
    this.node = el('section', { class: 'map-box', 'aria-label': 'Map' }, this.canvas,
      el('div', { class: 'map-buttons' },
        button('plus', 'Nearer', () => this.zoom(1.5)), button('minus', 'Farther', () => this.zoom(1 / 1.5)),
        button('fit', 'Show all', () => this.showAll())), this.scaleText);
    this.maps = [];
    this.views = [];
    this.objects = new Map();
    this.trails = new Map();
    this.chosen = null;
    this.center = null;
    this.scale = 3;
    new ResizeObserver(() => {
      if (!this.touched) this.fit();
      this.draw();
    }).observe(this.canvas);
    this.listen();
  }

  listen() {
    const pointers = new Map();
    let moved = 0;
    this.canvas.addEventListener('pointerdown', (event) => {
      this.canvas.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, [event.clientX, event.clientY]);
      moved = 0;
    });
    this.canvas.addEventListener('pointermove', (event) => {
      const before = pointers.get(event.pointerId);
      if (!before || !this.center) return;
      const now = [event.clientX, event.clientY];
      const [dx, dy] = [now[0] - before[0], now[1] - before[1]];
      moved += Math.abs(dx) + Math.abs(dy);
      if (pointers.size === 2) {
        const other = [...pointers].find(([id]) => id !== event.pointerId)[1];
        const spread = ([x, y]) => Math.hypot(x - other[0], y - other[1]);
        this.zoom(spread(now) / Math.max(1, spread(before)));
      } else {
        this.center = [this.center[0] - dx / this.scale, this.center[1] + dy / this.scale];
        this.touched = true;
        this.draw();
      }
      pointers.set(event.pointerId, now);
    });
    const up = (event) => {
      if (pointers.delete(event.pointerId) && event.type === 'pointerup' && moved < 5) this.choose(event);
    };
    this.canvas.addEventListener('pointerup', up);
    this.canvas.addEventListener('pointercancel', up);
    this.canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.zoom(Math.exp(-event.deltaY * 0.0015), event);
    }, { passive: false });
  }

  /** Cameras and maps; either may come later. */
  set({ views, maps, alone }) {
    this.looked = alone;
    this.views = views;
    this.maps = maps;
    this.merged = merge(maps);
    if (!this.touched) this.fit();
    this.draw();
  }

  /** Who is where at a frame. */
  at({ objects, trails, chosen, poses }) {
    Object.assign(this, { objects, trails, chosen, poses });
    if (!this.center) this.fit();
    this.draw();
  }

  choose(event) {
    const { left, top } = this.canvas.getBoundingClientRect();
    const [px, py] = [event.clientX - left, event.clientY - top];
    const [x, y] = this.toWorld(px, py);
    const camera = this.views.find((view) => {
      const eye = eyeOf(view, this.poses);
      if (!eye) return false;
      const [cx, cy] = this.toCanvas(eye);
      return Math.hypot(cx - px, cy - py) < 11;
    });
    if (camera) {
      this.look(camera.number === this.looked ? null : camera.number);
      return;
    }
    let [best, nearest] = [null, 9 / this.scale];
    for (const { object } of this.objects.values()) {
      const reach = Math.max(...(object.box3d?.size.slice(0, 2) ?? [0.6])) / 2;
      const distance = Math.hypot(object.position[0] - x, object.position[1] - y) - reach;
      if (distance < nearest) [best, nearest] = [object.id, distance];
    }
    this.act.choose(best);
  }

  zoom(by, event) {
    if (!this.center) return;
    const scale = Math.max(0.3, Math.min(60, this.scale * by));
    if (event) {
      const { left, top } = this.canvas.getBoundingClientRect();
      const [x, y] = [event.clientX - left, event.clientY - top];
      const before = this.toWorld(x, y);
      this.scale = scale;
      const after = this.toWorld(x, y);
      this.center = this.center.map((value, k) => value + before[k] - after[k]);
    } else this.scale = scale;
    this.touched = true;
    this.draw();
  }

  showAll() {
    this.looked = null;
    this.fit();
  }

  /** The same, unless somebody has moved the map. */
  follow(camera) {
    if (!this.touched) this.look(camera);
  }

  /** Looks at one camera, or at all. */
  look(camera) {
    if (camera === this.looked) return;
    this.looked = camera;
    this.fit();
  }

  /** Shows all cameras and what they see. */
  fit() {
    const views = this.views.filter((view) => this.looked === null || this.looked === undefined || view.number === this.looked);
    const points = views.flatMap((view) => {
      const eye = eyeOf(view, this.poses);
      return eye ? [eye, ...(footprint(view, this.poses) ?? [])] : [];
    });
    if (!points.length) for (const { object } of this.objects.values()) points.push(object.position);
    const [w, h] = [this.canvas.clientWidth, this.canvas.clientHeight];
    if (!points.length || !w || !h) return;
    const low = [0, 1].map((k) => Math.min(...points.map((point) => point[k])));
    const high = [0, 1].map((k) => Math.max(...points.map((point) => point[k])));
    this.center = [0, 1].map((k) => (low[k] + high[k]) / 2);
    const room = 34;
    // On the right are the buttons.
    const buttons = 36;
    this.scale = Math.max(0.3, Math.min(12, (w - room - buttons) / Math.max(20, high[0] - low[0]), (h - room) / Math.max(20, high[1] - low[1])));
    this.center[0] += buttons / 2 / this.scale;
    this.touched = false;
    this.draw();
  }

  toCanvas([x, y]) {
    const [w, h] = [this.canvas.clientWidth, this.canvas.clientHeight];
    return [w / 2 + (x - this.center[0]) * this.scale, h / 2 - (y - this.center[1]) * this.scale];
  }

  toWorld(x, y) {
    const [w, h] = [this.canvas.clientWidth, this.canvas.clientHeight];
    return [this.center[0] + (x - w / 2) / this.scale, this.center[1] - (y - h / 2) / this.scale];
  }

  draw() {
    const ratio = devicePixelRatio || 1;
    const [w, h] = [this.canvas.clientWidth, this.canvas.clientHeight];
    if (!w || !h || !this.center) return;
    const [pw, ph] = [Math.round(w * ratio), Math.round(h * ratio)];
    if (this.canvas.width !== pw || this.canvas.height !== ph) Object.assign(this.canvas, { width: pw, height: ph });
    const context = this.canvas.getContext('2d');
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, w, h);
    context.lineJoin = 'round';
    context.lineCap = 'round';
    const pen = { context, at: (point) => this.toCanvas(point), scale: this.scale };
    this.drawStreets(pen);
    this.views.forEach((view, i) => this.drawField(pen, view, i));
    this.drawTrails(pen);
    for (const { object } of this.objects.values()) this.drawObject(pen, object);
    this.views.forEach((view, i) => this.drawCamera(pen, view, i));
    this.drawScale(pen, w, h);
  }

  drawStreets(pen) {
    const { context, scale } = pen;
    const { lanes, sidewalks, crosswalks } = this.merged ?? {};
    const colors = { road: themeColor('--road'), walk: themeColor('--walk'), zebra: themeColor('--zebra') };
    context.fillStyle = colors.walk;
    for (const world of sidewalks ?? []) {
      path(pen, world, true);
      context.fill();
    }
    context.strokeStyle = colors.road;
    for (const { world, width } of lanes ?? []) {
      path(pen, world);
      context.lineWidth = Math.max(1, width * scale * 1.02);
      context.stroke();
    }
    context.fillStyle = colors.zebra;
    for (const world of crosswalks ?? []) {
      path(pen, world, true);
      context.fill();
    }
  }

  drawField(pen, view, i) {
    const { context } = pen;
    const field = footprint(view, this.poses);
    if (!field) return;
    path(pen, field, true);
    context.fillStyle = `${CAMERA_COLORS[i % CAMERA_COLORS.length]}24`;
    context.fill();
    context.strokeStyle = `${CAMERA_COLORS[i % CAMERA_COLORS.length]}b0`;
    context.lineWidth = 1.2;
    context.stroke();
  }

  drawCamera(pen, view, i) {
    const { context, at } = pen;
    const eye = eyeOf(view, this.poses);
    if (!eye) return;
    const [x, y] = at(eye);
    context.beginPath();
    context.arc(x, y, 9, 0, 7);
    context.fillStyle = CAMERA_COLORS[i % CAMERA_COLORS.length];
    context.fill();
    context.strokeStyle = '#fff';
    context.lineWidth = 1.6;
    context.stroke();
    context.fillStyle = '#fff';
    context.font = '700 10px system-ui, sans-serif';
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    context.fillText(view.of_rig ? 'R' : view.folder.slice(-1).toUpperCase(), x, y + 0.5);
    context.textAlign = 'start';
  }

  drawTrails(pen) {
    const { context } = pen;
    for (const [id, points] of this.trails) {
      const seen = this.objects.get(id);
      if (!seen || points.length < 2 || seen.object.parked) continue;
      path(pen, points);
      context.strokeStyle = onPage(seen.object.class);
      context.globalAlpha = 0.55;
      context.lineWidth = id === this.chosen ? 3 : 1.8;
      context.stroke();
      context.globalAlpha = 1;
    }
  }

  drawObject(pen, object) {
    const { context, at, scale } = pen;
    const chosen = object.id === this.chosen;
    const [length, width] = object.box3d?.size ?? [0.6, 0.6];
    const onFoot = object.class === 'pedestrian' || object.class === 'rider';
    const [x, y] = at(object.position);
    context.save();
    context.translate(x, y);
    context.rotate(-object.yaw_rad);
    context.beginPath();
    if (onFoot) context.arc(0, 0, Math.max(2.4, 0.35 * scale), 0, 7);
    else {
      const [l, w] = [Math.max(6, length * scale), Math.max(3, width * scale)];
      context.moveTo(l / 2, 0);
      context.lineTo(l / 2 - w * 0.45, w / 2);
      context.lineTo(-l / 2, w / 2);
      context.lineTo(-l / 2, -w / 2);
      context.lineTo(l / 2 - w * 0.45, -w / 2);
      context.closePath();
    }
    context.globalAlpha = object.parked && !chosen ? 0.45 : 1;
    context.fillStyle = onPage(object.class);
    context.fill();
    context.globalAlpha = 1;
    if (chosen) {
      context.strokeStyle = themeColor('--text');
      context.lineWidth = 2;
      context.stroke();
    }
    context.restore();
    if (!chosen) return;
    context.fillStyle = themeColor('--text');
    context.font = '600 11px system-ui, sans-serif';
    context.textBaseline = 'middle';
    const text = `${object.class} ${object.id}`;
    // Beside the buttons, not under them.
    const room = this.canvas.clientWidth - context.measureText(text).width - (y < 110 ? 48 : 6);
    context.fillText(text, Math.min(x + 10, room), Math.max(10, y - 10));
  }

  drawScale(pen, w, h) {
    const { context, scale } = pen;
    const metres = [1, 2, 5, 10, 20, 50, 100, 200].find((step) => step * scale > 44) ?? 200;
    context.strokeStyle = themeColor('--muted');
    context.lineWidth = 1.5;
    context.beginPath();
    const [x, y] = [w - 12 - metres * scale, h - 10];
    context.moveTo(x, y - 4);
    context.lineTo(x, y);
    context.lineTo(x + metres * scale, y);
    context.lineTo(x + metres * scale, y - 4);
    context.stroke();
    this.scaleText.textContent = `${metres} m`;
    this.scaleText.style.setProperty('--width', `${metres * scale}px`);
  }
}

function path({ context, at }, points, close = false) {
  context.beginPath();
  for (const [i, point] of points.entries()) context[i ? 'lineTo' : 'moveTo'](...at(point));
  if (close) context.closePath();
}

/** What all cameras see of the streets, each piece once. */
function merge(maps) {
  const whole = { lanes: [], sidewalks: [], crosswalks: [] };
  const seen = new Set();
  const fresh = (kind, id, world) => {
    const key = `${kind} ${id} ${world[0]?.[0]} ${world.length}`;
    if (seen.has(key)) return false;
    seen.add(key);
    return true;
  };
  for (const map of maps) {
    for (const lane of map?.lanes ?? []) {
      for (const { world } of lane.center) if (fresh('lane', lane.id, world)) whole.lanes.push({ world, width: lane.width_m });
    }
    for (const { id, world } of map?.sidewalks ?? []) if (fresh('walk', id, world)) whole.sidewalks.push(world);
    for (const { id, world } of map?.crosswalks ?? []) if (fresh('zebra', id, world)) whole.crosswalks.push(world);
  }
  return whole;
}

const poseOf = (view, poses) => view.camera?.world_from_camera ?? poses?.get(view.number)?.world_from_camera ?? null;

function eyeOf(view, poses) {
  const pose = poseOf(view, poses);
  if (pose) return [pose[0][3], pose[1][3]];
  return view.site?.position ?? null;
}

/** What a camera sees of the ground, as a polygon in the world. */
export function footprint(view, poses) {
  const pose = poseOf(view, poses);
  const camera = view.camera;
  if (!pose || !camera) return null;
  const eye = pose.map((row) => row[3]);
  const ground = camera.ground_plane?.z_m ?? Math.min(0, eye[2] - 2);
  const { width, height } = camera.size;
  const { fx, fy, cx, cy } = poses?.get(view.number)?.intrinsics ?? camera.intrinsics;
  const turned = (v) => [0, 1, 2].map((k) => pose[k][0] * v[0] + pose[k][1] * v[1] + pose[k][2] * v[2]);
  const { model, width_m } = camera.lens;
  if (model === 'orthographic') {
    const half = [width_m / 2, (width_m * height) / width / 2];
    return [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([a, b]) => {
      const shift = turned([a * half[0], b * half[1], 0]);
      return [eye[0] + shift[0], eye[1] + shift[1]];
    });
  }
  if (model !== 'pinhole' && model !== 'opencv') {
    return Array.from({ length: 48 }, (_, i) => {
      const turn = (i / 48) * 2 * Math.PI;
      return [eye[0] + 40 * Math.cos(turn), eye[1] + 40 * Math.sin(turn)];
    });
  }
  const steps = 12;
  const along = (from, to) => Array.from({ length: steps }, (_, i) => from.map((value, k) => value + (to[k] - value) * (i / steps)));
  const corners = [[0, height], [0, 0], [width, 0], [width, height]];
  const border = corners.flatMap((corner, i) => along(corner, corners[(i + 1) % 4]));
  const points = border.map(([u, v]) => {
    const ray = turned([(u - cx) / fx, (v - cy) / fy, 1]);
    const flat = Math.hypot(ray[0], ray[1]) || 1e-9;
    const reach = ray[2] < 0 ? Math.min(REACH_M, ((ground - eye[2]) / ray[2]) * flat) : REACH_M;
    return [eye[0] + (ray[0] / flat) * reach, eye[1] + (ray[1] / flat) * reach];
  });
  return points;
}
