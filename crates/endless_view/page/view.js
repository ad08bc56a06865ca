// One camera: its picture, what is drawn over it, and whom the pointer is at.

import { el, icon, number, words } from './dom.js';
import { idsOf, tinted } from './masks.js';
import { drawOverlays } from './overlays.js';

/** A camera of a video. */
export class CameraView {
  /** `act` is told of `choose(id)` and `solo(camera)`. */
  constructor(number_, view, act) {
    this.number = number_;
    this.view = view;
    this.picture = el('canvas', { class: 'picture', width: view.size.width, height: view.size.height });
    this.over = el('canvas', { class: 'over', role: 'img', 'aria-label': `Camera ${view.name}` });
    this.note = el('p', { class: 'view-note', hidden: true });
    this.tip = el('div', { class: 'tip', hidden: true });
    this.facts = el('span', { class: 'view-facts' });
    this.soloButton = el('button', {
      class: 'icon-button small', type: 'button', on: { click: () => act.solo(this.number) },
    });
    this.stage = el('div', { class: 'stage', style: { '--aspect': `${view.size.width} / ${view.size.height}` } },
      this.picture, this.over, this.note, this.tip);
    this.node = el('figure', { class: 'view' },
      el('figcaption', {}, el('span', { class: 'view-letter', text: letter(view) }),
        el('span', { class: 'view-name', text: words(view.name) }), this.facts, this.soloButton),
      this.stage);
    this.solo(false);
    this.objects = [];
    this.hovered = null;
    this.last = null;
    this.over.addEventListener('pointermove', (event) => this.hover(event, act));
    this.over.addEventListener('pointerleave', () => this.unhover());
    this.over.addEventListener('click', (event) => act.choose(this.at(event)?.id ?? null));
    this.over.addEventListener('dblclick', () => act.solo(this.number));
    new ResizeObserver(() => this.redraw()).observe(this.stage);
  }

  /** Shows whether it is the only camera. */
  solo(alone) {
    const text = alone ? 'Show all cameras' : 'Show this camera alone';
    this.soloButton.replaceChildren(icon(alone ? 'shrink' : 'expand', 15));
    this.soloButton.title = `${text} (C)`;
    this.soloButton.setAttribute('aria-label', text);
  }

  /** Draws a frame: all of it is there already. */
  draw(frame) {
    this.last = frame;
    this.objects = frame.objects;
    this.instance = null;
    const context = this.picture.getContext('2d');
    const { width, height } = this.picture;
    this.note.hidden = Boolean(frame.rgb || frame.layer);
    if (!frame.rgb && !frame.layer) {
      this.note.textContent = frame.missing ?? 'This picture is not there.';
      context.clearRect(0, 0, width, height);
    }
    if (frame.rgb) context.drawImage(frame.rgb, 0, 0, width, height);
    if (frame.layer) {
      context.globalAlpha = frame.rgb ? frame.blend : 1;
      context.drawImage(frame.layer, 0, 0, width, height);
      context.globalAlpha = 1;
    }
    if (frame.instance && frame.show.has('masks')) {
      context.drawImage(tinted(this.ids(), frame.chosen), 0, 0, width, height);
    }
    const n = this.objects.length;
    this.facts.textContent = frame.labelled ? `${n} ${n === 1 ? 'object' : 'objects'}` : '';
    this.redraw();
  }

  /** Draws what lies over the picture again: another size, another object. */
  redraw() {
    if (!this.last) return;
    const ratio = devicePixelRatio || 1;
    const [width, height] = [Math.round(this.stage.clientWidth * ratio), Math.round(this.stage.clientHeight * ratio)];
    if (!width || !height) return;
    if (this.over.width !== width || this.over.height !== height) Object.assign(this.over, { width, height });
    drawOverlays(this.over, { ...this.last, size: this.view.size, ratio, hovered: this.hovered?.id });
  }

  ids() {
    this.instance ??= this.last.instance && idsOf(this.last.instance, this.last.instanceLayer);
    return this.instance;
  }

  /** The object at the pointer: by its pixels where they are known, else the smallest box. */
  at(event) {
    const [x, y] = this.place(event);
    const reach = 4 * this.view.size.width / Math.max(1, this.stage.clientWidth);
    const inside = this.objects.filter(({ bbox: [left, top, w, h] }) => x >= left - reach && x < left + w + reach
      && y >= top - reach && y < top + h + reach);
    if (!inside.length) return null;
    const ids = this.last?.instance && this.ids();
    const id = ids && ids.ids[Math.floor(y) * ids.width + Math.floor(x)];
    const area = ({ bbox }) => bbox[2] * bbox[3];
    return inside.find((object) => object.id === id) ?? inside.sort((a, b) => area(a) - area(b))[0];
  }

  place(event) {
    const { left, top, width, height } = this.over.getBoundingClientRect();
    const { size } = this.view;
    return [(event.clientX - left) / width * size.width, (event.clientY - top) / height * size.height];
  }

  hover(event) {
    if (event.pointerType === 'touch') return;
    const object = this.at(event);
    this.over.style.cursor = object ? 'pointer' : 'default';
    if (object?.id !== this.hovered?.id) {
      this.hovered = object;
      this.redraw();
    }
    this.tip.hidden = !object;
    if (!object) return;
    const facts = [`${words(object.class)} ${object.id}`];
    if (object.parked) facts.push('parked');
    else facts.push(`${number(object.speed_mps * 3.6, 0)} km/h`);
    if (object.distance_m !== undefined) facts.push(`${number(object.distance_m, 0)} m away`);
    if (object.visibility < 0.995) facts.push(`${number(100 * object.visibility, 0)} % visible`);
    this.tip.textContent = facts.join(' · ');
    const { left, top, width } = this.stage.getBoundingClientRect();
    const x = event.clientX - left;
    this.tip.style.setProperty('--x', `${Math.min(x, width - 10)}px`);
    this.tip.style.setProperty('--y', `${event.clientY - top}px`);
    this.tip.classList.toggle('leftwards', x > width * 0.6);
  }

  unhover() {
    this.tip.hidden = true;
    if (!this.hovered) return;
    this.hovered = null;
    this.redraw();
  }
}

/** The letter of a camera's folder; those of a rig have none. */
export function letter(view) {
  return view.of_rig ? 'rig' : view.folder.replace('camera_', '').toUpperCase();
}
