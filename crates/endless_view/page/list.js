// The list of videos, with filters.

import { paths } from './api.js';
import { onPage } from './colors.js';
import { count, el, fill, icon, number, words } from './dom.js';
import { FACETS, passes, stateOf, tally } from './filters.js';
import { listHash, videoHash } from './place.js';

/** Cards that are made at once; more come as one scrolls. */
const CHUNK = 48;

/** The first page. */
export class VideoList {
  constructor(dataset) {
    this.dataset = dataset;
    this.filters = null;
    this.search = el('input', {
      type: 'search', placeholder: 'Search', 'aria-label': 'Search videos by name, map, weather, time or camera',
      on: { input: () => this.change(() => { this.filters.text = this.search.value.trim(); }) },
    });
    this.least = el('input', {
      type: 'range', min: '0', max: '10', value: '0', id: 'least',
      on: { input: () => this.change(() => { this.filters.least = Number(this.least.value); }) },
    });
    this.leastText = el('output', { for: 'least' });
    this.facets = el('div', { class: 'facets' });
    this.title = el('h1', {});
    this.summary = el('p', { class: 'summary' });
    this.found = el('p', { class: 'found', role: 'status' });
    this.clear = el('button', { type: 'button', class: 'text-button', text: 'Clear filters', on: { click: () => { location.hash = '#'; } } });
    this.cards = el('ul', { class: 'cards' });
    this.more = el('div', { class: 'more' });
    const filters = el('details', { class: 'filters', open: matchMedia('(min-width: 800px)').matches },
      el('summary', { text: 'Filters' }),
      this.facets,
      el('fieldset', {}, el('legend', {}, el('label', { for: 'least', text: 'Objects at once' })),
        el('div', { class: 'range' }, this.least, this.leastText)));
    this.node = el('div', { class: 'list' },
      el('div', { class: 'list-head' }, el('div', {}, this.title, this.summary),
        el('label', { class: 'search' }, icon('search', 16), this.search, el('kbd', { text: '/' }))),
      filters,
      el('section', { class: 'results', 'aria-label': 'Videos' },
        el('div', { class: 'found-row' }, this.found, this.clear), this.cards, this.more));
    this.shown = CHUNK;
    new IntersectionObserver((entries) => {
      if (entries.some((entry) => entry.isIntersecting) && this.shown < this.wanted?.length) {
        this.shown += CHUNK;
        this.showCards();
      }
    }, { rootMargin: '600px' }).observe(this.more);
    this.known = new Map();
  }

  /** With the filters of an address. */
  go(filters) {
    this.filters = filters;
    if (document.activeElement !== this.search) this.search.value = filters.text;
    this.shown = CHUNK;
    this.changed();
  }

  change(how) {
    how();
    history.replaceState(null, '', listHash(this.filters));
    this.shown = CHUNK;
    this.changed();
  }

  /** Shows the dataset as it is now. */
  changed() {
    const data = this.dataset.data;
    if (!data || !this.filters || !this.node.isConnected) return;
    const { recipe, videos } = data;
    this.title.textContent = data.name;
    const cameras = new Set(videos.map((video) => video.cameras.length));
    fill(this.summary, [
      count(videos.length, 'video'),
      cameras.has(0) ? null : `${[...cameras].sort().join(' or ')} cameras`,
      `${recipe.size} at ${number(recipe.fps)} fps, ${number(recipe.duration)} s`,
      count(recipe.layers.length, 'layer'),
      `seed ${recipe.seed}`,
    ].filter(Boolean).join('  ·  '));
    this.showFacets(videos);
    this.wanted = videos.filter((video) => passes(video, this.filters));
    const waits = data.pending ? `, ${data.pending} still to be counted` : '';
    this.found.textContent = (this.wanted.length === videos.length
      ? `All ${count(videos.length, 'video')}` : `${this.wanted.length} of ${count(videos.length, 'video')}`) + waits;
    const filtered = Object.values(this.filters).some((value) => (value instanceof Set ? value.size : value));
    this.clear.hidden = !filtered;
    this.showCards();
  }

