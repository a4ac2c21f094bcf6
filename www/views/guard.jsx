// @ts-check
/** Where the views cannot draw what is in the store: then there is something else in their place, until there is another project. */

import { Component } from 'preact';
import { useApp } from './context.js';

/** @param {{ children: import('preact').ComponentChildren, instead: import('preact').ComponentChildren }} props */
export function Guard({ children, instead }) {
  const { ui, keeping } = useApp();
  const onFailed = (/** @type {unknown} */ error) => {
    ui.failed.value = error;
    keeping.failedToShow(error);
  };
  return <Catcher failed={ui.failed.value !== null} onFailed={onFailed} instead={instead}>{children}</Catcher>;
}

/**
 * @typedef {{ failed: boolean, onFailed: (error: unknown) => void, children: import('preact').ComponentChildren, instead: import('preact').ComponentChildren }} Caught
 * @extends {Component<Caught, { tries: number }>}
 */
class Catcher extends Component {
  /** @param {unknown} error */
  componentDidCatch(error) {
    const { failed, onFailed } = /** @type {Caught} */ (this.props);
    // What stands in their place must not fail.
    if (failed) throw error;
    onFailed(error);
    this.setState({});
  }

  render() {
    const { failed, children, instead } = /** @type {Caught} */ (this.props);
    return failed ? instead : children;
  }
}

/**
 * Waits until the views have drawn what is in the store now.
 * @param {import('../state/ui.js').Ui} ui
 * @returns {Promise<void>} rejects with what they threw
 */
export async function drawn(ui) {
  await new Promise((resolve) => {
    // A tab in the background draws no frames; its views are made all the same.
    const patience = setTimeout(resolve, PATIENCE);
    requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(() => {
      clearTimeout(patience);
      resolve(undefined);
    })));
  });
  const error = ui.failed.peek();
  if (error !== null) throw error;
}

/** Milliseconds. */
const PATIENCE = 150;
