// Counts over time: how many objects of each class the cameras see, and what happens.

import { onPage, themeColor } from './colors.js';
import { el, fill, words } from './dom.js';

/** Height of the strip of events, and how many of them are dots. */
const EVENTS = 16;
const MOST_DOTS = 120;
const GRAVE = new Set(['collision', 'near_miss', 'red_light_run']);

/** A chart that can be dragged along. */
export class Timeline {
  constructor(seek) {
    this.seek = seek;
    this.canvas = el('canvas', { class: 'chart', role: 'img', 'aria-label': 'Objects seen over time' });
    this.legend = el('div', { class: 'legend' });
    this.tip = el('div', { class: 'tip chart-tip', hidden: true });
    this.box = el('div', { class: 'chart-box' }, this.canvas, this.tip);
    this.node = el('section', { class: 'timeline', 'aria-label': 'Counts over time' }, this.legend, this.box);
    this.data = null;
    this.frames = 1;
    this.frame = 0;
    this.there = 0;
    this.note = 'Counting…';
    new ResizeObserver(() => this.draw()).observe(this.box);
    const drag = (event) => {
      if (event.buttons & 1) this.seek(this.frameAt(event));
    };
    this.canvas.addEventListener('pointerdown', (event) => {
      this.canvas.setPointerCapture(event.pointerId);
      drag(event);
    });
    this.canvas.addEventListener('pointermove', (event) => {
      drag(event);
      this.hover(event);
    });
    this.canvas.addEventListener('pointerleave', () => { this.tip.hidden = true; });
  }

  /** With what was counted; nothing yet is null. */
  set({ data, frames, there, incidents, note }) {
    Object.assign(this, { data, frames, there, incidents: incidents ?? [], note });
    this.draw();
    this.tell();
  }

  at(frame) {
    this.frame = frame;
    this.draw();
    this.tell();
  }

  /** Numbers of the frame. */
  tell() {
    const { data, frame } = this;
    if (!data) {
      fill(this.legend, el('span', { class: 'muted', text: this.note ?? '' }));
      return;
    }
    const total = data.counts.reduce((sum, row) => sum + (row[frame] ?? 0), 0);
    fill(this.legend, el('strong', { text: `${total} in view` }), data.classes.map((name, i) => el('span', { class: 'legend-item' },
      el('i', { class: 'dot', style: { '--dot': onPage(name) } }), el('span', { text: words(name) }),
      el('b', { text: data.counts[i][frame] ?? 0 }))));
  }

  frameAt(event) {
    const { left, width } = this.canvas.getBoundingClientRect();
    const share = Math.max(0, Math.min(1, (event.clientX - left) / width));
    return Math.max(0, Math.min(this.frames - 1, Math.floor(share * this.frames)));
  }

  hover(event) {
    if (event.pointerType === 'touch') return;
    const frame = this.frameAt(event);
    const { left, width } = this.box.getBoundingClientRect();
    const lines = [`frame ${frame}`];
    if (this.data) {
      const total = this.data.counts.reduce((sum, row) => sum + (row[frame] ?? 0), 0);
      lines.push(`${total} in view`);
      const near = Math.max(0, this.frames / width * 4);
      for (const event_ of this.data.events) {
        if (Math.abs(event_.frame - frame) <= near) lines.push(`${words(event_.kind)} ${event_.ids.join(', ')}`);
      }
    }
    this.tip.hidden = false;
    this.tip.textContent = lines.slice(0, 4).join(' · ');
    const x = event.clientX - left;
    this.tip.style.setProperty('--x', `${x}px`);
    this.tip.classList.toggle('leftwards', x > width * 0.6);
  }

