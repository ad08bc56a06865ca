// Which videos are wanted.

import { words } from './dom.js';

/** State as people see it: a video that is planned may have been begun. */
export function stateOf(video) {
  if (video.state === 'complete') return 'complete';
  return video.recorded === undefined ? 'planned' : 'recording';
}

const eventsOf = (video) => [
  ...(video.facts?.incidents ?? []).map((kind) => `staged ${words(kind)}`),
  ...Object.keys(video.facts?.events ?? {}).map(words),
];

/** What can be chosen: key, title, and the values of a video. */
export const FACETS = [
  ['map', 'Map', (video) => [video.map]],
  ['weather', 'Weather', (video) => [video.weather]],
  ['time', 'Time of day', (video) => [video.time_of_day]],
  ['class', 'Class seen', (video) => Object.keys(video.facts?.objects ?? {})],
  ['event', 'Event', eventsOf],
  ['state', 'State', (video) => [stateOf(video)]],
];

const inText = (video, text) => {
  const told = [video.name, video.map, video.weather, video.time_of_day, ...video.cameras].join(' ').toLowerCase();
  return text.toLowerCase().split(/\s+/).every((word) => told.includes(word) || words(told).includes(word));
};

/** Whether a video passes all filters but one. */
export function passes(video, filters, except = null) {
  if (filters.text && !inText(video, filters.text)) return false;
  if (except !== 'least' && filters.least && (video.facts?.most_at_once ?? 0) < filters.least) return false;
  return FACETS.every(([key, , values]) => {
    if (key === except || !filters[key].size) return true;
    return values(video).some((value) => filters[key].has(value));
  });
}

/** How many videos each value of a facet would leave. */
export function tally(videos, filters, [key, , values]) {
  const counts = new Map();
  for (const video of videos) {
    const counted = passes(video, filters, key) ? 1 : 0;
    for (const value of new Set(values(video))) counts.set(value, (counts.get(value) ?? 0) + counted);
  }
  for (const value of filters[key]) if (!counts.has(value)) counts.set(value, 0);
  return [...counts].sort(([a], [b]) => (a < b ? -1 : 1));
}
