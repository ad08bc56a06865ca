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
  // Red is the lowest byte of a pixel; the id is in the two channels from this one on.
  const shift = layer === 'panoptic' ? 0 : 8;
  const pixels = new Uint32Array(data.buffer);
  for (let i = 0; i < ids.length; i += 1) ids[i] = pixels[i] >>> shift;
  return { width, height, ids };
}

/** Each object in a colour of its own, with an edge, as a canvas to be drawn over the picture. */
export function tinted({ width, height, ids }, chosen) {
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext('2d');
  const image = context.createImageData(width, height);
  const pixels = new Uint32Array(image.data.buffer);
  const colors = new Map();
  const colorsOf = (id) => {
    const [r, g, b] = ofObject(id);
    const strength = id === chosen ? 1.5 : 1;
    const packed = (alpha) => ((Math.min(255, alpha * strength) << 24) | (b << 16) | (g << 8) | r) >>> 0;
    return [packed(FILL), packed(EDGE)];
  };
  for (let y = 0, i = 0; y < height; y += 1) {
    for (let x = 0; x < width; x += 1, i += 1) {
      const id = ids[i];
      if (!id) continue;
      let color = colors.get(id);
      if (!color) colors.set(id, color = colorsOf(id));
      const inside = (x === 0 || ids[i - 1] === id) && (x + 1 === width || ids[i + 1] === id)
        && (y === 0 || ids[i - width] === id) && (y + 1 === height || ids[i + width] === id);
      pixels[i] = color[inside ? 0 : 1];
    }
  }
  context.putImageData(image, 0, 0);
  return canvas;
}
