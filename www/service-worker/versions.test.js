// @ts-check
import { describe, expect, it } from 'vitest';
import { fakeCaches, fakeHost, shaOf } from './testing.js';
import { NETS, PAGE_LOCK, createVersions } from './versions.js';

const SCOPE = 'https://host.test/some/path/';
const at = (/** @type {string} */ path) => SCOPE + path;

/** A build: the page, its script, and a module whose name changes with it. @param {string} version */
function build(version) {
  const files = { '': `page ${version}`, [`assets/index-${version}.js`]: `script ${version}`, 'assets/core-11111111.wasm': 'core' };
  return {
    files: Object.fromEntries(Object.entries(files).map(([path, text]) => [at(path), text])),
    site: {
      version, needed: Object.entries(files).map(([path, text]) => /** @type {[string, string]} */ ([path, shaOf(text)])),
      extras: /** @type {[string, string][]} */ ([['samples/1.jpg', shaOf('photo')]]), onUse: [`assets/faces-${version}.onnx`],
    },
  };
}

/**
 * @param {string} version
 * @param {{ caches?: ReturnType<typeof fakeCaches>, files?: Record<string, string>, open?: string[], updating?: boolean }} [more]
 */
function world(version, { caches = fakeCaches(), files = build(version).files, open = [], updating = false } = {}) {
  const host = fakeHost(files);
  const held = open.map((path) => ({ name: `${PAGE_LOCK}${at(path)}` }));
  const versions = createVersions({
    site: build(version).site, scope: SCOPE, caches, fetch: /** @type {any} */ (host.fetch), locks: { query: async () => ({ held }) },
    windows: async () => 1, updating: () => updating,
  });
  return { caches, host, versions };
}

const asked = (/** @type {string} */ path, mode = 'cors') => /** @type {any} */ ({ url: at(path), mode });
const text = async (/** @type {Promise<Response>} */ response) => (await response).text();

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
    ['is missing', { [at('assets/core-11111111.wasm')]: undefined }], ['is of another build', { [at('')]: 'page two' }],
  ])('of which a file %s is not kept at all', async (_, wrong) => {
    const files = /** @type {Record<string, string>} */ ({ ...build('one').files, ...wrong });
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
    // What the browser threw away comes from the host, not from another build.
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
    expect(versions.pathOf(/** @type {any} */ ({ url: 'https://host.test/other/', mode: 'navigate' }))).toBeNull();
    expect(['', 'samples/1.jpg', 'assets/of-before.js'].every(versions.has)).toBe(true);
    expect(['assets/faces-one.onnx', 'unknown.html', 'service-worker.js'].some(versions.has)).toBe(false);
  });
});

describe('sweeping', () => {
  /** Three builds, and nets of two of them. */
  async function three() {
    const caches = fakeCaches();
    for (const version of ['one', 'two', 'three']) await world(version, { caches }).versions.install();
    const nets = await caches.open(NETS);
    for (const net of ['one', 'three']) await nets.put(at(`assets/faces-${net}.onnx`), new Response(net));
    await nets.put('https://host.test/other/assets/faces.onnx', new Response('of another site'));
    await (await caches.open('inkpanel /other/ one')).put('x', new Response('of another site'));
    return caches;
  }
  const builds = async (/** @type {any} */ caches) => (await caches.keys()).filter((/** @type {string} */ name) => name.startsWith('inkpanel /')).sort();

  it('leaves the builds of open pages, their nets too', async () => {
    const caches = await three();
    await world('three', { caches, open: ['assets/index-two.js', 'assets/index-three.js'] }).versions.sweep();
    expect(await builds(caches)).toEqual(['inkpanel /other/ one', 'inkpanel /some/path/ three', 'inkpanel /some/path/ two']);
    expect(await (await caches.open(NETS)).keys()).toHaveLength(3);
  });

  it('leaves the newest alone when no other is open, and nets that it names', async () => {
    const caches = await three();
    await world('three', { caches, open: ['assets/index-three.js'] }).versions.sweep();
    expect(await builds(caches)).toEqual(['inkpanel /other/ one', 'inkpanel /some/path/ three']);
    expect((await caches.contents())[NETS]).toEqual(['https://host.test/other/assets/faces.onnx', at('assets/faces-three.onnx')]);
  });

  it('touches nothing while another build is on its way', async () => {
    const caches = await three();
    const before = await caches.contents();
    await world('one', { caches, updating: true }).versions.sweep();
    expect(await caches.contents()).toEqual(before);
  });
});
