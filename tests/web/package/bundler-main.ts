/** A sample project with a bundler: a page of one photo, an undo, and the custom element. */

import { createEngine, createProject, type PhotoMeta } from 'inkpanel';
import 'inkpanel/element';

const engine = createEngine({ workers: 1 });
const photo: Blob = await (await fetch('photo.jpg')).blob();
const meta: PhotoMeta = await engine.importPhoto('photo', photo);
const project = createProject(await engine.ready);
project.addPhotos([meta]);
const { settings } = project.project();
project.edit({ type: 'change-settings', settings: { ...settings, width: 840, height: 1188, dpi: 100 }, page: null });
const page = project.shuffle({ seed: 1 });
if (!page) throw new Error('there is a photo');
const drawn = await engine.compose(page, { width: 840 });
const undone = project.undo().page === null ? 'undone' : 'kept';
engine.dispose();
document.title = `${drawn.width} x ${drawn.height}, ${undone}`;
