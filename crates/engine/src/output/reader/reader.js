// @ts-check
/**
 * The reader of a comic in one HTML file. It shows panels, whole pages, or text. The exporter copies this file
 * unchanged, so it imports nothing. It reads the comic from the page: `data-size` of a page is the width and height of
 * its picture. `data-box` of a panel is the area to show, in pixels of that picture.
 */

/** @typedef {{ x: number, y: number, width: number, height: number }} Box */
/** @typedef {{ width: number, height: number }} Size */
/** @typedef {'panels' | 'pages' | 'text'} View */
/** @typedef {{ page: number, panel: number }} Stop */

/** A finger that moves so far across, in pixels, turns the page. */
const SWIPE = 40;
/** A finger or a mouse that moves so little has not moved. */
const STILL = 10;
/** The part of the width, from the side where reading begins, where a tap goes back. */
const BACK = 0.3;
/** Minimum magnification of a pinch zoom at which one finger pans the picture. */
const ENLARGED = 1.05;
/**
 * Keys for next and previous.
 * @type {Record<string, 1 | -1 | undefined>}
 */
const KEYS = { ArrowRight: 1, ArrowDown: 1, PageDown: 1, ArrowLeft: -1, ArrowUp: -1, PageUp: -1 };
/** Screens that are too small for reading a whole page. */
const SMALL = '(max-width: 700px), (max-height: 500px)';

/**
 * @param {string} text `x y width height`
 * @returns {Box}
 */
export function boxOf(text) {
  const [x, y, width, height] = text.split(' ').map(Number);
  return { x, y, width, height };
}

/**
 * Returns position and scale of a page at which `box` fills the screen.
 * @param {Box} box the part, in pixels of the page's picture
 * @param {Size} stage the screen
 * @param {number} room margin in pixels of the screen
 * @returns {{ scale: number, x: number, y: number }}
 */
export function fitted(box, stage, room) {
  const across = Math.max(1, stage.width - 2 * room) / box.width;
  const down = Math.max(1, stage.height - 2 * room) / box.height;
  const scale = Math.min(across, down);
  return {
    scale,
    x: (stage.width - box.width * scale) / 2 - box.x * scale,
    y: (stage.height - box.height * scale) / 2 - box.y * scale,
  };
}

/**
 * @param {{ x: number, y: number }} from position of the finger when it touched the screen
 * @param {{ x: number, y: number }} to position when it was lifted
 * @returns {-1 | 0 | 1} 1 for next, -1 for previous
 */
export function swiped(from, to) {
  const [x, y] = [to.x - from.x, to.y - from.y];
  if (Math.abs(x) < SWIPE || Math.abs(x) < 1.5 * Math.abs(y)) return 0;
  return x < 0 ? 1 : -1;
}

/**
 * The next place to read.
 * @param {Stop} from
 * @param {-1 | 1} by
 * @param {readonly number[]} panels number of panels of each page
 * @param {View} view
 * @returns {Stop | null} null at the end
 */
export function stepped(from, by, panels, view) {
  const panel = from.panel + by;
  if (view === 'panels' && panel >= 0 && panel < panels[from.page]) return { page: from.page, panel };
  const page = from.page + by;
  if (page < 0 || page >= panels.length) return null;
  // Previous, from the first panel, goes to the last panel of the previous page.
  return { page, panel: view === 'panels' && by < 0 ? panels[page] - 1 : 0 };
}

/**
 * @param {string} hash `#page-2-panel-3`
 * @param {readonly number[]} panels number of panels of each page
 * @returns {Stop | null}
 */
export function placeOf(hash, panels) {
  const [, page, panel] = /^#page-(\d+)(?:-panel-(\d+))?$/.exec(hash) ?? [];
  const stop = { page: Number(page) - 1, panel: Number(panel ?? 1) - 1 };
  return stop.panel >= 0 && stop.panel < (panels[stop.page] ?? 0) ? stop : null;
}

