/** Service worker types that TypeScript's DOM library lacks. */

export type WorkEvent = Event & { waitUntil: (work: Promise<unknown>) => void };
export type OrderEvent = WorkEvent & { data: { op?: string; extras?: boolean } | null };
export type RequestEvent = WorkEvent & {
  request: Request;
  respondWith: (response: Response | Promise<Response>) => void;
};

type WorkerEvents = { install: WorkEvent; activate: WorkEvent; message: OrderEvent; fetch: RequestEvent };

export type WorkerScope = {
  registration: ServiceWorkerRegistration;
  skipWaiting: () => Promise<void>;
  clients: { claim: () => Promise<void>; matchAll: (of: object) => Promise<readonly unknown[]> };
  addEventListener: <Type extends keyof WorkerEvents>(
    type: Type,
    listener: (event: WorkerEvents[Type]) => void,
  ) => void;
};

/** The files of one build, by their path in the site. `''` is the page. */
export type SiteFile = [path: string, integrity: string];
/** `needed`: the app does not work without them; `extras`: optional; `onUse`: cached on first use */
export type Site = {
  version: string;
  needed: SiteFile[];
  extras: SiteFile[];
  onUse: string[];
};

export {};
