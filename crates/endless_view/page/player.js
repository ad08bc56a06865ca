// One video: all cameras in step, what is known of them, and where one is in time.

import { json, paths } from './api.js';
import { el, fill, words } from './dom.js';
import { Inspector } from './inspector.js';
import { Lines } from './labels.js';
import { DEFAULT_SHOW, OVERLAYS, TRACK_FRAMES } from './overlays.js';
import { Pictures } from './pictures.js';
import { videoHash } from './place.js';
import { ObjectList, ScenePanel } from './scene_panel.js';
import { Timeline } from './timeline.js';
import { Transport } from './transport.js';
import { CameraView, letter } from './view.js';
import { WorldMap } from './world_map.js';

/** Frames that are loaded ahead while a video plays. */
const AHEAD = 5;
const LAYER_KEYS = { 9: 'depth', 0: 'flow' };
const LAYER_TITLES = { rgb: 'RGB', flow_backward: 'Flow backward', body_parts: 'Body parts' };
const title = (layer) => LAYER_TITLES[layer] ?? layer[0].toUpperCase() + words(layer.slice(1));

/** The page of a video. */
export class Player {
  constructor(place, dataset, act) {
    this.number = place.video;
    this.dataset = dataset;
    this.act = act;
    this.frame = place.frame;
    this.show = new Set(place.show ?? DEFAULT_SHOW);
    this.layer = place.layer ?? 'rgb';
    this.blend = 0.85;
    this.chosen = place.object;
    this.alone = place.camera;
    this.tab = place.object === null ? 'scene' : 'object';
    this.playing = false;
    this.video = null;
    this.views = [];
    this.turn = 0;
    this.pictures = new Pictures(this.number);
    const choose = (id) => this.choose(id);
    const seek = (frame) => this.seek(frame);
    this.transport = new Transport({
      toggle: () => this.toggle(), step: (n) => this.step(n), seek, link: () => this.copyLink(), whole: () => this.whole(),
    });
    this.timeline = new Timeline(seek);
    this.map = new WorldMap({ choose });
    this.inspector = new Inspector({ seek, choose, picture: (camera, frame) => this.pictures.shown(camera, 'rgb', frame) });
    this.scenePanel = new ScenePanel({ seek, choose });
    this.objectList = new ObjectList({ choose });
    this.build();
  }

  build() {
    this.overlayBar = el('div', { class: 'overlay-bar', role: 'toolbar', 'aria-label': 'What is shown' });
    this.grid = el('div', { class: 'views' });
    this.tabs = el('div', { class: 'tabs', role: 'tablist' });
    this.panel = el('div', { class: 'panel' });
    this.stage = el('section', { class: 'player-stage', 'aria-label': 'Pictures' }, this.overlayBar, this.grid, this.transport.node, this.timeline.node);
    this.node = el('div', { class: 'player' }, this.stage,
      el('aside', { class: 'side' }, this.map.node, this.tabs, this.panel));
    this.showTabs();
  }

  /** Asks for the video, and shows its frame as soon as it is there. */
  async open() {
    try {
      this.set(await json(paths.video(this.number)));
    } catch (error) {
      if (!this.gone) this.fail(error);
      return;
    }
    await this.draw();
    this.later();
  }

  fail(error) {
    fill(this.grid, el('p', { class: 'empty', text: error.status === 404
      ? `${error.message[0].toUpperCase()}${error.message.slice(1)}. It may not have been recorded yet.` : error.message }));
  }

