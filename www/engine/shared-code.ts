/**
 * Whether threads may run the code of one module. JavaScriptCore (seen in 2.50, Safari 26) replaces the code of hot
 * functions while other threads run it: now and then they then trap, or calculate nonsense. Elsewhere to share spares
 * the work and the memory of compiling it again.
 */
export const SHARES_CODE = !globalThis.navigator?.vendor?.startsWith('Apple');
