// Play, step, slide.

import { clock, el, fill, icon, number } from './dom.js';

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4];

/** The row of buttons and the slider under the pictures. */
export class Transport {
  /** `act` is told of `toggle()`, `step(n)`, `seek(frame)`, `link()`, `whole()`. */
  constructor(act) {
    this.speed = 1;
    const button = (name, label, keys, click) => el('button', {
      class: 'icon-button', type: 'button', 'aria-label': label, title: `${label} (${keys})`, on: { click },
    }, icon(name));
    const edge = (...what) => {
      const node = button(...what);
      node.classList.add('edge');
      return node;
    };
    this.play = button('play', 'Play', 'Space', () => act.toggle());
    this.play.classList.add('play');
    this.slider = el('input', {
      type: 'range', class: 'slider', min: '0', max: '0', step: '1', value: '0', 'aria-label': 'Frame',
      on: { input: () => act.seek(Number(this.slider.value)) },
    });
    this.time = el('span', { class: 'time' });
    this.frameBox = el('input', {
      class: 'frame-box', inputMode: 'numeric', 'aria-label': 'Go to frame', title: 'Go to frame', size: 6,
      on: {
        change: () => {
          const frame = Number(this.frameBox.value);
          if (Number.isInteger(frame)) act.seek(frame);
        },
        keydown: (event) => {
          if (event.key === 'Enter') this.frameBox.blur();
        },
        focus: () => this.frameBox.select(),
      },
    });
    this.of = el('span', { class: 'muted' });
    this.speedButton = el('select', {
      class: 'select', 'aria-label': 'Speed', title: 'Speed ([ and ])',
      on: { change: () => { this.speed = Number(this.speedButton.value); } },
    }, SPEEDS.map((speed) => el('option', { value: String(speed), text: `${speed}×`, selected: speed === 1 })));
    this.linkButton = button('link', 'Copy a link to this frame', 'L', () => act.link());
    this.node = el('div', { class: 'transport' },
      el('div', { class: 'buttons' },
        edge('first', 'First frame', 'Home', () => act.seek(0)),
        button('back', 'One frame back', '←', () => act.step(-1)),
        this.play,
        button('next', 'One frame forward', '→', () => act.step(1)),
        edge('last', 'Last frame', 'End', () => act.seek(Infinity))),
      this.slider,
      el('div', { class: 'frame-at' }, this.frameBox, this.of, this.time),
      el('div', { class: 'buttons' }, this.speedButton, this.linkButton, button('expand', 'Whole screen', 'F', () => act.whole())));
  }

  /** Shows where the video is. */
  set({ frame, there, frames, fps, playing }) {
    this.slider.max = Math.max(0, there - 1);
    this.slider.value = frame;
    this.slider.style.setProperty('--done', `${there > 1 ? 100 * frame / (there - 1) : 0}%`);
    this.slider.setAttribute('aria-valuetext', `frame ${frame}, ${clock(frame / fps)}`);
    if (document.activeElement !== this.frameBox) this.frameBox.value = frame;
    this.of.textContent = there === frames ? `/ ${number(frames - 1, 0)}` : `/ ${number(Math.max(0, there - 1), 0)} so far`;
    this.time.textContent = clock(frame / fps);
    if (this.playing !== playing) {
      this.playing = playing;
      fill(this.play, icon(playing ? 'pause' : 'play', 20));
      this.play.setAttribute('aria-label', playing ? 'Pause' : 'Play');
    }
  }

  /** One speed slower or faster. */
  faster(by) {
    const at = Math.max(0, Math.min(SPEEDS.length - 1, SPEEDS.indexOf(this.speed) + by));
    this.speed = SPEEDS[at];
    this.speedButton.value = String(this.speed);
  }

  copied() {
    this.linkButton.classList.add('done');
    setTimeout(() => this.linkButton.classList.remove('done'), 900);
  }
}
