// @ts-check
/**
 * A sample Node program that uses the package and prints its results as JSON. Run `node node.js` in a project with the
 * package.
 */

import { readFile, writeFile } from 'node:fs/promises';
import { createEngine, createProject, openProject } from 'inkpanel';

const blobOf = async (/** @type {string} */ name) => new Blob([/** @type {any} */ (await readFile(name))]);
const engine = createEngine({ workers: 2 });
const files = await Promise.all(['one.jpg', 'two.jpg'].map(blobOf));
const chosen = (await engine.select(files)).map(({ group, kept }) => ({ group, kept }));
const labels = (await engine.detect(files[1])).map(({ label }) => label);

const pixels = new Uint8ClampedArray(await readFile('pixels.rgba'));
const [width, height] = JSON.parse(await readFile('size.json', 'utf8'));
const styled = await engine.stylize({ width, height, data: pixels, style: 'comic' });
await writeFile('styled.rgba', styled.data);

const project = createProject(await engine.ready);
project.addPhotos(await Promise.all(files.map((file, i) => engine.importPhoto(`photo-${i}`, file))));
project.edit({
  type: 'change-settings',
  settings: { ...project.project().settings, width: 840, height: 1188, dpi: 100 },
  page: null,
});
const first = project.shuffle({ seed: 7, style: 'comic', panels: 2 });
const second = project.shuffle({ seed: 8 });
project.undo();
const undone = JSON.stringify(project.project().page) === JSON.stringify(first) && first !== second;
const saved = createProject(await engine.ready, JSON.parse(JSON.stringify(project.history())));
saved.redo();
const redone = JSON.stringify(saved.project().page) === JSON.stringify(second);

const page = { .../** @type {any} */ (first), words: [{ kind: 'caption', text: 'Meanwhile, in Node', panel: 0 }] };
const plain = await engine.compose(/** @type {any} */ (first), { width: 420 });
const lettered = await engine.compose(page, { width: 420 });
const outs = {
  'page.png': await engine.exportPng(page),
  'page.pdf': await engine.exportPdf([page], { quality: 90 }),
  'page.jpg': await engine.exportJpeg(page, { quality: 90 }),
  'page.webp': await engine.exportWebp(page, { quality: 90 }),
};
for (const [name, blob] of Object.entries(outs)) await writeFile(name, Buffer.from(await blob.arrayBuffer()));

const opened = await openProject(engine, await blobOf('album.inkpanel'));
for (const [i, document] of opened.pages.entries())
  await writeFile(`album-${i + 1}.png`, Buffer.from(await (await engine.exportPng(document)).arrayBuffer()));
const code = (/** @type {Promise<any>} */ promise) =>
  promise.then(
    () => 'done',
    (error) => error.code,
  );
const codes = [
  await code(openProject(engine, files[0])),
  await code(engine.importPhoto('none', new Blob(['no picture']))),
  await code(engine.stylize({ width: 1, height: 1, data: new Uint8Array(4), style: 'no-such-style' })),
];
engine.dispose();
console.log(
  JSON.stringify({
    chosen,
    labels,
    undone,
    redone,
    changed: plain.data.reduce((count, value, i) => count + Number(value !== lettered.data[i]), 0),
    pages: opened.pages.length,
    lost: opened.lost,
    codes,
  }),
);
