import { signal } from '@preact/signals';
import { describe, expect, it, vi } from 'vitest';
import { createMessages } from '../ui/messages.ts';
import { eagerScheduler } from '../engine/testing.ts';
import { createOffline } from './offline.ts';

const settle = () =>
  new Promise((done) => {
    setTimeout(done, 15);
  });

function app({
  controlled = true,
  waits = true,
  safe = true,
  refused = false,
}: {
  controlled?: boolean;
  waits?: boolean;
  safe?: boolean;
  refused?: boolean;
} = {}) {
  const workers = new EventTarget() as any;
  const waiting = { postMessage: vi.fn(() => workers.dispatchEvent(new Event('controllerchange'))) };
  const active = { postMessage: vi.fn() };
  const registration = Object.assign(new EventTarget(), { waiting: waits ? waiting : null, active });
  Object.assign(workers, {
    controller: controlled ? active : null,
    ready: Promise.resolve(registration),
    register: vi.fn(async () => {
      if (refused) throw new Error('refused');
      return registration;
    }),
  });
  const document = Object.assign(new EventTarget(), { baseURI: 'https://host.test/', visibilityState: 'visible' });
  const window = { navigator: { serviceWorker: workers }, document, location: { reload: vi.fn() } } as any;
  const busy = signal(true);
  const messages = createMessages();
  const keeping = { flush: vi.fn(async () => {}), isSafe: () => safe, files: { save: vi.fn() } };
  createOffline({ window, messages, keeping, script: 'x', busy: () => busy.value, scheduler: eagerScheduler() });
  return { workers, waiting, active, registration, window, busy, messages, keeping };
}

describe('a page without a connection', () => {
  it('fetches nothing until it is at rest', async () => {
    const { workers, active, busy } = app();
    await settle();
    expect(workers.register).not.toHaveBeenCalled();
    busy.value = false;
    await settle();
    expect(workers.register).toHaveBeenCalledTimes(1);
    expect(active.postMessage).toHaveBeenCalledWith({ op: 'settle', extras: true });
    busy.value = true;
    busy.value = false;
    await settle();
    expect(workers.register).toHaveBeenCalledTimes(1);
  });

  it('offers a new version until it is taken, and saves the work first', async () => {
    const { waiting, window, busy, messages, keeping } = app();
    busy.value = false;
    await settle();
    messages.note('something else');
    const [offer] = messages.list.value;
    expect(offer).toMatchObject({ kind: 'offer', text: 'A new version is ready.' });
    expect(waiting.postMessage).not.toHaveBeenCalled();
    offer.way?.run();
    await settle();
    expect(keeping.flush).toHaveBeenCalled();
    expect(waiting.postMessage).toHaveBeenCalledWith({ op: 'take-over' });
    expect(window.location.reload).toHaveBeenCalledTimes(1);
  });

  it('does not lose what is not saved', async () => {
    const { waiting, window, busy, messages } = app({ safe: false });
    busy.value = false;
    await settle();
    messages.list.value[0].way?.run();
    await settle();
    expect(waiting.postMessage).not.toHaveBeenCalled();
    expect(window.location.reload).not.toHaveBeenCalled();
    expect(messages.list.value.map(({ kind }) => kind)).toEqual(['alert', 'offer']);
  });

  it('hears of a version that comes while it is open, but of none on a first visit', async () => {
    for (const controlled of [true, false]) {
      const { registration, busy, messages } = app({ controlled, waits: false });
      busy.value = false;
      await settle();
      const installing = new EventTarget();
      Object.assign(registration, { installing });
      registration.dispatchEvent(new Event('updatefound'));
      Object.assign(registration, { waiting: installing });
      installing.dispatchEvent(new Event('statechange'));
      expect(messages.list.value).toHaveLength(controlled ? 1 : 0);
    }
  });

  it('goes on in silence where workers are refused or unknown', async () => {
    const { busy, messages } = app({ refused: true });
    busy.value = false;
    await settle();
    expect(messages.list.value).toEqual([]);
    createOffline({ window: { navigator: {}, document: {} } } as any);
  });
});
