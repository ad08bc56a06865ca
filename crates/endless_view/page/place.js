// Where somebody is: the part of the address behind `#`, so that a link leads to an exact frame.

const LISTS = ['map', 'weather', 'time', 'class', 'event', 'state'];

/** The place of an address. */
export function readPlace(hash = location.hash) {
  const given = new URLSearchParams(hash.replace(/^#/, ''));
  const whole = (key) => (/^\d{1,9}$/.test(given.get(key) ?? '') ? Number(given.get(key)) : null);
  const video = whole('video');
  if (video === null) {
    const filters = { text: given.get('text') ?? '', least: whole('least') ?? 0 };
    for (const key of LISTS) filters[key] = new Set((given.get(key) ?? '').split(',').filter(Boolean));
    return { video, filters };
  }
  return {
    video,
    frame: whole('frame') ?? 0,
    show: given.has('show') ? given.get('show').split(',').filter(Boolean) : null,
    layer: given.get('layer'),
    object: whole('object'),
    camera: whole('camera'),
  };
}

/** The address of a list with filters. */
export function listHash(filters) {
  const parts = new URLSearchParams();
  if (filters.text) parts.set('text', filters.text);
  if (filters.least) parts.set('least', filters.least);
  for (const key of LISTS) if (filters[key].size) parts.set(key, [...filters[key]].sort().join(','));
  return `#${parts}`.replaceAll('%2C', ',');
}

/** The address of a frame. */
export function videoHash({ video, frame = 0, show = null, layer = null, object = null, camera = null }) {
  const parts = new URLSearchParams({ video, frame });
  if (show) parts.set('show', show.join(','));
  if (layer && layer !== 'rgb') parts.set('layer', layer);
  if (object !== null) parts.set('object', object);
  if (camera !== null) parts.set('camera', camera);
  return `#${parts}`.replaceAll('%2C', ',');
}
