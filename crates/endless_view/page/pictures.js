// Pictures of a video, decoded and kept as long as there is room.

import { blob, paths } from './api.js';

const MOST_BYTES = 400 << 20;
/** As stored: values must come out as they went in. */
const EXACT = { premultiplyAlpha: 'none', colorSpaceConversion: 'none' };

/** Loads pictures by camera, layer and frame. */
export class Pictures {
  constructor(video) {
    this.video = video;
    this.known = new Map();
    this.bytes = 0;
    this.gone = new AbortController();
  }

  /** A layer for people: in colour where its values are no colours. */
  shown(camera, layer, frame) {
    const inColor = layer !== 'rgb' && layer !== 'albedo' && layer !== 'shadow';
    const path = inColor ? paths.inColor : paths.stored;
    return this.load(`${camera}/${layer}/${frame}`, path(this.video, camera, layer, frame), {});
  }

  /** A layer as it is stored. */
  stored(camera, layer, frame) {
    return this.load(`${camera}/${layer}/${frame}/exact`, paths.stored(this.video, camera, layer, frame), EXACT);
  }

  load(key, path, options) {
    const known = this.known.get(key);
    if (known) {
      // Asked for last, forgotten last.
      this.known.delete(key);
      this.known.set(key, known);
      return known.picture;
    }
    const entry = { bytes: 0 };
    entry.picture = blob(path, this.gone.signal).then((data) => createImageBitmap(data, options)).then((picture) => {
      entry.bytes = 4 * picture.width * picture.height;
      this.bytes += entry.bytes;
      this.forget();
      return picture;
    });
    // What failed may be there the next time: the video may be growing.
    entry.picture.catch(() => this.known.delete(key));
    this.known.set(key, entry);
    return entry.picture;
  }

  /** Lets go of what was asked for longest ago. It is not closed: somebody may be drawing it. */
  forget() {
    for (const [key, entry] of this.known) {
      if (this.bytes <= MOST_BYTES || this.known.size < 24) return;
      if (!entry.bytes) continue;
      this.known.delete(key);
      this.bytes -= entry.bytes;
    }
  }

  leave() {
    this.gone.abort();
    for (const entry of this.known.values()) entry.picture.then((picture) => picture.close(), () => {});
    this.known.clear();
  }
}