  showFacets(videos) {
    const focused = document.activeElement?.dataset?.value;
    const groups = FACETS.map((facet) => {
      const [key, title] = facet;
      const values = tally(videos, this.filters, facet);
      if (values.length < 2 && !this.filters[key].size) return null;
      return el('fieldset', {}, el('legend', { text: title }), el('div', { class: 'chips' }, values.map(([value, n]) => {
        const on = this.filters[key].has(value);
        const chip = el('button', {
          type: 'button', class: n ? 'chip' : 'chip none', 'aria-pressed': String(on), 'data-value': `${key}:${value}`,
          on: {
            click: () => this.change(() => {
              if (on) this.filters[key].delete(value);
              else this.filters[key].add(value);
            }),
          },
        });
        if (key === 'class') chip.append(el('i', { class: 'dot', style: { '--dot': onPage(value) } }));
        chip.append(el('span', { text: words(value) }), el('small', { text: n }));
        return chip;
      })));
    });
    fill(this.facets, groups);
    if (focused) [...this.facets.querySelectorAll('button')].find((chip) => chip.dataset.value === focused)?.focus();
    const most = Math.max(1, ...videos.map((video) => video.facts?.most_at_once ?? 0));
    this.least.max = Math.max(most, this.filters.least);
    this.least.value = this.filters.least;
    this.leastText.textContent = this.filters.least ? `at least ${this.filters.least}` : 'any';
  }

  showCards() {
    const items = this.wanted.slice(0, this.shown).map((video) => {
      const told = JSON.stringify(video);
      const known = this.known.get(video.video);
      if (known?.told === told) return known.item;
      const item = card(video, this.dataset.data.recipe);
      this.known.set(video.video, { told, item });
      return item;
    });
    // What is there already stays: a picture that is made anew flickers.
    const current = [...this.cards.children];
    if (items.length !== current.length || items.some((item, i) => item !== current[i])) this.cards.replaceChildren(...items);
    if (!items.length) {
      fill(this.more, el('p', { class: 'empty', text: 'No video passes all filters.' }));
    } else fill(this.more);
  }
}

function card(video, recipe) {
  const state = stateOf(video);
  const open = state !== 'planned';
  const badge = state === 'complete' ? null
    : el('span', { class: `badge ${state}`, text: state === 'planned' ? 'planned' : `recording ${number(video.recorded, 0)} / ${number(video.frames, 0)}` });
  const picture = el('div', { class: 'thumb' }, badge,
    el('span', { class: 'length', text: `${number(video.frames / recipe.fps, 1)} s` }));
  if (open && video.recorded !== 0) {
    // A scene that only its rig films has no cameras of its own; the rig's are counted after them.
    const pictures = [0, 1].slice(0, Math.max(1, video.cameras.length)).map((camera) => el('img', {
      alt: '', loading: 'lazy', decoding: 'async',
      on: { error: (event) => event.target.remove() },
      src: paths.thumbnail(video.video, camera),
    }));
    picture.prepend(...pictures);
  }
  const objects = Object.entries(video.facts?.objects ?? {});
  const total = objects.reduce((sum, [, n]) => sum + n, 0);
  const events = [...new Set(video.facts?.incidents ?? [])].map((kind) => el('span', { class: 'tag', text: words(kind) }));
  const body = [
    picture,
    el('div', { class: 'card-text' },
      el('h2', {}, el('span', { class: 'card-number', text: video.video }), video.map),
      el('p', { class: 'muted', text: `${words(video.weather)}, ${words(video.time_of_day)}` }),
      el('div', { class: 'mix', 'aria-hidden': 'true' }, objects.map(([name, n]) => el('i', {
        style: { '--share': n / total, '--dot': onPage(name) }, title: `${n} ${words(name)}`,
      }))),
      el('p', { class: 'card-facts' },
        video.facts ? `${count(total, 'object')}, ${video.facts.most_at_once} at once` : (state === 'complete' ? 'counting…' : `${number(video.frames, 0)} frames`),
        events)),
  ];
  return el('li', {}, open
    ? el('a', { class: 'card', href: videoHash({ video: video.video }), 'aria-label': `Video ${video.video}: ${video.map}, ${words(video.weather)}, ${words(video.time_of_day)}` }, body)
    : el('div', { class: 'card closed' }, body));
}
