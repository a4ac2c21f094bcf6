// @ts-check
/** How a shuffle draws styles: also from a person's own and favourites, some of them invented, a layer of the page kept. */

/** @typedef {import('../engine/core.js').Planner} Planner */
/** @typedef {import('./project.js').Styling} Styling */
/** @typedef {ReturnType<typeof createStyling>} StylingDeeds */

/** @param {{ store: import('./store.js').Store, ownStyles: Pick<import('./own-styles.js').OwnStyles, 'mine' | 'favourites'> }} app */
export function createStyling({ store, ownStyles }) {
  return { within, change };

  /**
   * A planner whose pages are drawn like that.
   * @param {Planner} planner
   * @returns {Planner}
   */
  function within(planner) {
    return {
      ...planner,
      plan: (request) => {
        // A style that stays or is named is not drawn; hundreds of others need not cross to the core.
        if (request.keep.style || request.style !== undefined) return planner.plan(request);
        const { invented, keepLines, keepColours } = store.project.peek().styling;
        const mine = ownStyles.mine.peek();
        const extra = [...mine, ...ownStyles.favourites.peek().filter(({ id }) => mine.every((style) => style.id !== id))];
        return planner.plan({ ...request, styling: { extra, invented, keepLines, keepColours } });
      },
    };
  }

  /** @param {Partial<Styling>} wish @param {string} [gesture] names one drag of a control, which is one step of the undo */
  function change(wish, gesture) {
    store.change({ type: 'styling', styling: { ...store.project.peek().styling, ...wish }, gesture });
  }
}