  draw() {
    const ratio = devicePixelRatio || 1;
    const { clientWidth: width, clientHeight: height } = this.box;
    if (!width || !height) return;
    const [w, h] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (this.canvas.width !== w || this.canvas.height !== h) Object.assign(this.canvas, { width: w, height: h });
    const colors = { line: themeColor('--line'), text: themeColor('--muted'), ink: themeColor('--text'), alarm: themeColor('--alarm') };
    const x = (frame) => frame / this.frames * width;
    // What is the same in every frame is drawn once.
    const same = [w, h, this.data, this.incidents, this.there, this.frames, ...Object.values(colors)];
    if (!this.plate || same.some((value, i) => value !== this.plate.same[i])) {
      const canvas = new OffscreenCanvas(w, h);
      const pen = { context: canvas.getContext('2d'), width, height, x, colors };
      pen.context.scale(ratio, ratio);
      this.shadeMissing(pen);
      this.drawCounts(pen);
      this.drawEvents(pen);
      this.plate = { canvas, same };
    }
    const context = this.canvas.getContext('2d');
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, w, h);
    context.drawImage(this.plate.canvas, 0, 0);
    context.scale(ratio, ratio);
    this.drawHead({ context, height, x, colors });
  }

  shadeMissing({ context, width, height, x, colors }) {
    if (this.there >= this.frames) return;
    context.fillStyle = colors.line;
    context.globalAlpha = 0.5;
    context.fillRect(x(this.there), EVENTS, width - x(this.there), height - EVENTS);
    context.globalAlpha = 1;
  }

  drawCounts({ context, width, height, x, colors }) {
    const base = height - 1;
    context.strokeStyle = colors.line;
    context.lineWidth = 1;
    context.beginPath();
    context.moveTo(0, base + 0.5);
    context.lineTo(width, base + 0.5);
    context.stroke();
    if (!this.data) return;
    const { counts, classes } = this.data;
    const known = counts[0]?.length ?? 0;
    let most = 1;
    for (let i = 0; i < known; i += 1) most = Math.max(most, counts.reduce((sum, row) => sum + row[i], 0));
    // Of a long video each column shows one of its frames.
    const step = Math.max(1, Math.floor(known / width / 2));
    const lower = new Float64Array(known);
    const y = (n) => base - (n / most) * (base - EVENTS - 6);
    for (const [c, row] of counts.entries()) {
      context.beginPath();
      for (let i = 0; i < known; i += step) {
        const top = y(lower[i] + row[i]);
        context.lineTo(x(i), top);
        context.lineTo(x(Math.min(i + step, known)), top);
      }
      for (let i = Math.floor((known - 1) / step) * step; i >= 0; i -= step) {
        const bottom = y(lower[i]);
        context.lineTo(x(Math.min(i + step, known)), bottom);
        context.lineTo(x(i), bottom);
      }
      context.closePath();
      context.fillStyle = onPage(classes[c]);
      context.globalAlpha = 0.5;
      context.fill();
      context.globalAlpha = 1;
      context.beginPath();
      for (let i = 0; i < known; i += step) {
        const top = y(lower[i] + row[i]);
        context.lineTo(x(i), top);
        context.lineTo(x(Math.min(i + step, known)), top);
      }
      context.strokeStyle = onPage(classes[c]);
      context.lineWidth = 1.4;
      context.stroke();
      for (let i = 0; i < known; i += 1) lower[i] += row[i];
    }
    context.fillStyle = colors.text;
    context.font = '10px system-ui, sans-serif';
    context.textBaseline = 'top';
    context.fillText(`${most}`, 2, EVENTS - 3);
  }

  drawEvents({ context, height, x, colors }) {
    for (const { begin_frame, end_frame } of this.incidents ?? []) {
      context.fillStyle = colors.alarm;
      context.globalAlpha = 0.18;
      context.fillRect(x(begin_frame), 0, Math.max(3, x(end_frame + 1) - x(begin_frame)), height);
      context.globalAlpha = 1;
    }
    const events = this.data?.events ?? [];
    for (const { frame, kind } of events) {
      const grave = GRAVE.has(kind);
      context.fillStyle = grave ? colors.alarm : colors.text;
      if (events.length > MOST_DOTS) {
        // Dots would run into one another: strokes, so that one sees where there are many.
        context.globalAlpha = grave ? 0.6 : 0.25;
        context.fillRect(x(frame), grave ? 1 : 5, 1, grave ? 10 : 6);
        context.globalAlpha = 1;
        continue;
      }
      context.beginPath();
      context.arc(x(frame + 0.5), 6, grave ? 3.4 : 2.4, 0, 7);
      context.fill();
    }
  }

  drawHead({ context, height, x, colors }) {
    const at = x(this.frame + 0.5);
    context.strokeStyle = colors.ink;
    context.lineWidth = 1.5;
    context.beginPath();
    context.moveTo(at, 0);
    context.lineTo(at, height);
    context.stroke();
    context.fillStyle = colors.ink;
    context.beginPath();
    context.moveTo(at - 5, 0);
    context.lineTo(at + 5, 0);
    context.lineTo(at, 7);
    context.fill();
  }
}
