// The dataset's list of videos, asked for again and again: it may be growing.

import { paths, tagged } from './api.js';

const WHILE_GROWING_MS = 1500;
const OTHERWISE_MS = 10000;

/** Tells listeners when the dataset changes, or cannot be read. */
export class DatasetWatch extends EventTarget {
  constructor() {
    super();
    this.data = null;
    this.error = null;
    this.tag = null;
  }

  /** Asks now, and then for ever. */
  async start() {
    await this.ask();
    const again = async () => {
      if (!document.hidden) await this.ask();
      setTimeout(again, this.growing ? WHILE_GROWING_MS : OTHERWISE_MS);
    };
    setTimeout(again, this.growing ? WHILE_GROWING_MS : OTHERWISE_MS);
    document.addEventListener('visibilitychange', () => {
      if (!document.hidden) this.ask();
    });
  }

  /** Whether there is more to come. */
  get growing() {
    return !this.data || this.data.pending > 0 || this.data.videos.some((video) => video.state !== 'complete');
  }

  async ask() {
    const before = this.error;
    try {
      const { data, tag } = await tagged(paths.dataset);
      this.error = null;
      if (tag === this.tag && !before) return;
      this.data = data;
      this.tag = tag;
    } catch (error) {
      this.error = error;
      if (before?.message === error.message) return;
    }
    this.dispatchEvent(new Event('change'));
  }
}
