// @ts-check
/**
 * Returns visible controls whose middle is covered by another element. It runs in the page, in any engine.
 * @returns {string[]} their names, with the covering element
 */
export function covered() {
  const names = [];
  for (const element of document.querySelectorAll('button, select, summary, textarea, input:not([type=file])')) {
    if (!element.checkVisibility({ visibilityProperty: true, opacityProperty: true })) continue;
    const box = element.getBoundingClientRect();
    const [x, y] = [box.left + box.width / 2, box.top + box.height / 2];
    // Skips elements for screen readers only, and elements that are scrolled out of view.
    if (box.width < 2 || !within(element, x, y)) continue;
    const over = document.elementFromPoint(x, y);
    // A check box may lie under the picture that is its label.
    const target = element.closest('label') ?? element;
    if (!over || target.contains(over)) continue;
    const name = element.getAttribute('aria-label') ?? element.textContent;
    names.push(`${name} is under ${over.tagName.toLowerCase()}.${over.className}`);
  }
  return names;

  /** @param {Element} element @param {number} x @param {number} y */
  function within(element, x, y) {
    if (x < 0 || y < 0 || x >= innerWidth || y >= innerHeight) return false;
    for (let place = element.parentElement; place; place = place.parentElement) {
      if (getComputedStyle(place).overflow === 'visible') continue;
      const { left, right, top, bottom } = place.getBoundingClientRect();
      if (x < left || x >= right || y < top || y >= bottom) return false;
    }
    return true;
  }
}
