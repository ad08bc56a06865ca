// The dialog with all keys.

import { el, icon } from './dom.js';

const KEYS = [
  ['Anywhere', [['?', 'This help'], ['/', 'Search or filter videos'], ['Esc', 'Let go: object, one camera, dialog']]],
  ['Play', [
    ['Space', 'Play and pause'],
    ['← →', 'One frame back, forward'],
    ['Shift ← →', 'One second back, forward'],
    ['Home End', 'First frame, last frame'],
    ['[ ]', 'Slower, faster'],
    ['E Shift E', 'Next event, event before'],
    ['N P', 'Next video, video before'],
  ]],
  ['Show', [
    ['1', 'Boxes'], ['2', 'Ids'], ['3', 'Masks'], ['4', 'Keypoints'], ['5', '3D boxes'], ['6', 'Tracks'],
    ['7', 'Lanes'], ['8', 'Lights'], ['9', 'Depth'], ['0', 'Flow'],
  ]],
  ['Look', [
    ['C', 'One camera after the other, then all'],
    ['F', 'Whole screen'],
    ['L', 'Copy a link to this frame'],
    ['Tab', 'From part to part; Enter chooses'],
  ]],
];

/** A dialog that a button opens. */
export function helpDialog(button) {
  const close = el('button', { class: 'icon-button', type: 'button', 'aria-label': 'Close' }, icon('close'));
  const groups = KEYS.map(([title, rows]) => el('section', {},
    el('h3', { text: title }),
    el('dl', {}, rows.map(([keys, what]) => el('div', {},
      el('dt', {}, keys.split(' ').map((key) => el('kbd', { text: key }))),
      el('dd', { text: what }))))));
  const dialog = el('dialog', { class: 'help', 'aria-labelledby': 'help-title' },
    el('header', {}, el('h2', { id: 'help-title', text: 'Keys' }), close),
    el('div', { class: 'help-groups' }, groups),
    el('p', { class: 'muted', text: 'Click an object in a picture or on the map for all that is known of it. The address always leads to '
      + 'the frame that is shown.' }));
  document.body.append(dialog);
  close.addEventListener('click', () => dialog.close());
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) dialog.close();
  });
  const open = () => {
    if (!dialog.open) dialog.showModal();
  };
  button.append(icon('help'));
  button.addEventListener('click', open);
  return { open, isOpen: () => dialog.open };
}
