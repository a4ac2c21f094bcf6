/** Views that are loaded when they are first shown. */

import { useEffect, useState } from 'preact/hooks';
import { onceMore } from '../engine/once-more.ts';
import { strings } from '../strings/strings.ts';
import { useApp } from './context.ts';
import type { ComponentType, VNode } from 'preact';
import type { App } from './context.ts';

export type LazyView = ComponentType & { preload: () => Promise<unknown> };

/**
 * @param options `instead` is shown until the view is loaded. `missing`: the message if it cannot be loaded; then `close`
 *   is called, and the next attempt loads it again
 */
export function lazy(
  load: () => Promise<ComponentType>,
  {
    instead = null,
    missing = strings.partMissing,
    close,
  }: { instead?: VNode | null; missing?: string; close: (app: App) => void },
): LazyView {
  let loaded: ComponentType | null = null;
  const { get: preload } = onceMore(async () => {
    loaded = await load();
  });

  function Lazy() {
    const app = useApp();
    const [View, setView] = useState(() => loaded);
    useEffect(() => {
      if (View) return;
      preload().then(
        () => setView(() => loaded),
        () => {
          close(app);
          app.messages.alert(missing);
        },
      );
    }, []);
    return View ? <View /> : instead;
  }
  return Object.assign(Lazy, { preload });
}

/** A workspace; see `lazy`. */
export function lazyWorkspace(load: () => Promise<ComponentType>, missing?: string): LazyView {
  const close = ({ ui }: App) => void (ui.work.value = null);
  return lazy(load, { instead: <main class="workspace" aria-busy="true" />, missing, close });
}

/** A dialog; see `lazy`. */
export function lazyDialog(load: () => Promise<ComponentType>): LazyView {
  return lazy(load, { close: ({ ui }) => void (ui.dialog.value = null) });
}
