// Lines of objects and of frames, asked for in pieces.

import { json } from './api.js';

const PIECE = 16;
const MOST_PIECES = 96;

/** Lines of one file by their number. */
export class Lines {
  /** `path(from, count)` tells where to ask. */
  constructor(path) {
    this.path = path;
    this.pieces = new Map();
  }

  /** A line; nothing where the file has no such line. */
  async line(number) {
    const piece = Math.floor(number / PIECE);
    return (await this.piece(piece))[number - piece * PIECE] ?? null;
  }

  /** Lines from one to another, both included. */
  async range(from, to) {
    const lines = [];
    for (let piece = Math.floor(from / PIECE); piece <= Math.floor(to / PIECE); piece += 1) lines.push(this.piece(piece));
    const all = (await Promise.all(lines)).flat();
    const first = Math.floor(from / PIECE) * PIECE;
    return all.slice(from - first, to - first + 1);
  }

  piece(number) {
    const known = this.pieces.get(number);
    if (known) return known;
    const lines = json(this.path(number * PIECE, PIECE));
    lines.catch(() => this.pieces.delete(number));
    this.pieces.set(number, lines);
    if (this.pieces.size > MOST_PIECES) this.pieces.delete(this.pieces.keys().next().value);
    return lines;
  }
}
