// All that is known of an object: now, always, and where else it is seen.

import { onPage } from './colors.js';
import { clock, count, el, fill, icon, number, words } from './dom.js';
import { letter } from './view.js';

/** Told in the head of the panel, or in the pictures. */
const LEFT_OUT = new Set(['id', 'class', 'amodal_mask']);

/** The panel of one object. */
export class Inspector {
  /** `act` is told of `seek(frame)`, `choose(id)`, `picture(camera, frame)`. */
  constructor(act) {
    this.act = act;
    this.node = el('div', { class: 'panel-body', id: 'panel-object', role: 'tabpanel', 'aria-label': 'Object' });
    this.open = new Set();
  }

  /** `seen` are its records of this frame by camera. */
  show({ id, seen, actor, appearances, views, frames, frame, fps, meanings }) {
    if (id === null) {
      fill(this.node, el('p', { class: 'empty', text: 'Click an object in a picture, on the map or in the list of objects.' }));
      return;
    }
    this.meanings = meanings;
    const record = seen[0]?.object;
    const name = record?.class ?? actor?.class ?? appearances?.class ?? 'object';
    fill(this.node,
      el('header', { class: 'object-head' },
        el('i', { class: 'dot big', style: { '--dot': onPage(name) } }),
        el('h2', { text: `${words(name)} ${id}` }),
        el('button', { type: 'button', class: 'icon-button small', 'aria-label': 'Let go', title: 'Let go (Esc)', on: { click: () => this.act.choose(null) } }, icon('close', 15))),
      this.looks(actor),
      record ? el('p', { class: 'facts' }, this.facts(record)) : el('p', { class: 'muted', text: 'No camera sees it at this frame.' }),
      this.appearances(id, appearances, views, frames, frame, fps),
      seen.map(({ view, object }, i) => this.group(`At this frame, camera ${letter(view)}`, `now-${i ? 'other' : 'first'}`, this.table(object), i === 0)),
      actor ? this.group('In the whole video', 'actor', this.table(actor), true) : null);
  }

  looks(actor) {
    if (!actor) return null;
    const { vehicle, person } = actor;
    const color = vehicle?.color ?? person?.garments?.at(-1)?.color;
    const told = vehicle
      ? [vehicle.color?.name, words(vehicle.subclass ?? ''), vehicle.model]
      : [person?.age_group, person?.sex, person?.outfit && `${words(person.outfit)} clothes`, ...(person?.carries ?? []).map((thing) => words(thing.piece))];
    const text = told.filter(Boolean).join(', ');
    return text ? el('p', { class: 'looks' }, color ? swatch(color.rgb) : null, text) : null;
  }

  facts(object) {
    const facts = [];
    if (object.parked) facts.push('parked');
    else if (object.speed_mps !== undefined) facts.push(`${number(object.speed_mps * 3.6, 1)} km/h`);
    if (object.distance_m !== undefined) facts.push(`${number(object.distance_m, 1)} m away`);
    if (object.visibility !== undefined) facts.push(`${number(object.visibility * 100, 0)} % visible`);
    for (const key of ['action', 'turning', 'indicating', 'parking']) if (object[key]) facts.push(`${key === 'action' ? '' : `${key} `}${words(object[key])}`);
    if (object.stopped) facts.push('stopped');
    return facts.join(' · ');
  }

  appearances(id, appearances, views, frames, frame, fps) {
    if (!appearances) return null;
    return el('section', { class: 'appearances' }, el('h3', { text: 'Seen by' }), appearances.cameras.map((seen) => {
      const view = views[seen.camera];
      if (!view) return null;
      const crop = el('canvas', { class: 'crop', width: 1, height: 1 });
      this.crop(crop, seen, view);
      const spans = seen.ranges.slice(0, 400).map(([from, to]) => el('i', {
        style: { '--from': `${100 * from / frames}%`, '--width': `${100 * Math.max(1, to + 1 - from) / frames}%` },
      }));
      const links = seen.ranges.slice(0, 6).map(([from, to]) => el('button', {
        type: 'button', class: 'link', text: from === to ? `${from}` : `${from}–${to}`, title: `Go to frame ${from}, ${clock(from / fps)}`,
        on: { click: () => this.act.seek(from) },
      }));
      return el('div', { class: 'appearance' },
        el('button', {
          type: 'button', class: 'crop-button', title: `Best seen at frame ${seen.best.frame}`, 'aria-label': `Go to frame ${seen.best.frame}, where camera ${letter(view)} sees it best`,
          on: { click: () => this.act.seek(seen.best.frame) },
        }, crop),
        el('div', { class: 'appearance-text' },
          el('div', {}, el('span', { class: 'view-letter', text: letter(view) }), ` ${words(view.name)}`, el('span', { class: 'muted', text: `  ${count(seen.boxes, 'frame')}` })),
          el('div', { class: 'spans', style: { '--at': `${100 * (frame + 0.5) / frames}%` } }, spans),
          el('div', { class: 'links' }, links, seen.ranges.length > 6 ? el('span', { class: 'muted', text: `and ${seen.ranges.length - 6} more` }) : null)));
    }));
  }

