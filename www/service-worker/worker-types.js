// @ts-check
/** What TypeScript's library for pages lacks of service workers. */

/**
 * @typedef {Event & { waitUntil: (work: Promise<unknown>) => void }} WorkEvent
 * @typedef {WorkEvent & { data: { op?: string, extras?: boolean } | null }} OrderEvent
 * @typedef {WorkEvent & { request: Request, respondWith: (response: Response | Promise<Response>) => void }} RequestEvent
 */

/**
 * @typedef {{
 *   registration: ServiceWorkerRegistration, skipWaiting: () => Promise<void>,
 *   clients: { claim: () => Promise<void>, matchAll: (of: object) => Promise<readonly unknown[]> },
 *   addEventListener: (type: string, listener: (event: any) => void) => void,
 * }} WorkerScope
 */

/**
 * The files of one build, by their path in the site; `''` is the page itself.
 * @typedef {[path: string, integrity: string]} SiteFile
 * @typedef {{
 *   version: string,
 *   needed: SiteFile[],
 *   extras: SiteFile[],
 *   onUse: string[],
 * }} Site `needed`: the page does not work without; `extras`: good to have; `onUse`: kept by whoever uses them first
 */

export {};