  set(video) {
    this.video = video;
    this.frames = video.scene.frames;
    this.there = video.frames_there;
    this.fps = video.scene.fps;
    video.views.forEach((view, i) => {
      view.number = i;
      view.site = video.scene.cameras[i] ?? null;
    });
    this.layers = [...new Set(video.views.flatMap((view) => view.layers))];
    if (this.layers.length && !this.layers.includes(this.layer)) this.layer = this.layers.includes('rgb') ? 'rgb' : this.layers[0];
    this.maskLayer = ['instance', 'panoptic'].find((layer) => this.layers.includes(layer));
    if (this.alone !== null && !video.views[this.alone]) this.alone = null;
    this.objects = video.views.map((view) => (view.has_objects
      ? new Lines((from, n) => paths.objects(this.number, view.number, from, n)) : null));
    this.poses = video.views.map((view) => (view.camera && !view.camera.world_from_camera
      ? new Lines((from, n) => paths.poses(this.number, view.number, from, n)) : null));
    this.lines = video.state === 'complete' && video.scene.frame_lines !== undefined
      ? new Lines((from, n) => paths.frames(this.number, from, n)) : null;
    this.frame = this.inside(this.frame);
    // What the first picture needs is on its way while the page is made.
    for (const view of video.views) if (this.alone === null || this.alone === view.number) this.load({ view }, this.frame).catch(() => {});
    this.quietLine(this.lines, this.frame);
    this.views = video.views.map((view) => new CameraView(view.number, view, {
      choose: (id) => this.choose(id), solo: (camera) => this.solo(this.alone === camera ? null : camera),
    }));
    this.showMeanings();
    this.showViews();
    this.showBar();
    this.tell();
  }

  /** What need not be there for the first picture. */
  async later() {
    const number_ = this.number;
    const quiet = (promise) => promise.catch(() => null);
    const { views } = this.video;
    const maps = Promise.all(views.map((view) => (view.has_map ? quiet(json(paths.map(number_, view.number))) : null)));
    this.timeline.set({ data: null, frames: this.frames, there: this.there, incidents: this.video.scene.incidents, note: this.video.state === 'complete' ? 'Counting…' : 'Counts come when the video is complete.' });
    this.maps = await maps;
    if (this.gone) return;
    this.map.set({ views, maps: this.maps, alone: this.alone });
    this.draw();
    this.actors = new Map(((this.video.has_actors ? await quiet(json(paths.actors(number_))) : null) ?? []).map((actor) => [actor.id, actor]));
    if (this.gone) return;
    if (this.chosen !== null) this.panels();
    if (this.video.state !== 'complete') return;
    try {
      this.counts = await json(paths.timeline(number_));
      this.appearances = new Map(this.counts.objects.map((object) => [object.id, object]));
      this.timeline.set({ data: this.counts, frames: this.frames, there: this.there, incidents: this.video.scene.incidents });
    } catch (error) {
      this.timeline.set({ data: null, frames: this.frames, there: this.there, note: `Nothing can be counted: ${error.message}` });
    }
    if (!this.gone) this.panels();
  }

  leave() {
    this.gone = true;
    this.playing = false;
    this.pictures.leave();
    clearTimeout(this.hashTimer);
  }

  /** The dataset has changed: this video may have more frames. */
  async datasetChanged() {
    const entry = this.dataset.data?.videos.find((video) => video.video === this.number);
    this.showMeanings();
    if (!entry || (this.video && this.video.state === 'complete' && entry.state === 'complete')) return;
    if (!this.video || entry.state !== this.video.state) {
      this.open();
      return;
    }
    try {
      const video = await json(paths.video(this.number));
      const before = this.there;
      this.there = video.frames_there;
      this.tell();
      this.timeline.set({ data: null, frames: this.frames, there: this.there, note: 'Counts come when the video is complete.' });
      if (!before && this.there) this.open();
    } catch {
      // It is asked again.
    }
  }

  showMeanings() {
    const labels = this.dataset.data?.labels;
    if (!labels) return;
    this.skeleton = labels.skeleton;
    const had = this.meanings;
    this.meanings = new Map([...labels.actors.fields, ...labels.object_fields].map(({ name, meaning }) => [name, meaning]));
    if (!had && this.video && this.show.has('keypoints')) this.draw();
  }

  /** To another place in the same video. */
  go(place) {
    this.show = new Set(place.show ?? DEFAULT_SHOW);
    this.layer = place.layer ?? 'rgb';
    this.chosen = place.object;
    this.alone = place.camera;
    this.frame = place.frame;
    if (!this.video) return;
    this.frame = this.inside(place.frame);
    this.showViews();
    this.showBar();
    this.draw();
  }

  inside(frame) {
    return Math.max(0, Math.min(Math.max(0, this.there - 1), Math.round(frame)));
  }

  // What is chosen.

