import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { foldersOf } from '../photos/folders.ts';
import { acceptFiles } from './drop.ts';

/** An element that text can be typed into, or not. */
class FakeElement extends EventTarget {
  constructor(private readonly editable: boolean) {
    super();
  }
  closest() {
    return null;
  }
  matches(selector: string) {
    return selector === ':read-write' && this.editable;
  }
}

beforeEach(() => vi.stubGlobal('Element', FakeElement));
afterEach(() => vi.unstubAllGlobals());

const gone = () => new DOMException('A requested file could not be found.', 'NotFoundError');

/** @param path of the entry, with a slash in front */
const file = (path: string, error?: Error) => ({
  isFile: true,
  isDirectory: false,
  name: path.split('/').at(-1),
  fullPath: path,
  file: (resolve: (file: File) => void, reject: (error: Error) => void) =>
    error ? reject(error) : resolve(new File(['x'], path.split('/').at(-1) as string)),
});

/** @param reads the result of each call of the reader, or its error */
const folder = (path: string, ...reads: (object[] | Error)[]) => ({
  isFile: false,
  isDirectory: true,
  name: path.split('/').at(-1),
  fullPath: path,
  createReader: () => ({
    readEntries: (resolve: (entries: object[]) => void, reject: (error: Error) => void) => {
      const next = reads.shift() ?? [];
      if (next instanceof Error) reject(next);
      else resolve(next);
    },
  }),
});

function app() {
  const window = new EventTarget();
  const [accept, imitate, unread] = [vi.fn(), vi.fn(), vi.fn()];
  acceptFiles(window as Window, { accept, imitate, unread });
  /** Fires an event at the window, as it bubbles up from an element. */
  const fire = (type: string, dataTransfer: object, { target = new FakeElement(false), taken = false } = {}) => {
    const event = Object.assign(new Event(type, { cancelable: true }), { dataTransfer, altKey: false });
    Object.defineProperty(event, 'target', { value: target });
    if (taken) event.preventDefault();
    window.dispatchEvent(event);
    return event;
  };
  const drop = async (...entries: (object | null)[]) => {
    const loose = entries.map((entry, i) => (entry === null ? new File(['x'], `loose-${i}`) : null));
    const items = entries.map((entry, i) => ({ webkitGetAsEntry: () => entry, getAsFile: () => loose[i] }));
    fire('drop', { types: ['Files'], files: loose.filter(Boolean), items });
    await vi.waitFor(() => expect(accept.mock.calls.length + unread.mock.calls.length).toBeGreaterThan(0));
    return ((accept.mock.calls[0]?.[0] ?? []) as File[]).map((taken) => [...foldersOf(taken), taken.name].join('/'));
  };
  return { window, accept, unread, fire, drop };
}

describe('a folder that is dropped', () => {
  test('comes with the files of its folders, in order', async () => {
    const { drop, unread } = app();
    const inner = folder('/trip/day 2', [file('/trip/day 2/c.jpg')]);
    const entries = folder('/trip', [file('/trip/a.jpg'), inner], [file('/trip/b.jpg')]);
    expect(await drop(entries, file('/d.jpg'))).toEqual(['trip/a.jpg', 'trip/day 2/c.jpg', 'trip/b.jpg', 'd.jpg']);
    expect(unread).not.toHaveBeenCalled();
  });

  test('comes without an entry that cannot be read, which is named', async () => {
    const { drop, unread } = app();
    const entries = folder('/trip', [file('/trip/a.jpg'), file('/trip/gone.jpg', gone()), file('/trip/b.jpg')]);
    expect(await drop(entries)).toEqual(['trip/a.jpg', 'trip/b.jpg']);
    expect(unread.mock.calls).toEqual([['trip/gone.jpg', expect.objectContaining({ code: 'unreadable-entry' })]]);
  });

  test('of which reading fails midway comes with what was read, and so do the others', async () => {
    const { drop, unread } = app();
    const inner = folder('/trip/half', [file('/trip/half/b.jpg')], gone());
    const entries = folder('/trip', [file('/trip/a.jpg'), inner, file('/trip/c.jpg')]);
    expect(await drop(entries, folder('/lost', gone()))).toEqual(['trip/a.jpg', 'trip/half/b.jpg', 'trip/c.jpg']);
    expect(unread.mock.calls.map(([name, { code }]) => [name, code]).sort()).toEqual([
      ['lost', 'unreadable-folder'],
      ['trip/half', 'unreadable-folder'],
    ]);
  });

  test('does not take away a file next to it that has no entry', async () => {
    const { drop } = app();
    expect(await drop(folder('/trip', [file('/trip/a.jpg')]), null)).toEqual(['trip/a.jpg', 'loose-1']);
  });
});

test('files that are pasted are taken', () => {
  const { window, accept } = app();
  const files = [new File(['x'], 'a.png')];
  window.dispatchEvent(Object.assign(new Event('paste'), { clipboardData: { files } }));
  expect(accept.mock.calls).toEqual([[files]]);
});

describe('a link or a text that is dropped', () => {
  const link = () => ({ types: ['text/uri-list', 'text/plain'], files: [], items: [], dropEffect: 'copy' });

  test('does not make the browser leave the app', () => {
    const { fire, accept } = app();
    const transfer = link();
    expect(fire('dragover', transfer).defaultPrevented).toBe(true);
    expect(transfer.dropEffect).toBe('none');
    expect(fire('drop', link()).defaultPrevented).toBe(true);
    expect(accept).not.toHaveBeenCalled();
  });

  test('can be dropped on a field', () => {
    const { fire } = app();
    for (const type of ['dragover', 'drop'])
      expect(fire(type, link(), { target: new FakeElement(true) }).defaultPrevented).toBe(false);
  });

  test('is left alone where a part of the app takes it', () => {
    const transfer = link();
    app().fire('dragover', transfer, { taken: true });
    expect(transfer.dropEffect).toBe('copy');
  });
});
