import { describe, expect, it, vi } from 'vitest';
import { createArrivals } from '../../app/arrivals.ts';
import { createShares } from './shares.ts';
import { fakeCaches } from './testing.ts';

const SCOPE = 'https://host.test/some/path/';

function posted(...files: File[]) {
  const body = new FormData();
  for (const file of files) body.append('files', file);
  body.append('title', 'words that come with it');
  return new Request(`${SCOPE}share`, { method: 'POST', body });
}

function page(href: string, caches: CacheStorage) {
  const [intake, alert, replaceState] = [vi.fn(), vi.fn(), vi.fn()];
  const window = { location: { href }, history: { replaceState }, document: { baseURI: SCOPE }, caches } as any;
  createArrivals({ window, intake, messages: { alert } }).begin();
  return { intake, alert, replaceState, window };
}

describe('a share', () => {
  const photo = new File(['JFIF'], 'Grüße, 1.jpg', { type: 'image/jpeg' });

  it('comes to the page that is opened for it, once', async () => {
    const caches = fakeCaches();
    const answer = await createShares({ scope: SCOPE, caches }).take(
      posted(photo, new File(['mp4'], 'b.mp4', { type: 'video/mp4' })),
    );
    expect(answer.status).toBe(303);
    const address = String(answer.headers.get('location'));
    const { intake, replaceState } = page(address, caches);
    await vi.waitFor(() => expect(intake).toHaveBeenCalled());
    const [[files]] = intake.mock.calls;
    expect(files.map(({ name, type }: File) => [name, type])).toEqual([
      ['Grüße, 1.jpg', 'image/jpeg'],
      ['b.mp4', 'video/mp4'],
    ]);
    expect(await files[0].text()).toBe('JFIF');
    expect(String(replaceState.mock.calls[0][2])).toBe(SCOPE);
    await vi.waitFor(async () => expect(await caches.contents()).toEqual({ 'inkpanel-shared': [] }));
    const again = page(address, caches);
    await new Promise((done) => {
      setTimeout(done, 5);
    });
    expect(again.intake).not.toHaveBeenCalled();
  });

  it('that could not be stored is told', async () => {
    const caches = {
      open: async () => {
        throw new Error('QuotaExceededError');
      },
    } as any;
    const answer = await createShares({ scope: SCOPE, caches }).take(posted(photo));
    const { intake, alert } = page(String(answer.headers.get('location')), caches);
    await vi.waitFor(() => expect(alert).toHaveBeenCalledWith(expect.stringContaining('did not arrive')));
    expect(intake).not.toHaveBeenCalled();
  });

  it('that nobody came for is thrown away after a day', async () => {
    const caches = fakeCaches();
    let time = 1_800_000_000_000;
    const shares = createShares({ scope: SCOPE, caches, now: () => time });
    await shares.take(posted(photo));
    await shares.sweep();
    expect((await caches.contents())['inkpanel-shared']).toHaveLength(1);
    time += 25 * 3600_000;
    await shares.sweep();
    expect((await caches.contents())['inkpanel-shared']).toEqual([]);
  });
});

it('a file that the system opens with the page is taken in, and one that cannot be read is named', async () => {
  const { intake, alert, window } = page(SCOPE, fakeCaches());
  let launch: (launch: { files?: any[] }) => void = () => {};
  window.launchQueue = {
    setConsumer: (consumer: any) => {
      launch = consumer;
    },
  };
  createArrivals({ window, intake, messages: { alert } }).begin();
  launch({});
  const file = new File(['x'], 'a.png');
  launch({
    files: [
      { name: 'a.png', getFile: async () => file },
      {
        name: 'gone.png',
        getFile: async () => {
          throw new Error('gone');
        },
      },
    ],
  });
  await vi.waitFor(() => expect(intake).toHaveBeenCalledWith([file]));
  expect(intake).toHaveBeenCalledTimes(1);
  expect(alert).toHaveBeenCalledWith(expect.stringContaining('gone.png'));
});