  choose(id) {
    if (id === this.chosen && id === null) return;
    this.chosen = id;
    this.tab = id === null ? (this.tab === 'object' ? 'scene' : this.tab) : 'object';
    this.note();
    this.draw();
  }

  solo(camera) {
    this.alone = camera;
    this.showViews();
    this.note();
    this.draw();
  }

  toggleOverlay(name) {
    if (!this.show.delete(name)) this.show.add(name);
    this.showBar();
    this.note();
    this.draw();
  }

  setLayer(layer) {
    this.layer = layer;
    this.showBar();
    this.note();
    this.draw();
  }

  // Time.

  seek(frame) {
    const wanted = this.inside(Math.min(frame, this.there - 1));
    if (wanted === this.frame) return this.drawing;
    this.frame = wanted;
    this.note();
    this.tell();
    return this.draw();
  }

  step(n) {
    this.playing = false;
    this.seek(this.frame + n);
    this.tell();
  }

  toggle() {
    this.playing = !this.playing;
    this.tell();
    if (this.playing) this.play();
  }

  /** One frame after the other, each when all of its pictures are there. */
  async play() {
    if (this.frame >= this.there - 1) this.seek(0);
    let due = performance.now();
    while (this.playing && !this.gone) {
      due = Math.max(due + 1000 / (this.fps * this.transport.speed), performance.now() - 250);
      await this.draw();
      const wait = due - performance.now();
      await new Promise((resolve) => (wait > 2 ? setTimeout(resolve, wait) : requestAnimationFrame(resolve)));
      if (!this.playing || this.gone) return;
      if (this.frame >= this.there - 1) {
        this.playing = false;
        this.note();
        this.tell();
        return;
      }
      this.frame += 1;
      this.note();
      this.tell();
    }
  }

  tell() {
    if (!this.video) return;
    const { frame, there, frames, fps, playing } = this;
    this.transport.set({ frame, there, frames, fps, playing });
  }

  // Drawing.

  /** Draws the frame; of those asked for meanwhile only the last. */
  draw() {
    if (!this.video) return Promise.resolve();
    this.wanted = true;
    this.drawing ??= this.drawWanted().finally(() => { this.drawing = null; });
    return this.drawing;
  }

  async drawWanted() {
    while (this.wanted && !this.gone) {
      this.wanted = false;
      await this.drawNow();
    }
  }

  async drawNow() {
    const { frame } = this;
    const views = this.shownViews();
    const [line, ...loaded] = await Promise.all([this.quietLine(this.lines, frame), ...views.map((view) => this.load(view, frame))]);
    const others = await Promise.all(this.views.filter((view) => !views.includes(view)).map((view) => this.objectsOf(view.view, frame)));
    if (this.gone) return;
    const aspects = new Map((line?.signals ?? []).map(({ id, aspect }) => [id, aspect]));
    views.forEach((view, i) => view.draw({
      ...loaded[i], show: this.show, chosen: this.chosen, blend: this.blend, aspects, map: this.maps?.[view.number], skeleton: this.skeleton ?? [],
      instanceLayer: this.maskLayer,
    }));
    this.line = line;
    this.now = gather(this.views.map((view) => ({
      view: view.view, objects: views.includes(view) ? loaded[views.indexOf(view)].objects : others[this.views.filter((v) => !views.includes(v)).indexOf(view)],
    })));
    if (!this.firstShown) {
      this.firstShown = true;
      performance.mark('first-frame');
    }
    this.node.dataset.frame = frame;
    this.timeline.at(frame);
    this.mapAt(frame);
    // While it plays, the panels would change too fast to read, and take time.
    if (!this.playing || frame % 5 === 0) this.panels();
    this.ahead(frame, views);
  }

  shownViews() {
    return this.views.filter((view) => this.alone === null || view.number === this.alone);
  }

  async quietLine(lines, number_) {
    if (!lines) return null;
    try {
      return await lines.line(number_);
    } catch {
      return null;
    }
  }

  /** The frame of a camera that films at every so many. */
  frameOf(view, frame) {
    return Math.floor(frame / view.every) * view.every;
  }

  async objectsOf(view, frame) {
    const line = await this.quietLine(this.objects[view.number], Math.floor(frame / view.every));
    return line?.objects ?? [];
  }

