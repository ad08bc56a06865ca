// Light, dark, or as the system has it.

import { fill, icon } from './dom.js';

const CHOICES = [['auto', 'auto', 'as the system'], ['light', 'sun', 'light'], ['dark', 'moon', 'dark']];

function remembered() {
  try {
    return localStorage.getItem('endless-theme');
  } catch {
    return null;
  }
}

/** Lets a button go through the themes; `changed` is told of each. */
export function themeButton(button, changed) {
  let at = Math.max(0, CHOICES.findIndex(([name]) => name === remembered()));
  const show = () => {
    const [name, drawing, text] = CHOICES[at];
    document.documentElement.dataset.theme = name;
    fill(button, icon(drawing));
    button.title = `Theme: ${text}`;
    button.setAttribute('aria-label', `Theme: ${text}. Change`);
  };
  button.addEventListener('click', () => {
    at = (at + 1) % CHOICES.length;
    show();
    try {
      localStorage.setItem('endless-theme', CHOICES[at][0]);
    } catch {
      // It is forgotten with the page.
    }
    changed();
  });
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', changed);
  show();
}