  /** The part of the picture where it is seen best. */
  async crop(canvas, seen, view) {
    const [x, y, w, h] = seen.best.bbox;
    try {
      const picture = await this.act.picture(seen.camera, seen.best.frame);
      // A square that stays inside of the picture.
      const side = Math.min(Math.max(w, h) * 1.25, picture.width, picture.height);
      const [cx, cy] = [[x + w / 2, picture.width], [y + h / 2, picture.height]].map(([middle, length]) => Math.max(side / 2, Math.min(length - side / 2, middle)));
      canvas.width = 112;
      canvas.height = 112;
      const context = canvas.getContext('2d');
      context.imageSmoothingQuality = 'high';
      context.drawImage(picture, cx - side / 2, cy - side / 2, side, side, 0, 0, 112, 112);
    } catch {
      canvas.closest('button')?.classList.add('none');
    }
    canvas.title = view.name;
  }

  group(title, key, table, byDefault) {
    const known = this.open.has(key) || (byDefault && !this.open.has(`-${key}`));
    return el('details', {
      class: 'group', open: known,
      on: {
        toggle: (event) => {
          this.open.delete(key);
          this.open.delete(`-${key}`);
          this.open.add(event.target.open ? key : `-${key}`);
        },
      },
    }, el('summary', { text: title }), table);
  }

  table(record) {
    const rows = [];
    const walk = (value, name) => {
      if (LEFT_OUT.has(name)) return;
      const isColor = value && typeof value === 'object' && Array.isArray(value.rgb);
      if (value && typeof value === 'object' && !Array.isArray(value) && !isColor) {
        for (const [key, inner] of Object.entries(value)) walk(inner, name ? `${name}.${key}` : key);
      } else if (Array.isArray(value) && value.length && typeof value[0] === 'object' && !Array.isArray(value[0]) && value[0] !== null) {
        value.forEach((inner, i) => walk(inner, `${name}[${i}]`));
      } else rows.push([name, value]);
    };
    walk(record, '');
    return el('dl', { class: 'table' }, rows.map(([name, value]) => el('div', { title: this.meanings?.get(name) ?? this.meanings?.get(name.split(/[.[]/)[0]) },
      el('dt', { text: name }), el('dd', {}, this.value(name, value)))));
  }

  value(name, value) {
    if (value === null) return '–';
    if (typeof value === 'number' && /(^|[._])(id|rider_id|vehicle_id)$/.test(name) && value > 0) {
      return el('button', { type: 'button', class: 'link', text: value, on: { click: () => this.act.choose(value) } });
    }
    if (typeof value === 'number') return number(value, 4);
    if (typeof value === 'boolean') return value ? 'yes' : 'no';
    if (Array.isArray(value)) return list(value);
    if (typeof value === 'object') return [swatch(value.rgb), value.name ?? value.rgb.join(' ')];
    return name.startsWith('reid') || name.includes('identity') ? String(value) : words(value);
  }
}

/** A small square of a surface's colour. */
function swatch([r, g, b]) {
  return el('i', { class: 'swatch', style: { '--dot': `rgb(${Number(r)} ${Number(g)} ${Number(b)})` } });
}

function list(values) {
  if (!values.length) return 'none';
  const told = values.map((value) => {
    if (value === null) return '–';
    if (Array.isArray(value)) return `(${value.map((inner) => number(inner, 2)).join(' ')})`;
    return typeof value === 'number' ? number(value, 3) : words(value);
  });
  if (told.length <= 6) return told.join(', ');
  return el('details', { class: 'long' }, el('summary', { text: `${told.length} values` }), told.join(', '));
}
