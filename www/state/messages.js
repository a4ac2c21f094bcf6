// @ts-check
/**
 * What the page tells the person: alerts and offers stay until they are closed, notes go by themselves.
 */

import { signal } from '@preact/signals';

/** @typedef {{ label: string, run: () => void }} Way something that can be done about it */
/** @typedef {{ id: number, kind: 'alert' | 'offer' | 'note', text: string, way?: Way, more?: Way }} Message `more`: another way */
/** @typedef {ReturnType<typeof createMessages>} Messages */

const NOTE_MS = 4_000;
/** Time to find the button, and to press it. */
const WAY_MS = 12_000;
const MOST = 24;

export function createMessages() {
  /** @type {import('@preact/signals').Signal<readonly Message[]>} */
  const list = signal([]);
  let last = 0;

  /**
   * @param {Message['kind']} kind
   * @param {string} text
   * @param {Way} [way]
   * @param {Way} [more]
   * @returns {number} to close it by
   */
  function say(kind, text, way, more) {
    last += 1;
    const id = last;
    const others = list.value.filter((message) => message.text !== text && (kind !== 'note' || message.kind !== 'note'));
    list.value = [...others, { id, kind, text, way, more }].slice(-MOST);
    if (kind === 'note') setTimeout(() => close(id), way ? WAY_MS : NOTE_MS);
    return id;
  }

  /** @param {number} id */
  function close(id) {
    list.value = list.value.filter((message) => message.id !== id);
  }

  return {
    list,
    /** @param {string} text @param {Way} [way] @param {Way} [more] */
    alert: (text, way, more) => say('alert', text, way, more),
    /** @param {string} text @param {Way} [way] @param {Way} [more] */
    note: (text, way, more) => say('note', text, way, more),
    /** What can be done now or later. @param {string} text @param {Way} way */
    offer: (text, way) => say('offer', text, way),
    close,
  };
}