/** @param {Document} document that holds a comic */
function start(document) {
  const root = document.documentElement;
  /** 1 if the comic is read from left to right, otherwise -1. */
  const onwards = root.dataset.rtl ? -1 : 1;
  const main = /** @type {HTMLElement} */ (document.getElementById('comic'));
  const pages = [...main.querySelectorAll('.page')].map((page) => ({
    page,
    size: sizeOf(page.getAttribute('data-size') ?? ''),
    sheet: /** @type {HTMLElement} */ (page.querySelector('.sheet')),
    image: /** @type {HTMLImageElement} */ (page.querySelector('img')),
    hole: /** @type {SVGElement} */ (page.querySelector('.hole')),
    shapes: [...page.querySelectorAll('.shape')],
    panels: [...page.querySelectorAll('.panel')],
  }));
  const counts = pages.map(({ panels }) => panels.length);
  const total = counts.reduce((sum, count) => sum + count, 0);
  const views = /** @type {HTMLElement[]} */ ([...document.querySelectorAll('[data-view]')]);
  const [previous, next, place, says, progress] = ['previous', 'next', 'place', 'says', 'progress'].map(
    (id) => /** @type {HTMLElement} */ (document.getElementById(id)),
  );
  /** @type {Stop} */
  let at = placeOf(document.location.hash, counts) ?? { page: 0, panel: 0 };
  /** @type {View} */
  let view = window.matchMedia(SMALL).matches || document.location.hash.includes('-panel-') ? 'panels' : 'pages';

  /** @param {boolean} moving whether the way there is shown */
  function show(moving) {
    root.className = `ready view-${view}${view === 'text' ? '' : ' stage'}${view === 'panels' ? ' guided' : ''}`;
    for (const button of views) button.setAttribute('aria-pressed', String(button.getAttribute('data-view') === view));
    const here = pages[at.page];
    pages.forEach(({ page }, i) => page.classList.toggle('current', i === at.page));
    here.sheet.classList.toggle('still', !moving);
    lay();
    const guided = view === 'panels';
    here.hole.replaceChildren(...(guided ? holes(here.shapes, at.panel) : []));
    const before = counts.slice(0, at.page).reduce((sum, count) => sum + count, 0);
    const [read, all] = guided ? [before + at.panel + 1, total] : [at.page + 1, pages.length];
    place.textContent = `${read} / ${all}`;
    progress.style.transform = `scaleX(${read / all})`;
    previous.setAttribute('aria-disabled', String(stepped(at, -1, counts, view) === null));
    next.setAttribute('aria-disabled', String(stepped(at, 1, counts, view) === null));
    // Decodes the next picture in advance.
    pages[at.page + 1]?.image.decode().catch(() => {});
  }

  /** Puts the page that is read into its place. */
  function lay() {
    if (view === 'text') return;
    const { size, sheet, panels } = pages[at.page];
    const stage = { width: main.clientWidth, height: main.clientHeight };
    const room = Math.round(Math.min(stage.width, stage.height) * 0.025) + 4;
    const guided = view === 'panels';
    const box = guided ? boxOf(panels[at.panel].getAttribute('data-box') ?? '') : { x: 0, y: 0, ...size };
    const { scale, x, y } = fitted(box, stage, room);
    sheet.style.transform = `translate(${x}px, ${y}px) scale(${scale})`;
  }

  function tell() {
    const { page, panels } = pages[at.page];
    const panel = panels[at.panel];
    const said = [...panel.querySelectorAll('.said')].map((word) => word.textContent);
    says.textContent =
      view === 'panels' ? [panel.getAttribute('aria-label'), ...said].join('. ') : page.getAttribute('aria-label');
  }

  /** @param {Stop | null} stop */
  function go(stop) {
    if (!stop) return;
    const moving = stop.page === at.page;
    at = stop;
    show(moving);
    tell();
    remember();
  }

  /** Stores the current position in the address, so that a reload continues there. */
  function remember() {
    const id = view === 'panels' ? pages[at.page].panels[at.panel].id : pages[at.page].page.id;
    try {
      history.replaceState(null, '', `#${id}`);
    } catch {
      // Some browsers do not let a file have another address.
    }
  }

  /** @param {-1 | 1} by */
  const step = (by) => go(stepped(at, by, counts, view));

  /** @param {View} wanted */
  function look(wanted) {
    if (wanted === 'text') {
      view = wanted;
      show(false);
      if (at.page === 0) window.scrollTo(0, 0);
      else pages[at.page].page.scrollIntoView();
      return;
    }
    const moving = view !== 'text';
    view = wanted;
    show(moving);
    tell();
    remember();
  }

  for (const button of views)
    button.addEventListener('click', () => look(/** @type {View} */ (button.getAttribute('data-view'))));
  previous.addEventListener('click', () => step(-1));
  next.addEventListener('click', () => step(1));
  const motion = document.getElementById('motion');
  motion?.addEventListener('click', () => {
    const rests = main.classList.toggle('at-rest');
    motion.setAttribute('aria-pressed', String(!rests));
  });

  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || view === 'text') return;
    const onButton = event.target instanceof HTMLButtonElement;
    const on = KEYS[event.key];
    const turned = onwards < 0 && /^Arrow(Left|Right)$/.test(event.key);
    const by = on && turned ? (on > 0 ? -1 : 1) : on;
    if (by) step(by);
    else if (event.key === ' ' && !onButton) step(event.shiftKey ? -1 : 1);
    else if (event.key === 'Enter' && !onButton && view === 'pages') look('panels');
    else if (event.key === 'Escape' && view === 'panels') look('pages');
    else if (event.key === 'Home') go({ page: 0, panel: 0 });
    else if (event.key === 'End')
      go({ page: pages.length - 1, panel: view === 'panels' ? counts[pages.length - 1] - 1 : 0 });
    else return;
    event.preventDefault();
  });

  /** @type {{ id: number, x: number, y: number } | null} */
  let down = null;
  let moved = false;
  main.addEventListener('pointerdown', ({ pointerId, clientX, clientY, isPrimary }) => {
    down = isPrimary ? { id: pointerId, x: clientX, y: clientY } : null;
    moved = !isPrimary;
  });
  main.addEventListener('pointercancel', () => {
    down = null;
  });
  main.addEventListener('pointerup', ({ pointerId, pointerType, clientX, clientY }) => {
    if (!down || down.id !== pointerId || view === 'text') return;
    const up = { x: clientX, y: clientY };
    const [from, to] = onwards > 0 ? [down, up] : [up, down];
    const by = pointerType === 'mouse' || enlarged() ? 0 : swiped(from, to);
    moved = Math.hypot(clientX - down.x, clientY - down.y) > STILL;
    down = null;
    if (by !== 0) step(by);
  });
  main.addEventListener('click', (event) => {
    if (view === 'text' || moved || enlarged()) return;
    const shape = event.target instanceof Element ? event.target.closest('.shape') : null;
    if (view === 'pages' && shape) {
      view = 'panels';
      go({ page: at.page, panel: Number(shape.getAttribute('data-panel')) });
      return;
    }
    const { left, width } = main.getBoundingClientRect();
    const part = (event.clientX - left) / width;
    step((onwards > 0 ? part : 1 - part) < BACK ? -1 : 1);
  });
  window.addEventListener('hashchange', () => {
    const stop = placeOf(document.location.hash, counts);
    if (stop) go(stop);
  });
  new ResizeObserver(() => {
    pages[at.page].sheet.classList.add('still');
    lay();
  }).observe(main);

  show(false);
}

/**
 * Returns the shapes that are not dimmed: the panel without later panels on top of it, and its text items.
 * @param {readonly Element[]} shapes of all panels; later ones are on top
 * @param {number} panel
 * @returns {Node[]}
 */
function holes(shapes, panel) {
  const [outline, ...words] = [...shapes[panel].children].map((shape) => shape.cloneNode());
  const over = shapes.slice(panel + 1).flatMap(({ firstElementChild: later }) => {
    if (!later) return [];
    const copy = /** @type {Element} */ (later.cloneNode());
    copy.setAttribute('class', 'over');
    return [copy];
  });
  return [outline, ...over, ...words];
}

function enlarged() {
  return (window.visualViewport?.scale ?? 1) > ENLARGED;
}

/**
 * @param {string} text `width height`
 * @returns {Size}
 */
function sizeOf(text) {
  const [width, height] = text.split(' ').map(Number);
  return { width, height };
}

if (typeof document !== 'undefined' && document.getElementById('comic')) start(document);
