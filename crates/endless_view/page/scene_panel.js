// The scene at a frame: weather, light, signals, what happens; and a list of all objects in view.

import { onPage } from './colors.js';
import { el, fill, number, words } from './dom.js';

const MOST_EVENTS = 60;

/** The panel of the scene. */
export class ScenePanel {
  /** `act` is told of `seek(frame)` and `choose(id)`. */
  constructor(act) {
    this.act = act;
    this.node = el('div', { class: 'panel-body', id: 'panel-scene', role: 'tabpanel', 'aria-label': 'Scene' });
  }

  show({ scene, line, timeline, frame }) {
    const parts = [];
    const incidents = scene?.incidents ?? [];
    if (incidents.length) {
      parts.push(el('section', {}, el('h3', { text: 'Staged' }), incidents.map((incident) => el('p', { class: 'incident' },
        el('button', { type: 'button', class: 'link', text: words(incident.kind), on: { click: () => this.act.seek(incident.begin_frame) } }),
        ` frames ${incident.begin_frame}–${incident.end_frame}, objects `, this.ids(incident.actors)))));
    }
    if (scene?.missed_events?.length) parts.push(el('p', { class: 'muted', text: `Could not be staged: ${scene.missed_events.map(words).join(', ')}` }));
    if (line) {
      const { weather, light } = line;
      parts.push(facts('Weather', [
        ['weather', words(weather.name)], ['cloudiness', `${number(weather.cloudiness, 0)} %`], ['precipitation', `${number(weather.precipitation, 0)} %`],
        ['wetness', `${number(weather.wetness, 0)} %`], ['puddles', `${number(weather.precipitation_deposits, 0)} %`], ['visibility', `${number(weather.visibility_m / 1000, 1)} km`],
      ]));
      parts.push(facts('Light', [
        ['time of day', words(light.time_of_day)], ['sun', light.sun.up ? `${number(degrees(light.sun.altitude_rad), 0)}° high` : 'below the horizon'],
        ['street lamps', light.street_lamps_on ? 'on' : 'off'], ['headlights', light.headlights_on ? 'on' : 'off'],
      ]));
    }
    if (timeline?.events.length) parts.push(this.events(timeline.events, frame));
    if (line?.signals?.length) parts.push(this.signals(line.signals));
    if (line) parts.push(this.happening(line));
    if (!parts.length) parts.push(el('p', { class: 'empty', text: 'Nothing is told of the scene yet.' }));
    fill(this.node, parts);
  }

  ids(ids) {
    return ids.map((id, i) => [i ? ', ' : '', el('button', { type: 'button', class: 'link', text: id, on: { click: () => this.act.choose(id) } })]);
  }

  signals(signals) {
    return el('section', {}, el('h3', { text: 'Signals' }), el('div', { class: 'signals' }, signals.map(({ id, aspect, remaining_s, next }) => el('span', {
      class: 'signal', title: next ? `${words(next)} in ${number(remaining_s, 1)} s` : undefined,
    }, el('i', { class: `lamp ${aspect}` }), `${id} ${words(aspect)}`, remaining_s === undefined ? '' : el('small', { text: ` ${number(remaining_s, 0)} s` })))));
  }

  happening(line) {
    const told = (line.relations ?? []).slice(0, 60);
    if (!told.length) return null;
    const sentence = (relation) => {
      const who = this.ids([relation.id]);
      const { kind } = relation;
      if (kind === 'follows') return [who, ' follows ', this.ids([relation.leader]), ` at ${number(relation.gap_m, 1)} m`];
      if (kind === 'rides') return [who, ' rides ', this.ids([relation.vehicle])];
      if (kind === 'waits_at') return [who, ` waits at signal ${relation.signal}`];
      if (kind === 'crosses') return [who, ` crosses on crossing ${relation.crossing}`];
      if (kind === 'yields_to') return [who, ' yields to ', this.ids([relation.person])];
      return [who, ` ${words(kind)}`];
    };
    return el('details', { class: 'group' }, el('summary', { text: `Relations (${line.relations.length})` }),
      el('ul', { class: 'plain' }, told.map((relation) => el('li', {}, sentence(relation)))));
  }

  events(events, frame) {
    // Of very many those around the frame.
    const at = events.findIndex((event) => event.frame >= frame);
    const first = Math.max(0, Math.min((at < 0 ? events.length : at) - MOST_EVENTS / 2, events.length - MOST_EVENTS));
    const near = events.slice(first, first + MOST_EVENTS);
    const left = events.length - near.length;
    return el('section', {}, el('h3', { text: 'What happens' }), el('ol', { class: 'events' }, near.map((event) => el('li', { class: event.frame === frame ? 'now' : '' },
      el('button', { type: 'button', class: 'link frame-link', text: event.frame, title: `Go to frame ${event.frame}`, on: { click: () => this.act.seek(event.frame) } }),
      el('span', { text: words(event.kind) }), el('span', {}, this.ids(event.ids))))),
    left ? el('p', { class: 'muted', text: `${number(left, 0)} more at other times` }) : null);
  }
}

/** All objects in view, for the keyboard and for readers of the screen. */
export class ObjectList {
  constructor(act) {
    this.act = act;
    this.node = el('div', { class: 'panel-body', id: 'panel-objects', role: 'tabpanel', 'aria-label': 'Objects in view' });
  }

  show({ objects, chosen }) {
    const rows = [...objects.values()].sort((a, b) => a.object.id - b.object.id);
    if (!rows.length) {
      fill(this.node, el('p', { class: 'empty', text: 'No objects are in view.' }));
      return;
    }
    fill(this.node, el('ul', { class: 'objects' }, rows.map(({ object, cameras }) => el('li', {}, el('button', {
      type: 'button', 'aria-pressed': String(object.id === chosen), on: { click: () => this.act.choose(object.id) },
    }, el('i', { class: 'dot', style: { '--dot': onPage(object.class) } }), el('span', { class: 'object-name', text: `${words(object.class)} ${object.id}` }),
    el('span', { class: 'muted', text: object.parked ? 'parked' : `${number(object.speed_mps * 3.6, 0)} km/h` }),
    el('span', { class: 'seen-by', text: cameras.join(' ') }))))));
  }
}

const degrees = (radians) => radians * 180 / Math.PI;

function facts(title, rows) {
  return el('section', {}, el('h3', { text: title }), el('dl', { class: 'facts-list' }, rows.map(([name, value]) => el('div', {},
    el('dt', { text: name }), el('dd', { text: value })))));
}
