import { beforeEach, describe, expect, it, vi } from 'vitest';
import { createImitating } from './imitate.ts';
import { Priority } from './queue.ts';

const SURVEY = Array.from({ length: 40 }, (_, i) => ({ style: { id: `s${i}` }, area: 160_000, close: false }));
const CHILDREN = [{ style: { id: 'child' }, area: 160_000, close: false }];
const questions = vi.hoisted(() => ({ first: [] as any[] }));

vi.mock('./imitation-module.ts', () => ({
  surveyed: async () => SURVEY,
  beginSearch: async () => {
    const asks = [questions.first, CHILDREN, []];
    const told: unknown[] = [];
    let all = 0;
    return {
      ask: () => asks.shift(),
      tell: (trials: unknown[]) => {
        told.push(trials);
        all += trials.length;
      },
      progress: (tried: number) => all + tried,
      proposals: () => told,
      free: () => undefined,
    };
  },
}));

/** Workers that answer with the styles' names, once they are let. */
function engine({ fails = () => false }: { fails?: () => boolean } = {}) {
  const jobs: { ids: string[]; priority: number; end: () => void }[] = [];
  const keys: Record<string, string> = {};
  const imitating = createImitating({
    run: (({ args, priority, signal }: any) =>
      new Promise((resolve, reject) => {
        const ids = args.asks.map(({ style }: any) => style.id);
        const end = () => (fails() ? reject(new Error('no module')) : resolve(ids));
        signal?.addEventListener('abort', () => reject(Object.assign(new Error('cancelled'), { code: 'cancelled' })));
        jobs.push({ ids, priority, end });
      })) as any,
    photos: { handles: ([id]: string[]) => [{ key: keys[id] ?? id }], names: () => '' } as any,
  });
  /** Returns jobs until the queue is empty. */
  async function work() {
    const done: typeof jobs = [];
    for (;;) {
      for (let i = 0; i < 9; i += 1) await Promise.resolve();
      const job = jobs.shift();
      if (!job) return done;
      job.end();
      done.push(job);
    }
  }
  return { ...imitating, jobs, work, keys };
}

const asked = { seed: 1, onProgress: () => undefined };
const names = SURVEY.map(({ style }) => style.id);

describe('a search for styles', () => {
  beforeEach(() => {
    questions.first = SURVEY;
  });

  it('takes over what a survey of the photo found, and goes on from there', async () => {
    const { surveyLooks, imitate, work } = engine();
    const surveyed = surveyLooks('p1');
    expect((await work()).map(({ priority }) => priority)).toEqual(Array(20).fill(Priority.REST));
    await surveyed;
    for (const _ of [1, 2]) {
      const found = imitate('look', 'p1', asked);
      expect((await work()).map(({ ids }) => ids)).toEqual([['child']]);
      expect(await found).toEqual([names, ['child']]);
    }
  });

  it('hurries a survey that is under way, and tells how far it is', async () => {
    const { surveyLooks, imitate, work, jobs } = engine();
    void surveyLooks('p1');
    await vi.waitFor(() => expect(jobs.length).toBeGreaterThan(0));
    const waiting = jobs.length;
    const onProgress = vi.fn();
    const found = imitate('look', 'p1', { ...asked, onProgress });
    await new Promise((done) => {
      setTimeout(done, 0);
    });
    const later = (await work()).slice(waiting);
    expect(later.map(({ priority }) => priority)).toEqual(later.map(() => Priority.VIEW));
    expect(await found).toEqual([names, ['child']]);
    const far = onProgress.mock.calls.map(([done]) => done);
    expect(far).toEqual(far.toSorted((a, b) => a - b));
    expect(far.at(-1)).toBe(41);
  });

  it('surveys another photo, or the same when it was changed, anew', async () => {
    const { surveyLooks, work, keys } = engine();
    for (const [id, key, jobs] of [
      ['p1', 'a', 20],
      ['p1', 'a', 0],
      ['p2', 'b', 20],
      ['p2', 'c', 20],
    ] as const) {
      keys[id] = key;
      const surveyed = surveyLooks(id);
      expect(await work()).toHaveLength(jobs);
      await surveyed;
    }
  });

  it('asks all by itself where a survey does not fit, failed or was given up', async () => {
    const { surveyLooks, imitate, work } = engine();
    const surveyed = surveyLooks('p1');
    await work();
    await surveyed;
    questions.first = SURVEY.map((ask) => ({ ...ask, area: 90_000 }));
    const small = imitate('look', 'p1', asked);
    expect(await work()).toHaveLength(21);
    expect(await small).toEqual([names, ['child']]);

    questions.first = SURVEY;
    let broken = true;
    const other = engine({ fails: () => broken });
    const failing = other.surveyLooks('p1');
    failing.catch(() => undefined);
    await other.work();
    await expect(failing).rejects.toThrow('no module');
    broken = false;
    const ends = new AbortController();
    const given = other.surveyLooks('p1', { signal: ends.signal });
    given.catch(() => undefined);
    await vi.waitFor(() => expect(other.jobs.length).toBeGreaterThan(0));
    ends.abort();
    await expect(given).rejects.toMatchObject({ code: 'cancelled' });
    other.jobs.length = 0;
    const found = other.imitate('look', 'p1', asked);
    expect(await other.work()).toHaveLength(21);
    expect(await found).toEqual([names, ['child']]);
  });
});
