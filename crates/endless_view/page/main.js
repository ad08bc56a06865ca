// The page: the list of videos, or one of them.

import { DatasetWatch } from './dataset.js';
import { el, fill, words } from './dom.js';
import { helpDialog } from './help.js';
import { VideoList } from './list.js';
import { listHash, readPlace } from './place.js';
import { Player } from './player.js';
import { themeButton } from './theme.js';

const main = document.getElementById('main');
const crumbs = document.getElementById('crumbs');
const live = document.getElementById('live');
const banner = document.getElementById('banner');

const dataset = new DatasetWatch();
const list = new VideoList(dataset);
let player = null;
/** The list's address, to go back to with its filters. */
let lastList = '#';

function say(text) {
  banner.textContent = text ?? '';
  banner.hidden = !text;
}

function route() {
  const place = readPlace();
  if (place.video === null) {
    player?.leave();
    player = null;
    lastList = location.hash || '#';
    if (!list.node.isConnected) fill(main, list.node);
    list.go(place.filters);
  } else if (player?.number === place.video) {
    player.go(place);
  } else {
    player?.leave();
    player = new Player(place, dataset, { say, toList: () => { location.hash = lastList; } });
    fill(main, player.node);
    scrollTo(0, 0);
    player.open();
  }
  head();
}

/** What stands above: where one is, and whether the dataset grows. */
function head() {
  const data = dataset.data;
  const name = data?.name ?? '';
  if (player) {
    const entry = data?.videos.find((video) => video.video === player.number);
    const title = entry ? `${entry.map} · ${words(entry.weather)} · ${words(entry.time_of_day)}` : `Video ${player.number}`;
    fill(crumbs, el('a', { href: lastList, text: name || 'Videos' }), el('span', { 'aria-hidden': 'true', text: '/' }),
      el('span', { class: 'here', 'aria-current': 'page', text: `${player.number} · ${title}` }));
    document.title = `${title} – ${name}`;
  } else {
    fill(crumbs, el('span', { class: 'here', 'aria-current': 'page', text: name }));
    document.title = name ? `${name} – ENDLESS` : 'ENDLESS';
  }
  if (!data) return;
  const done = data.videos.filter((video) => video.state === 'complete').length;
  const grows = done < data.videos.length;
  live.classList.toggle('grows', grows);
  live.textContent = grows ? `${done} of ${data.videos.length} complete` : '';
}

dataset.addEventListener('change', () => {
  say(dataset.error?.message);
  head();
  list.changed();
  player?.datasetChanged();
});
addEventListener('hashchange', route);

const help = helpDialog(document.getElementById('help'));
themeButton(document.getElementById('theme'), () => player?.redraw());
document.getElementById('home').addEventListener('click', (event) => {
  event.preventDefault();
  location.hash = listHash({ text: '', least: 0, map: new Set(), weather: new Set(), time: new Set(), class: new Set(), event: new Set(), state: new Set() });
});

addEventListener('keydown', (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || help.isOpen()) return;
  const target = event.target;
  if (event.key === 'Escape' && target.matches?.('input')) {
    target.blur();
    return;
  }
  const typing = target.matches?.('input:not([type=range]):not([type=checkbox]), textarea, select');
  if (typing) return;
  if (event.key === '?') help.open();
  else if (event.key === '/') {
    if (player) {
      location.hash = lastList;
      addEventListener('hashchange', () => list.search.focus(), { once: true });
    } else list.search.focus();
  } else if (!player?.key(event)) return;
  event.preventDefault();
});

// Pictures of a linked frame do not wait for the list of videos.
route();
dataset.start();
