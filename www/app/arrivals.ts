/**
 * Files from the system: opened with the installed app, or shared by another program. They are handled like dropped
 * files.
 */

import { strings } from '../strings/strings.ts';
import type { Messages } from '../ui/messages.ts';

/** As the service worker names them (`offline/worker/shares.ts`). */
const SHARED = 'inkpanel-shared';
const PARAMETER = 'shared';

type Handle = { name: string; getFile: () => Promise<File> };

export function createArrivals({
  window,
  intake,
  messages,
}: {
  window: Window & {
    launchQueue?: { setConsumer: (consumer: (launch: { files?: readonly Handle[] }) => void) => void };
  };
  intake: (files: File[]) => void;
  messages: Pick<Messages, 'alert'>;
}) {
  return { begin };

  /** To be called when the project of the last visit is there, which the files join. */
  function begin() {
    window.launchQueue?.setConsumer(({ files = [] }) => void open(files));
    const { href } = window.location;
    const id = new URL(href).searchParams.get(PARAMETER);
    if (id === null) return;
    const rest = new URL(href);
    rest.searchParams.delete(PARAMETER);
    // Loaded again, the page does not look for them again.
    window.history.replaceState(null, '', rest);
    void takeShared(id).catch(() => messages.alert(strings.sharedLost));
  }

  async function open(handles: readonly Handle[]) {
    const files = await Promise.all(
      handles.map((handle) =>
        handle.getFile().catch(() => {
          messages.alert(strings.launchFailed({ name: handle.name }));
          return null;
        }),
      ),
    );
    take(files.filter((file) => file !== null));
  }

  async function takeShared(id: string) {
    if (id === 'lost') throw new Error('not stored');
    const store = await window.caches.open(SHARED);
    const folder = new URL(`shared/${id}/`, window.document.baseURI).href;
    const requests = (await store.keys()).filter(({ url }) => url.startsWith(folder));
    const files = await Promise.all(
      requests.map(async (request) => {
        const response = (await store.match(request)) as Response;
        const { headers } = response;
        const [name, type] = [decodeURIComponent(headers.get('x-name') ?? ''), headers.get('content-type') ?? ''];
        return new File([await response.blob()], name, { type });
      }),
    );
    take(files);
    // The file is in memory, so a full storage cannot remove it.
    await Promise.all(requests.map((request) => store.delete(request)));
  }

  function take(files: File[]) {
    if (files.length > 0) intake(files);
  }
}
