// @ts-check
/**
 * What the page tells the person: alerts stay until they are closed, notes go by themselves.
 */

import { signal } from '@preact/signals';

/** @typedef {{ id: number, kind: 'alert' | 'note', text: string }} Message */
/** @typedef {ReturnType<typeof createMessages>} Messages */

const NOTE_MS = 4_000;
const MOST = 24;

export function createMessages() {
  /** @type {import('@preact/signals').Signal<readonly Message[]>} */
  const list = signal([]);
  let last = 0;

  /**
   * @param {Message['kind']} kind
   * @param {string} text
   */
  function say(kind, text) {
    last += 1;
    const id = last;
    const others = list.value.filter((message) => message.text !== text && (kind === 'alert' || message.kind === 'alert'));
    list.value = [...others, { id, kind, text }].slice(-MOST);
    if (kind === 'note') setTimeout(() => close(id), NOTE_MS);
  }

  /** @param {number} id */
  function close(id) {
    list.value = list.value.filter((message) => message.id !== id);
  }

  return {
    list,
    /** @param {string} text */
    alert: (text) => say('alert', text),
    /** @param {string} text */
    note: (text) => say('note', text),
    close,
  };
}
