import { describe, expect, it } from 'vitest';
import { fakeCaches, fakeHost, shaOf } from './testing.ts';
import { NETS, PAGE_LOCK, createVersions } from './versions.ts';

const SCOPE = 'https://host.test/some/path/';
const at = (path: string) => SCOPE + path;

/** A build: the page, its script, and a module whose name changes with it. */
function build(version: string) {
  const files = {
    '': `page ${version}`,
    [`assets/index-${version}.js`]: `script ${version}`,
    'assets/core-11111111.wasm': 'core',
  };
  return {
    files: Object.fromEntries(Object.entries(files).map(([path, text]) => [at(path), text])),
    site: {
      version,
      needed: Object.entries(files).map(([path, text]) => [path, shaOf(text)] as [string, string]),
      extras: [['samples/1.jpg', shaOf('photo')]] as [string, string][],
      onUse: [`assets/faces-${version}.onnx`],
    },
  };
}

function world(
  version: string,
  {
    caches = fakeCaches(),
    files = build(version).files,
    open = [],
    updating = false,
  }: {
    caches?: ReturnType<typeof fakeCaches>;
    files?: Record<string, string>;
    open?: string[];
    updating?: boolean;
  } = {},
) {
  const host = fakeHost(files);
  const held = open.map((path) => ({ name: `${PAGE_LOCK}${at(path)}` }));
  const versions = createVersions({
    site: build(version).site,
    scope: SCOPE,
    caches,
    fetch: host.fetch as any,
    locks: { query: async () => ({ held }) },
    windows: async () => 1,
    updating: () => updating,
  });
  return { caches, host, versions };
}

const asked = (path: string, mode = 'cors') => ({ url: at(path), mode }) as any;
const text = async (response: Promise<Response>) => (await response).text();

describe('a build', () => {
  it('is kept whole, and answers without its host', async () => {
    const { caches, versions, host } = world('one');
    await versions.install();
    expect(await caches.contents()).toEqual({ 'inkpanel /some/path/ one': Object.keys(build('one').files).sort() });
    const before = host.asked.length;
    expect(await text(versions.answer('', asked('', 'navigate')))).toBe('page one');
    expect(await text(versions.answer('assets/core-11111111.wasm', asked('assets/core-11111111.wasm')))).toBe('core');
    expect(host.asked).toHaveLength(before);
  });

  it.each([
    ['is missing', { [at('assets/core-11111111.wasm')]: undefined }],
    ['is of another build', { [at('')]: 'page two' }],
  ])('of which a file %s is not kept at all', async (_, wrong) => {
    const files = { ...build('one').files, ...wrong } as Record<string, string>;
    const { caches, versions } = world('one', { files });
    await expect(versions.install()).rejects.toThrow();
    expect(await caches.contents()).toEqual({});
  });

  it('takes what is the same from the one before, whatever its name', async () => {
    const files = { ...build('one').files, [at('samples/1.jpg')]: 'photo' };
    const { caches, versions } = world('one', { files });
    await versions.install();
    await versions.keepExtras();
    const next = world('two', { caches });
    await next.versions.install();
    await next.versions.keepExtras();
    expect(next.host.asked.sort()).toEqual([at(''), at('assets/index-two.js')]);
  });

  it('never answers for the page with another build, but for a script that still asks', async () => {
    const { caches, versions } = world('one');
    await versions.install();
    const next = world('two', { caches });
    await next.versions.install();
    expect(await text(next.versions.answer('', asked('', 'navigate')))).toBe('page two');
    expect(await text(next.versions.answer('assets/index-one.js', asked('assets/index-one.js')))).toBe('script one');
    await caches.delete('inkpanel /some/path/ two');
    // A file that the browser evicted comes from the host, not from another build.
    expect(await text(next.versions.answer('', asked('', 'navigate')))).toBe('page two');
  });

  it('has the extras when they were asked for', async () => {
    const files = { ...build('one').files, [at('samples/1.jpg')]: 'photo' };
    const { versions, host } = world('one', { files });
    await versions.install();
    expect(host.asked).not.toContain(at('samples/1.jpg'));
    await versions.keepExtras();
    await versions.keepExtras();
    expect(host.asked.filter((url) => url.endsWith('1.jpg'))).toHaveLength(1);
  });

  it('knows its own addresses only', () => {
    const { versions } = world('one');
    const paths = ['', '?shared=1', 'index.html'].map((path) => versions.pathOf(asked(path, 'navigate')));
    expect(paths).toEqual(['', '', '']);
    expect(versions.pathOf({ url: 'https://host.test/other/', mode: 'navigate' } as any)).toBeNull();
    expect(['', 'samples/1.jpg', 'assets/of-before.js'].every(versions.has)).toBe(true);
    expect(['assets/faces-one.onnx', 'unknown.html', 'service-worker.js'].some(versions.has)).toBe(false);
  });
});

describe('sweeping', () => {
  /** Three builds. Two of them have models. */
  async function three() {
    const caches = fakeCaches();
    for (const version of ['one', 'two', 'three']) await world(version, { caches }).versions.install();
    const nets = await caches.open(NETS);
    for (const net of ['one', 'three']) await nets.put(at(`assets/faces-${net}.onnx`), new Response(net));
    await nets.put('https://host.test/other/assets/faces.onnx', new Response('of another site'));
    await (await caches.open('inkpanel /other/ one')).put('x', new Response('of another site'));
    return caches;
  }
  const builds = async (caches: any) =>
    (await caches.keys()).filter((name: string) => name.startsWith('inkpanel /')).sort();

  it('leaves the builds of open pages, their nets too', async () => {
    const caches = await three();
    await world('three', { caches, open: ['assets/index-two.js', 'assets/index-three.js'] }).versions.sweep();
    expect(await builds(caches)).toEqual([
      'inkpanel /other/ one',
      'inkpanel /some/path/ three',
      'inkpanel /some/path/ two',
    ]);
    expect(await (await caches.open(NETS)).keys()).toHaveLength(3);
  });

  it('leaves the newest alone when no other is open, and nets that it names', async () => {
    const caches = await three();
    await world('three', { caches, open: ['assets/index-three.js'] }).versions.sweep();
    expect(await builds(caches)).toEqual(['inkpanel /other/ one', 'inkpanel /some/path/ three']);
    expect((await caches.contents())[NETS]).toEqual([
      'https://host.test/other/assets/faces.onnx',
      at('assets/faces-three.onnx'),
    ]);
  });

  it('touches nothing while another build is on its way', async () => {
    const caches = await three();
    const before = await caches.contents();
    await world('one', { caches, updating: true }).versions.sweep();
    expect(await caches.contents()).toEqual(before);
  });
});
