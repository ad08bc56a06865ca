// Elements, made without any HTML text: what a dataset says is only ever shown as text.

/** An element with properties, attributes, listeners (`on`) and children. */
export function el(tag, props = {}, ...children) {
  const node = document.createElement(tag);
  for (const [key, value] of Object.entries(props)) {
    if (value === undefined || value === null || value === false) continue;
    if (key === 'on') for (const [event, listener] of Object.entries(value)) node.addEventListener(event, listener);
    else if (key === 'text') node.textContent = value;
    else if (key === 'style') for (const [name, style] of Object.entries(value)) node.style.setProperty(name, style);
    else if (key in node && key !== 'list' && key !== 'form' && !key.startsWith('aria')) {
      if (key === 'href' || key === 'role' || key === 'for') node.setAttribute(key, value);
      else node[key] = value;
    } else node.setAttribute(key === 'class' ? 'class' : key, value === true ? '' : value);
  }
  add(node, children);
  return node;
}

/** Appends texts and elements. */
export function add(node, children) {
  for (const child of children.flat(Infinity)) {
    if (child === undefined || child === null || child === false) continue;
    node.append(child);
  }
  return node;
}

/** Replaces what is inside of an element. */
export function fill(node, ...children) {
  node.replaceChildren();
  return add(node, children);
}

const PATHS = {
  play: 'M7 4.500v15l12.500-7.500z',
  pause: 'M7 5h3.500v14H7zM13.500 5H17v14h-3.500z',
  first: 'M6 5h2v14H6zM19 5v14l-10-7z',
  last: 'M16 5h2v14h-2zM5 5l10 7-10 7z',
  back: 'M15.500 5 8 12l7.500 7',
  next: 'M8.500 5 16 12l-7.500 7',
  sun: 'M12 7.500a4.500 4.500 0 1 0 0 9 4.500 4.500 0 0 0 0-9zM12 2v2.500M12 19.500V22M2 12h2.500M19.500 12H22M4.900 4.900l1.800 1.800M17.300 17.300l1.800 1.800M4.900 19.100l1.800-1.800M17.300 6.700l1.800-1.800',
  moon: 'M20 14.500A8.500 8.500 0 0 1 9.500 4a8.500 8.500 0 1 0 10.500 10.500z',
  auto: 'M12 3.500a8.500 8.500 0 1 0 0 17zM12 3.500a8.500 8.500 0 0 1 0 17',
  help: 'M9 9.200a3 3 0 1 1 4.300 2.700c-.9.500-1.300 1-1.300 2.100M12 17.200v.3',
  link: 'M10 14a4 4 0 0 0 5.700 0l3-3A4 4 0 0 0 13 5.300l-1 1M14 10a4 4 0 0 0-5.700 0l-3 3A4 4 0 0 0 11 18.700l1-1',
  expand: 'M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5',
  shrink: 'M9 4v5H4M20 9h-5V4M15 20v-5h5M4 15h5v5',
  close: 'M6 6l12 12M18 6 6 18',
  search: 'M10.500 4a6.500 6.500 0 1 0 0 13 6.500 6.500 0 0 0 0-13zM15.500 15.500 20 20',
  fit: 'M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5M9 12h6M12 9v6',
  plus: 'M12 5v14M5 12h14',
  minus: 'M5 12h14',
  camera: 'M3.500 7.500h11v9h-11zM14.500 11l6-3v8l-6-3z',
};
const FILLED = new Set(['play', 'pause', 'first', 'last']);

/** A small drawing, hidden from readers of the screen. */
export function icon(name, size = 18) {
  const space = 'http://www.w3.org/2000/svg';
  const svg = document.createElementNS(space, 'svg');
  for (const [key, value] of Object.entries({ viewBox: '0 0 24 24', width: size, height: size, 'aria-hidden': 'true' })) {
    svg.setAttribute(key, value);
  }
  const path = document.createElementNS(space, 'path');
  path.setAttribute('d', PATHS[name]);
  if (FILLED.has(name)) path.setAttribute('fill', 'currentColor');
  else {
    for (const [key, value] of Object.entries({
      fill: 'none', stroke: 'currentColor', 'stroke-width': 1.8, 'stroke-linecap': 'round', 'stroke-linejoin': 'round',
    })) path.setAttribute(key, value);
  }
  svg.append(path);
  return svg;
}

/** A word of the files as people write it: `clear_sky` is "clear sky". */
export const words = (name) => String(name).replaceAll('_', ' ');

/** A number with so many digits at most, without needless zeros. */
export function number(value, digits = 2) {
  if (!Number.isFinite(value)) return String(value);
  return value.toLocaleString('en', { maximumFractionDigits: digits, useGrouping: Math.abs(value) >= 10000 });
}

/** One or several: "1 car", "2 cars". */
export function count(n, one, several = `${one}s`) {
  return `${number(n, 0)} ${n === 1 ? one : several}`;
}

/** Seconds as 0:07.250, or 1:02:07. */
export function clock(seconds) {
  const whole = Math.floor(seconds + 1e-9);
  const [h, m, s] = [Math.floor(whole / 3600), Math.floor(whole / 60) % 60, whole % 60];
  const two = (n) => String(n).padStart(2, '0');
  const part = Math.round((seconds - whole) * 1000);
  return `${h ? `${h}:${two(m)}` : m}:${two(s)}.${String(Math.max(0, part)).padStart(3, '0')}`;
}