  /** All that is needed to draw a camera's frame. */
  async load({ view }, frame) {
    const at = this.frameOf(view, frame);
    const quiet = (layer, load) => (view.layers.includes(layer) ? load().catch(() => null) : null);
    const layer = this.layer !== 'rgb' && view.layers.includes(this.layer) ? this.layer : null;
    const wantsIds = this.maskLayer && (this.show.has('masks') || (!this.playing && this.known));
    const [rgb, shown, instance, line, tracks] = await Promise.all([
      quiet('rgb', () => this.pictures.shown(view.number, 'rgb', at)),
      layer && quiet(layer, () => this.pictures.shown(view.number, layer, at)),
      wantsIds ? quiet(this.maskLayer, () => this.pictures.stored(view.number, this.maskLayer, at)) : null,
      this.quietLine(this.objects[view.number], Math.floor(frame / view.every)),
      this.show.has('tracks') ? this.tracks(view, frame) : null,
    ]);
    return { rgb, layer: shown, instance, objects: line?.objects ?? [], labelled: Boolean(line), tracks };
  }

  /** The middle of the lower edge of each box in the last frames, the last one first. */
  async tracks(view, frame) {
    const tracks = new Map();
    for (const line of await this.before(view, frame)) {
      for (const { id, bbox: [x, y, w, h] } of line.objects) {
        if (!tracks.has(id)) tracks.set(id, []);
        tracks.get(id).push([x + w / 2, y + h]);
      }
    }
    return tracks;
  }

  async before(view, frame) {
    const lines = this.objects[view.number];
    if (!lines) return [];
    const last = Math.floor(frame / view.every);
    try {
      return (await lines.range(Math.max(0, last - TRACK_FRAMES + 1), last)).reverse();
    } catch {
      return [];
    }
  }

  async mapAt(frame) {
    this.turn += 1;
    const { turn } = this;
    const trails = new Map();
    const histories = await Promise.all(this.views.map(({ view }) => this.before(view, frame)));
    const poses = new Map(await Promise.all(this.views.map(async ({ view }) => [view.number, await this.quietLine(this.poses[view.number], Math.floor(frame / view.every))])));
    if (turn !== this.turn || this.gone) return;
    for (const history of histories) {
      const own = new Map();
      for (const line of history) {
        for (const { id, position } of line.objects) {
          if (!own.has(id)) own.set(id, []);
          own.get(id).push(position);
        }
      }
      for (const [id, points] of own) if ((trails.get(id)?.length ?? 0) < points.length) trails.set(id, points);
    }
    const seenBy = this.now.get(this.chosen)?.byCamera.keys().next().value;
    if (this.chosen === null || seenBy !== undefined) this.map.follow(seenBy ?? this.alone);
    this.map.at({ objects: this.now, trails, chosen: this.chosen, poses });
  }

  /** Loads what comes next. */
  ahead(frame, views) {
    const n = this.playing ? Math.max(1, Math.min(AHEAD, Math.floor(16 / views.length))) : 1;
    for (let next = frame + 1; next <= Math.min(frame + n, this.there - 1); next += 1) {
      for (const view of views) this.load(view, next).catch(() => {});
    }
    // Whose pixel the pointer is at is known better by the instance image, which the first picture need not wait for.
    this.known = true;
  }

  redraw() {
    this.map.draw();
    this.timeline.draw();
    this.timeline.tell();
    this.panels();
  }

  // Parts of the page.

  showViews() {
    const shown = this.shownViews();
    for (const view of this.views) view.solo(this.alone === view.number && this.views.length > 1);
    for (const view of this.views) view.soloButton.hidden = this.views.length < 2;
    this.grid.dataset.count = shown.length;
    fill(this.grid, shown.map((view) => view.node));
    this.placePill();
    this.map.look(this.alone);
    if (!this.there) this.grid.prepend(el('p', { class: 'empty', text: 'No frame has been recorded yet.' }));
  }

