import { beforeEach, describe, expect, test, vi } from 'vitest';
import { MOST_NAMED, createMessages } from './messages.ts';

beforeEach(() => void vi.useFakeTimers());

const texts = (messages: ReturnType<typeof createMessages>) => messages.list.value.map(({ text }) => text);

describe('what is grave', () => {
  test('is never pushed out, however much is said after it', () => {
    const messages = createMessages();
    messages.grave('Your work is not saved.');
    for (let i = 0; i < 100; i += 1) messages.alert(`alert ${i}`);
    for (let i = 0; i < 100; i += 1) messages.offer(`offer ${i}`, { label: 'Go', run: () => {} });
    expect(messages.list.value.length).toBeLessThan(30);
    expect(messages.list.value.find(({ kind }) => kind === 'grave')?.text).toBe('Your work is not saved.');
  });

  test('stays until it is closed, and can be told anew where it stands', () => {
    const messages = createMessages();
    const id = messages.grave('6 photos are missing.');
    messages.alert('Something else.');
    vi.advanceTimersByTime(3_600_000);
    expect(messages.change(id, '2 photos are missing.')).toBe(true);
    expect(texts(messages)).toEqual(['2 photos are missing.', 'Something else.']);
    messages.close(id);
    expect(messages.change(id, '1 photo is missing.')).toBe(false);
    expect(texts(messages)).toEqual(['Something else.']);
  });
});

test('closing what was never said closes nothing', () => {
  const messages = createMessages();
  messages.fileFailed('a.jpg', 'broken.');
  messages.close(0);
  vi.advanceTimersByTime(500);
  expect(texts(messages)).toEqual(['a.jpg: broken.']);
});

test('alerts about a repeated task disappear when it succeeds, and only they', () => {
  const messages = createMessages();
  const drawing = messages.alertGroup();
  messages.alert('Something else.');
  drawing.report('A panel could not be drawn.');
  drawing.report('A panel could not be drawn.');
  drawing.report('A panel is too large.');
  expect(texts(messages)).toEqual(['Something else.', 'A panel could not be drawn.', 'A panel is too large.']);
  drawing.clear();
  expect(texts(messages)).toEqual(['Something else.']);
  drawing.report('A panel could not be drawn.');
  expect(texts(messages)).toEqual(['Something else.', 'A panel could not be drawn.']);
});

test('where there is too much, notes go first, then what was said first', () => {
  const messages = createMessages();
  messages.note('a note');
  messages.offer('an offer', { label: 'Go', run: () => {} });
  for (let i = 0; i < 40; i += 1) messages.alert(`alert ${i}`);
  expect(texts(messages)).not.toContain('a note');
  expect(texts(messages)).not.toContain('alert 0');
  expect(texts(messages)).toContain('an offer');
  expect(texts(messages).at(-1)).toBe('alert 39');
});

describe('files that cannot be read', () => {
  test('a single one is named with the reason and what can be done', () => {
    const messages = createMessages();
    const way = { label: 'Use as a photo', run: vi.fn() };
    messages.fileFailed('a.png', 'no project.', { text: 'a.png could not be opened: no project.', way });
    expect(messages.list.value).toMatchObject([{ kind: 'alert', text: 'a.png could not be opened: no project.', way }]);
    messages.close(messages.list.value[0].id);
    messages.fileFailed('b.jpg', 'broken.');
    expect(texts(messages)).toEqual(['b.jpg: broken.']);
  });

  test('many are one message with a list of them', () => {
    const messages = createMessages();
    const told = new Set();
    messages.list.subscribe((list) => list.forEach(({ text }) => told.add(text)));
    // They arrive in any order, because several are read in parallel.
    for (const i of [3, 1, 2, 9, 8, 10, 7, 4, 5]) messages.fileFailed(`${i}.jpg`, `reason ${i}.`);
    vi.advanceTimersByTime(10_000);
    expect([...told]).toEqual(['3.jpg: reason 3.', '9 files could not be read.']);
    expect(texts(messages)).toEqual(['9 files could not be read.']);
    expect(messages.failures.value.map(({ name, why }) => `${name} ${why}`)).toEqual(
      [1, 2, 3, 4, 5, 7, 8, 9, 10].map((i) => `${i}.jpg reason ${i}.`),
    );
    const [{ id, way }] = messages.list.value;
    expect(messages.listed.value).toBe(false);
    way?.run();
    expect(messages.listed.value).toBe(true);
    expect(way?.stays).toBe(true);
    // The list disappears with its message.
    messages.close(id);
    expect([messages.listed.value, messages.failures.value]).toEqual([false, []]);
  });

  test('damaged and skipped files are part of the message', () => {
    const messages = createMessages();
    messages.filesSkipped(1);
    expect(messages.list.value.map(({ kind }) => kind)).toEqual(['note']);
    messages.fileFailed('a.jpg', 'broken.');
    messages.fileFailed('b.jpg', 'half.', { isUsed: true });
    vi.advanceTimersByTime(10_000);
    messages.filesSkipped(1);
    expect(texts(messages)).toEqual([
      '1 file could not be read. 1 file is damaged; its readable part is used. 2 files that systems and programs store next to photos were skipped.',
    ]);
    expect(messages.failures.value.map(({ name }) => name)).toEqual(['a.jpg', 'b.jpg']);
  });

  test('the message says if no file could be used, until other files are used', () => {
    const messages = createMessages();
    for (const name of ['a.jpg', 'b.jpg']) messages.fileFailed(name, 'broken.');
    messages.noneUsed(true);
    expect(texts(messages)).toEqual([expect.stringMatching(/^None of these files could be used\./)]);
    messages.noneUsed(false);
    expect(texts(messages)).toEqual(['2 files could not be read.']);
  });

  test('the same file with the same reason is one', () => {
    const messages = createMessages();
    for (let i = 0; i < 3; i += 1) messages.fileFailed('a.jpg', 'broken.');
    vi.advanceTimersByTime(10_000);
    expect(texts(messages)).toEqual(['a.jpg: broken.']);
  });

  test('those that come one after the other are told a few times, not each', () => {
    const messages = createMessages();
    const told = new Set();
    messages.list.subscribe((list) => list.forEach(({ text }) => told.add(text)));
    for (let i = 0; i < 300; i += 1) {
      messages.fileFailed(`${i}.jpg`, 'broken.');
      vi.advanceTimersByTime(20);
    }
    vi.advanceTimersByTime(10_000);
    expect(texts(messages)).toEqual(['300 files could not be read.']);
    expect(told.size).toBeLessThan(9);
  });

  test('a list has an end; those beyond it are counted', () => {
    const messages = createMessages();
    for (let i = 0; i < MOST_NAMED + 5; i += 1) messages.fileFailed(`${i}.jpg`, 'broken.');
    vi.advanceTimersByTime(10_000);
    expect(texts(messages)).toEqual([`${(MOST_NAMED + 5).toLocaleString('en')} files could not be read.`]);
    expect([messages.failures.value.length, messages.unnamed.value]).toEqual([MOST_NAMED, 5]);
  });

  test('none of them pushes out what is grave', () => {
    const messages = createMessages();
    messages.grave('Your work is not saved.');
    for (let i = 0; i < 34; i += 1) messages.fileFailed(`${i}.jpg`, 'broken.');
    vi.advanceTimersByTime(10_000);
    expect(texts(messages)).toEqual(['Your work is not saved.', '34 files could not be read.']);
  });
});
