// @ts-check
/** The page without a connection, after one visit. */

import { startHost } from '../web/app/site-host.js';
import { start } from './engines.js';
import { SIX, expect, personIn, plain } from './hands.js';

plain('after one visit the page works without its host', async ({}, info) => {
  const engine = String(info.project.metadata.engine);
  const host = await startHost();
  const running = await start(engine);
  try {
    const person = await personIn(running, host.address);
    await person.open();
    const kept = () =>
      person.inPage(async () => {
        if (!navigator.serviceWorker.controller) return false;
        const address = new URL('samples/19-astronaut.jpg', document.baseURI).href;
        const names = (await caches.keys()).filter((name) => name.startsWith('inkpanel /'));
        const found = await Promise.all(names.map(async (name) => (await caches.open(name)).match(address)));
        return found.some(Boolean);
      });
    await expect.poll(kept).toBe(true);
    await host.stop();
    await person.driver.get(host.address);
    await person.choose(SIX);
    await person.one('region', 'Comic page');
    await person.idle();
    await person.press('Shuffle');
    expect((await person.savedAs('png')).bytes.length).toBeGreaterThan(20_000);
  } finally {
    await running.end();
    await host.stop().catch(() => {});
  }
});