  showBar() {
    const labelled = this.video.views.some((view) => view.has_objects);
    const chips = OVERLAYS.map(({ name, title: text, key, layers }) => el('button', {
      type: 'button', class: 'chip', 'aria-pressed': String(this.show.has(name)), 'data-overlay': name, title: `${text} (${key})`,
      disabled: layers ? !this.maskLayer : !labelled && name !== 'lanes',
      on: { click: () => this.toggleOverlay(name) },
    }, el('kbd', { text: key }), text));
    const layerChips = Object.entries(LAYER_KEYS).sort(([a], [b]) => b - a).map(([key, layer]) => el('button', {
      type: 'button', class: 'chip', 'aria-pressed': String(this.layer === layer), 'data-layer': layer, title: `${title(layer)} in colour (${key})`,
      disabled: !this.layers.includes(layer),
      on: { click: () => this.setLayer(this.layer === layer ? 'rgb' : layer) },
    }, el('kbd', { text: key }), title(layer)));
    const others = el('select', {
      class: 'select', 'aria-label': 'Picture', title: 'Which layer is shown', on: { change: (event) => this.setLayer(event.target.value) },
    }, (this.layers.length ? this.layers : ['rgb']).map((layer) => el('option', { value: layer, text: title(layer), selected: layer === this.layer })));
    const blend = el('input', {
      type: 'range', min: '0', max: '1', step: '0.05', class: 'blend', 'aria-label': 'How much of the layer is shown over RGB', title: 'Layer over RGB',
      on: {
        input: (event) => {
          this.blend = Number(event.target.value);
          this.draw();
        },
      },
    });
    blend.value = this.blend;
    blend.hidden = this.layer === 'rgb' || !this.layers.includes('rgb');
    const focused = document.activeElement?.dataset;
    const again = focused && (focused.overlay ? `[data-overlay="${focused.overlay}"]` : focused.layer && `[data-layer="${focused.layer}"]`);
    fill(this.overlayBar, el('div', { class: 'chips' }, chips, layerChips), others);
    const pill = this.layer === 'rgb' ? null : el('div', { class: 'layer-pill' }, this.scaleOf(), blend);
    this.pill?.remove();
    this.pill = pill;
    this.placePill();
    if (again) this.overlayBar.querySelector(again)?.focus();
  }

  /** What belongs to a layer stands in the first picture. */
  placePill() {
    if (this.pill) this.shownViews()[0]?.stage.append(this.pill);
  }

  /** What the colours of a layer mean. */
  scaleOf() {
    if (this.layer === 'depth') return el('span', { class: 'color-scale' }, '2 m', el('i', { class: 'turbo' }), '200 m');
    if (this.layer === 'flow' || this.layer === 'flow_backward') return el('span', { class: 'color-scale' }, el('i', { class: 'wheel' }), 'direction, white: still');
    return el('span', { text: title(this.layer) });
  }

  showTabs() {
    const entries = [['scene', 'Scene'], ['objects', 'In view'], ['object', 'Object']];
    fill(this.tabs, entries.map(([name, text]) => el('button', {
      type: 'button', role: 'tab', 'aria-selected': String(this.tab === name), 'aria-controls': `panel-${name}`, text,
      on: {
        click: () => {
          this.tab = name;
          this.panels();
        },
      },
    })));
  }

  panels() {
    if (!this.video || this.gone) return;
    this.showTabs();
    const node = { scene: this.scenePanel, objects: this.objectList, object: this.inspector }[this.tab].node;
    const top = this.panel.scrollTop;
    if (this.panel.firstChild !== node) fill(this.panel, node);
    if (this.tab === 'scene') this.scenePanel.show({ scene: this.video.scene, line: this.line, timeline: this.counts, frame: this.frame });
    if (this.tab === 'objects') this.objectList.show({ objects: this.now ?? new Map(), chosen: this.chosen });
    if (this.tab === 'object') {
      const seen = this.views.map(({ view }) => ({ view, object: this.now?.get(this.chosen)?.byCamera.get(view.number) })).filter(({ object }) => object);
      this.inspector.show({
        id: this.chosen, seen, actor: this.actors?.get(this.chosen), appearances: this.appearances?.get(this.chosen), views: this.video.views,
        frames: this.frames, frame: this.frame, fps: this.fps, meanings: this.meanings,
      });
    }
    this.panel.scrollTop = top;
  }

  // Address and keys.

