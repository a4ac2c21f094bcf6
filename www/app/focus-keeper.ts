/**
 * Keeps the keyboard focus. If the focused element is removed or disabled, the focus moves to a neighbour, or back to
 * its previous place. Without this, browsers move the focus to the body, and the next Tab starts at the top.
 */

const USABLE = 'button, input, select, textarea, a[href], summary, [tabindex]:not([tabindex="-1"])';
const TYPED = 'input:not([type=checkbox], [type=radio], [type=range]), textarea';
/** Number of stored focus positions: enough to walk through a workspace and back. */
const LONGEST = 400;

/**
 * @param root all that is watched
 * @returns ends it
 */
export function keepFocus(root: HTMLElement): () => void {
  const { ownerDocument: document } = root;
  /** Previous focus positions, the latest one last. */
  let trail: HTMLElement[] = [];
  /** The path from the focused element to the root, with the position of each element among its focusable siblings. */
  let path: { element: Element; at: number }[] = [];
  /** Whether the last input was a key. After touch input, nothing scrolls and no on-screen keyboard opens. */
  let byKey = false;

  function remember({ target }: FocusEvent) {
    if (!(target instanceof HTMLElement)) return;
    trail = [...trail.filter((element) => element !== target && element.isConnected), target].slice(-LONGEST);
    path = [];
    for (let element = target as Element | null; element && element !== root; element = element.parentElement) {
      const within = element.parentElement ? [...element.parentElement.querySelectorAll(USABLE)] : [];
      path.push({ element, at: within.findIndex((other) => element?.contains(other)) });
    }
  }

  /** A click outside of all controls removes the focus on purpose. */
  function forget() {
    path = [];
    byKey = false;
  }

  function onKey() {
    byKey = true;
  }

  function check() {
    const [had] = path;
    const active = document.activeElement;
    if (!had || (active !== null && active !== document.body)) return;
    if (isUsable(had.element)) return;
    const view = path.findLast(({ element }) => !element.isConnected)?.element.matches('main:not(.workspace)');
    // Another view starts at its top. When an overlay closes, the focus returns to the element that opened it.
    const next =
      (view
        ? null
        : (beside() ?? trail.findLast((element) => isUsable(element) && (byKey || !element.matches(TYPED))))) ??
      root.querySelector('main');
    path = [];
    if (!(next instanceof HTMLElement)) return;
    if (!next.matches(USABLE)) next.tabIndex = -1;
    next.focus({ preventScroll: !byKey });
  }

  /**
   * Returns the neighbour of a removed item of a list. Returns nothing for a removed part of the window: there the
   * opener is the better target.
   */
  function beside() {
    const gone = path.findLastIndex(({ element }) => !element.isConnected);
    const { element, at } = path[Math.max(0, gone)];
    if (gone >= 0 && !element.matches(`li, [role=group], ${USABLE}`)) return undefined;
    const home = path[Math.max(0, gone) + 1]?.element;
    if (!home?.isConnected) return undefined;
    const others = [...home.querySelectorAll(USABLE)];
    return others.slice(Math.max(0, at)).find(isUsable) ?? others.slice(0, Math.max(0, at)).findLast(isUsable);
  }

  // A component may choose a better target. It then moves the focus within one frame.
  let waiting = false;
  const observer = new MutationObserver(() => {
    if (path.length === 0 || waiting) return;
    waiting = true;
    requestAnimationFrame(() =>
      requestAnimationFrame(() => {
        waiting = false;
        check();
      }),
    );
  });
  observer.observe(root, {
    childList: true,
    subtree: true,
    attributes: true,
    attributeFilter: ['disabled', 'open', 'hidden'],
  });
  root.addEventListener('focusin', remember);
  root.addEventListener('pointerdown', forget, { capture: true });
  root.addEventListener('keydown', onKey, { capture: true });
  return () => {
    observer.disconnect();
    root.removeEventListener('focusin', remember);
    root.removeEventListener('pointerdown', forget, { capture: true });
    root.removeEventListener('keydown', onKey, { capture: true });
  };
}

function isUsable(element: Element) {
  return element.isConnected && !element.matches(':disabled') && element.checkVisibility({ visibilityProperty: true });
}
