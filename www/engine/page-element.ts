/**
 * `<inkpanel-page src="storyboard.inkpanel" page="2">` shows a page of a saved project, or of a page PNG, on another
 * site. Importing this module defines it.
 *
 * Attributes: `src`; `page`, from 1; `alt`, the alternative text. Events: `load`, with the number of `pages`; `error`,
 * with the error. All elements of a document share one engine.
 */

import { createEngine } from './engine.ts';
import { isPng } from './png-chunks.ts';
import { failure } from './protocol.ts';
import { openProject } from './saved-project.ts';
import { createTimer } from './scheduler.ts';
import type { Engine } from './engine.ts';
import type { SavedProject } from './saved-project.ts';
import type { PageDocument } from './types.ts';

/** Range of the width of a drawn page in pixels. */
const WIDTHS = [320, 2400] as const;
/** Milliseconds without a change of size until it is drawn again. */
const SETTLED = 150;

let shared: Engine | undefined;
const engine = () => (shared ??= createEngine());

const STYLE = `:host { display: block; } :host([hidden]) { display: none; }
img, canvas { display: block; width: 100%; height: auto; }`;

export class InkpanelPage extends HTMLElement {
  static observedAttributes = ['src', 'page', 'alt'];

  /** Number of pages, 0 until it is known. */
  pages = 0;

  #stop = new AbortController();
  #project: SavedProject | null = null;
  #root = this.attachShadow({ mode: 'open' });
  #resized = new ResizeObserver(() => this.#later());
  #timer = createTimer();
  #drawn = '';

  connectedCallback() {
    this.#put();
    this.#resized.observe(this);
    void this.#open();
  }

  disconnectedCallback() {
    this.#resized.disconnect();
    this.#timer.stop();
    this.#close();
  }

  attributeChangedCallback(name: string, before: string | null, now: string | null) {
    if (!this.isConnected || before === now) return;
    if (name === 'src') void this.#open();
    else if (name === 'page') void this.#show(this.#stop.signal);
    else {
      this.#root.querySelector('img')?.setAttribute('alt', now ?? '');
      this.#root.querySelector('canvas')?.setAttribute('aria-label', now ?? '');
    }
  }

  #close() {
    this.#stop.abort();
    this.#stop = new AbortController();
    this.#project?.close();
    this.#project = null;
    this.#drawn = '';
  }

  async #open() {
    this.#close();
    const { signal } = this.#stop;
    const src = this.getAttribute('src');
    this.pages = 0;
    if (!src) return this.#put();
    this.setAttribute('aria-busy', 'true');
    try {
      const response = await fetch(new URL(src, this.ownerDocument.baseURI), { signal });
      if (!response.ok) throw failure('missing-page', `${src} could not be loaded (${response.status}).`);
      const file = await response.blob();
      if (await isPng(file)) await this.#picture(file, signal);
      else {
        const project = await openProject(engine(), file, { signal });
        if (signal.aborted) return project.close();
        this.#project = project;
        this.pages = project.pages.length;
        if (this.pages === 0) throw failure('empty-project', `${src} has no page.`);
        await this.#show(signal);
      }
      if (!signal.aborted) this.dispatchEvent(new CustomEvent('load', { detail: { pages: this.pages } }));
    } catch (error) {
      if (!signal.aborted) this.#failed(error);
    }
    if (!signal.aborted) this.removeAttribute('aria-busy');
  }

  async #picture(file: Blob, signal: AbortSignal) {
    const image = Object.assign(new Image(), { alt: this.getAttribute('alt') ?? '', src: URL.createObjectURL(file) });
    try {
      await image.decode();
    } finally {
      // The decoded image is retained.
      URL.revokeObjectURL(image.src);
    }
    if (signal.aborted) return;
    this.pages = 1;
    this.#put(image);
  }

  /** Draws the requested page at its width in the layout. */
  async #show(signal: AbortSignal) {
    if (!this.#project) return;
    const { pages, name } = this.#project;
    const wanted = Math.floor(Number(this.getAttribute('page') ?? 1)) || 1;
    const at = Math.min(Math.max(wanted, 1), pages.length);
    const document: PageDocument = pages[at - 1];
    const room = this.clientWidth * devicePixelRatio || document.page.width;
    const width = Math.round(Math.min(Math.max(room, WIDTHS[0]), WIDTHS[1], document.page.width));
    if (this.#drawn === `${at} ${width}`) return;
    this.#drawn = `${at} ${width}`;
    const { data, ...size } = await engine().compose(document, { width, signal });
    if (signal.aborted || this.#drawn !== `${at} ${width}`) return;
    // The existing canvas is reused, so that nothing flickers.
    const canvas = this.#root.querySelector('canvas') ?? this.ownerDocument.createElement('canvas');
    Object.assign(canvas, { width: size.width, height: size.height });
    canvas.getContext('2d')?.putImageData(new ImageData(data, size.width, size.height), 0, 0);
    canvas.setAttribute('role', 'img');
    canvas.setAttribute('aria-label', this.getAttribute('alt') ?? `${name} ${at}/${pages.length}`.trim());
    if (!canvas.isConnected) this.#put(canvas);
  }

  /** The style is there from the start: without it the element has no width to draw for. */
  #put(...pictures: HTMLElement[]) {
    const style = Object.assign(this.ownerDocument.createElement('style'), { textContent: STYLE });
    this.#root.replaceChildren(style, ...pictures);
  }

  #later() {
    this.#timer.stop();
    const { signal } = this.#stop;
    this.#timer.start(SETTLED, () => this.#show(signal).catch((error) => signal.aborted || this.#failed(error)));
  }

  #failed(error: unknown) {
    this.#drawn = '';
    this.dispatchEvent(new ErrorEvent('error', { error, message: (error as Error).message }));
  }
}

if (!customElements.get('inkpanel-page')) customElements.define('inkpanel-page', InkpanelPage);