  /** The address of what is shown. */
  hash() {
    const show = [...this.show].sort();
    const usual = [...DEFAULT_SHOW].sort().join() === show.join();
    return videoHash({ video: this.number, frame: this.frame, show: usual ? null : show, layer: this.layer, object: this.chosen, camera: this.alone });
  }

  /** Keeps the address up to date, but not more often than browsers let. */
  note() {
    if (this.hashTimer) return;
    this.hashTimer = setTimeout(() => {
      this.hashTimer = null;
      if (!this.gone && location.hash !== this.hash()) history.replaceState(null, '', this.hash());
    }, 200);
  }

  async copyLink() {
    const address = location.href.split('#')[0] + this.hash();
    history.replaceState(null, '', this.hash());
    try {
      await navigator.clipboard.writeText(address);
      this.transport.copied();
    } catch {
      this.act.say(`Copy it from the address bar: ${address}`);
    }
  }

  whole() {
    if (document.fullscreenElement) document.exitFullscreen();
    else this.node.requestFullscreen?.().catch(() => {});
  }

  nextEvent(by) {
    const frames = [...new Set([...(this.counts?.events ?? []).map((event) => event.frame), ...(this.video?.scene.incidents ?? []).map((incident) => incident.begin_frame)])].sort((a, b) => a - b);
    const next = by > 0 ? frames.find((frame) => frame > this.frame) : frames.findLast((frame) => frame < this.frame);
    if (next !== undefined) this.step(next - this.frame);
  }

  nextVideo(by) {
    const open = (this.dataset.data?.videos ?? []).filter((video) => video.state === 'complete' || video.recorded !== undefined);
    const at = open.findIndex((video) => video.video === this.number);
    const next = open[at + by];
    if (at >= 0 && next) location.hash = videoHash({ video: next.video, show: [...this.show], layer: this.layer });
  }

  nextCamera() {
    if (this.views.length < 2) return;
    const next = this.alone === null ? 0 : this.alone + 1;
    this.solo(next < this.views.length ? next : null);
  }

  /** Whether a key was for it. */
  key(event) {
    if (!this.video) return false;
    const { key, target } = event;
    const onButton = target.matches?.('button, a, summary, select');
    if (key === ' ' && onButton) return false;
    if (target.matches?.('select') && key.startsWith('Arrow')) return false;
    const overlay = OVERLAYS.find((one) => one.key === key);
    if (overlay) {
      if (!this.overlayBar.querySelector(`[data-overlay=${overlay.name}]`)?.disabled) this.toggleOverlay(overlay.name);
      return true;
    }
    if (LAYER_KEYS[key]) {
      const layer = LAYER_KEYS[key];
      if (this.layers.includes(layer)) this.setLayer(this.layer === layer ? 'rgb' : layer);
      return true;
    }
    const second = Math.max(1, Math.round(this.fps));
    const acts = {
      ' ': () => this.toggle(),
      ArrowLeft: () => this.step(event.shiftKey ? -second : -1),
      ArrowRight: () => this.step(event.shiftKey ? second : 1),
      Home: () => this.step(-Infinity),
      End: () => this.step(Infinity),
      '[': () => this.transport.faster(-1),
      ']': () => this.transport.faster(1),
      e: () => this.nextEvent(1),
      E: () => this.nextEvent(-1),
      n: () => this.nextVideo(1),
      p: () => this.nextVideo(-1),
      c: () => this.nextCamera(),
      f: () => this.whole(),
      l: () => this.copyLink(),
      Escape: () => this.letGo(),
    };
    if (!acts[key]) return false;
    acts[key]();
    return true;
  }

  /** First of the object, then of the camera, then of the video. */
  letGo() {
    if (this.chosen !== null) this.choose(null);
    else if (this.alone !== null) this.solo(null);
    else this.act.toList();
  }
}

/** Every object in view once, with who sees it. */
function gather(seen) {
  const all = new Map();
  for (const { view, objects } of seen) {
    for (const object of objects ?? []) {
      if (!all.has(object.id)) all.set(object.id, { object, cameras: [], byCamera: new Map() });
      const entry = all.get(object.id);
      entry.cameras.push(letter(view));
      entry.byCamera.set(view.number, object);
    }
  }
  return all;
}
