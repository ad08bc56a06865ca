// Instance images: whose each pixel is.

import { ofObject } from './colors.js';

const FILL = 105;
const EDGE = 235;

/** The object of each pixel, from the layer `instance` or `panoptic`. */
export function idsOf(picture, layer) {
  const { width, height } = picture;
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext('2d', { willReadFrequently: true });
  context.drawImage(picture, 0, 0);
  const { data } = context.getImageData(0, 0, width, height);
  const ids = new Uint16Array(width * height);
  const [low, high] = layer === 'panoptic' ? [0, 1] : [1, 2];
  for (let i = 0; i < ids.length; i += 1) ids[i] = data[4 * i + low] | (data[4 * i + high] << 8);
  return { width, height, ids };
}

/** Each object in a colour of its own, with an edge, as a canvas to be drawn over the picture. */
export function tinted({ width, height, ids }, chosen) {
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext('2d');
  const image = context.createImageData(width, height);
  const colors = new Map();
  for (let y = 0, i = 0; y < height; y += 1) {
    for (let x = 0; x < width; x += 1, i += 1) {
      const id = ids[i];
      if (!id) continue;
      let color = colors.get(id);
      if (!color) colors.set(id, color = ofObject(id));
      const inside = (x === 0 || ids[i - 1] === id) && (x + 1 === width || ids[i + 1] === id)
        && (y === 0 || ids[i - width] === id) && (y + 1 === height || ids[i + width] === id);
      const strength = id === chosen ? 1.5 : 1;
      image.data.set(color, 4 * i);
      image.data[4 * i + 3] = Math.min(255, (inside ? FILL : EDGE) * strength);
    }
  }
  context.putImageData(image, 0, 0);
  return canvas;
}
