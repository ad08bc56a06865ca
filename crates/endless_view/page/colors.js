// Colours of classes and of objects: on pictures, and on the page in its light or dark theme.

const CLASSES = {
  car: ['#58c4ff', '#0a7cc4'],
  van: ['#7c9dff', '#3b5bd6'],
  truck: ['#c79bff', '#8348cf'],
  bus: ['#ffb454', '#b86a00'],
  motorcycle: ['#ff6fae', '#c92a72'],
  bicycle: ['#ff8f8f', '#c93f3f'],
  rider: ['#ffe066', '#8f7400'],
  pedestrian: ['#7ee787', '#1c8a36'],
};
const OTHER = ['#c8d0da', '#5b6472'];

/** The colour of a class on pictures, which are dark or colourful. */
export const onPicture = (name) => (CLASSES[name] ?? OTHER)[0];

/** The colour of a class on the page. */
export const onPage = (name) => (CLASSES[name] ?? OTHER)[isDark() ? 0 : 1];

/** Whether the page is dark at this time. */
export function isDark() {
  const chosen = document.documentElement.dataset.theme;
  if (chosen === 'dark' || chosen === 'light') return chosen === 'dark';
  return matchMedia('(prefers-color-scheme: dark)').matches;
}

/** A bright colour of an object's own: neighbours in number are far apart in hue. */
export function ofObject(id) {
  const hue = (id * 137.508) % 360;
  const light = 0.56 + 0.1 * ((id * 7) % 3 - 1);
  return rgbOfHue(hue, 0.85, light);
}

function rgbOfHue(hue, saturation, light) {
  const reach = saturation * Math.min(light, 1 - light);
  const channel = (n) => {
    const k = (n + hue / 30) % 12;
    return Math.round(255 * (light - reach * Math.max(-1, Math.min(k - 3, 9 - k, 1))));
  };
  return [channel(0), channel(8), channel(4)];
}

/** A colour of the page by the name of its variable, as a canvas takes it. */
export function themeColor(name) {
  const probe = document.getElementById('probe') ?? document.body.appendChild(document.createElement('i'));
  probe.id = 'probe';
  probe.hidden = true;
  probe.style.color = `var(${name})`;
  return getComputedStyle(probe).color;
}
