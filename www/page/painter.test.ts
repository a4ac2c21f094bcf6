import { beforeEach, expect, test, vi } from 'vitest';
import { createPainter } from './painter.ts';

vi.useFakeTimers();
vi.stubGlobal('requestAnimationFrame', (paint: () => void) => setTimeout(paint, 16));
vi.stubGlobal('cancelAnimationFrame', clearTimeout);

let jobs: any[] = [];
let drawn: string[] = [];
beforeEach(() => {
  vi.clearAllTimers();
  jobs = [];
  drawn = [];
});

/** A page of two panels. */
const page = (layout: string, rest?: object): any => ({
  layout,
  style: 's',
  merges: [],
  panels: [{ photo: 'a' }, { photo: 'b' }],
  page: { width: 10, height: 10, gutter: 0 },
  ...rest,
});
const panel = (name: string) => ({
  name,
  polygon: [
    [0, 0],
    [1, 0],
    [1, 1],
  ],
  bounds: { x: 0, y: 0, width: 1, height: 1 },
});
/** The shapes of each layout differ. */
const geometry = (layout: string): any => ({ width: 1, height: 1, panels: [panel(layout), panel(layout)] });

function painter(
  readable = ['a', 'b'],
  subjectOf?: (document: any, photo: string) => string | undefined,
  thumbnailOf: (photo: string) => any = () => undefined,
) {
  const context = new Proxy(
    {},
    {
      get:
        (_, name) =>
        (...args: any[]) => {
          if (name === 'fillRect') drawn = [];
          if (name === 'drawImage') drawn.push(args[0].name);
          if (name === 'fill') drawn.push('wait');
        },
      set: () => true,
    },
  );
  const canvas = { width: 1, height: 1, getContext: () => context } as any;
  const renderPictures = (document: any, pictures: number[], width: number, call: any) => {
    const job = {
      name: `${document.layout}${document.style}${pictures.join('+')}`,
      tier: call.tier,
      signal: call.signal,
      priority: call.priority,
      promoted: call.promoted,
    } as any;
    const promise = new Promise((resolve, reject) => {
      const patch = (picture: number) => {
        const name = `${document.layout}${document.style}${picture}`;
        return { x: 0, y: 0, width, height: width, bitmap: { name, width: 1, height: 1 } };
      };
      job.done = () => resolve(pictures.map(patch));
      job.fail = (code: string) => reject(Object.assign(new Error(code), { code }));
    });
    jobs.push(job);
    return promise;
  };
  const painted = vi.fn();
  const errors = vi.fn();
  const hasPhoto = (id: string) => readable.includes(id);
  const made = createPainter(canvas, {
    engine: { renderPictures, hasPhoto, subjectOf, thumbnailOf } as any,
    onPainted: painted,
    onError: errors,
  });
  return { ...made, painted, errors };
}

const finish = async (name: string) => {
  jobs.find((job) => job.name === name).done();
  await vi.advanceTimersByTimeAsync(20);
};

test('another layout appears at once when all of its panels are there', async () => {
  const { show, painted } = painter();
  show(page('A'), geometry('A'), 10);
  await finish('As0');
  await finish('As1');
  expect(drawn).toEqual(['As0', 'As1']);
  const other = page('B');
  show(other, geometry(other.layout), 10);
  await finish('Bs0');
  expect(drawn).toEqual(['As0', 'As1']);
  expect(painted).toHaveBeenLastCalledWith(null, false);
  await finish('Bs1');
  expect(drawn).toEqual(['Bs0', 'Bs1']);
  expect(painted).toHaveBeenLastCalledWith(other, true);
});

test('a panel is drawn again when the subject of its photo is known', async () => {
  const masks: Record<string, string> = {};
  const { show } = painter(['a', 'b'], (_, photo) => masks[photo]);
  show(page('A'), geometry('A'), 10);
  await finish('As0');
  await finish('As1');
  masks.b = '1x1:p';
  show(page('A'), geometry('A'), 10);
  expect(jobs.map(({ name }) => name)).toEqual(['As0', 'As1', 'As1']);
});

test('a slow page is shown with what there is, and filled', async () => {
  const { show } = painter();
  show(page('A'), geometry('A'), 10);
  await finish('As0');
  await finish('As1');
  show(page('B'), geometry('B'), 10);
  await finish('Bs0');
  await vi.advanceTimersByTimeAsync(150);
  expect(drawn).toEqual(['Bs0', 'wait']);
  await finish('Bs1');
  expect(drawn).toEqual(['Bs0', 'Bs1']);
});

test('a length follows the hand with the old pictures', async () => {
  const { show } = painter();
  show(page('A'), geometry('A'), 10);
  await finish('As0');
  await finish('As1');
  show(page('A', { page: { width: 10, height: 10, gutter: 0.1 } }), geometry('A'), 10);
  await vi.advanceTimersByTimeAsync(20);
  expect(drawn).toEqual(['wait', 'As0', 'wait', 'As1']);
});

test('pictures that nobody wants any more are cancelled, those still wanted are not asked for twice', async () => {
  const { show } = painter();
  show(page('A'), geometry('A'), 10);
  show(page('A', { panels: [{ photo: 'a' }, { photo: 'c' }] }), geometry('A'), 10);
  expect(jobs.map(({ signal }) => signal.aborted)).toEqual([false, true]);
  show(page('A', { panels: [{ photo: 'a' }, { photo: 'b' }] }), geometry('A'), 10);
  await finish('As0');
  expect(jobs.filter(({ name }) => name === 'As0').length).toBe(1);
});

test('the page before is there without work', async () => {
  const { show } = painter();
  for (const layout of ['A', 'B']) {
    show(page(layout), geometry(layout), 10);
    await finish(`${layout}s0`);
    await finish(`${layout}s1`);
  }
  const asked = jobs.length;
  show(page('A'), geometry('A'), 10);
  await vi.advanceTimersByTimeAsync(20);
  expect(drawn).toEqual(['As0', 'As1']);
  expect(jobs.length).toBe(asked);
});

test('of another project no picture is kept', async () => {
  const { show, forget } = painter();
  show(page('A'), geometry('A'), 10);
  await finish('As0');
  await finish('As1');
  forget();
  show(page('B'), geometry('B'), 10);
  await finish('Bs0');
  await finish('Bs1');
  jobs = [];
  show(page('A'), geometry('A'), 10);
  expect(jobs.map(({ name }) => name)).toEqual(['As0', 'As1']);
});

test('a photo that is still being read leaves its panel empty, and the page counts as painted without it', async () => {
  const { show, painted } = painter(['a']);
  const document = page('A');
  show(document, geometry(document.layout), 10);
  await finish('As0');
  expect(drawn).toEqual(['As0', 'wait']);
  expect(painted).toHaveBeenLastCalledWith(document, true);
});

test('a panel that fails is told once, and does not hold the page', async () => {
  const { show, painted, errors } = painter();
  const document = page('A');
  show(document, geometry(document.layout), 10);
  jobs[0].fail('worker-lost');
  await finish('As1');
  expect(errors).toHaveBeenCalledTimes(1);
  expect(painted).toHaveBeenLastCalledWith(document, false);
  // It is drawn at the next opportunity.
  const again = page('A');
  show(again, geometry(again.layout), 10);
  jobs[2].done();
  await vi.advanceTimersByTimeAsync(20);
  expect(painted).toHaveBeenLastCalledWith(again, true);
});

test('a page that was prepared appears at once, and its unfinished panels become urgent', async () => {
  const { show, prepare } = painter();
  show(page('A'), geometry('A'), 10);
  await finish('As0');
  await finish('As1');
  const whole = prepare(page('B'), geometry('B'), 10);
  expect(jobs.slice(2).map(({ name, priority }) => [name, priority])).toEqual([
    ['Bs0', 3],
    ['Bs1', 3],
  ]);
  const promoted = vi.fn();
  jobs[3].promoted.then(promoted);
  await finish('Bs0');
  expect(drawn).toEqual(['As0', 'As1']);
  expect(promoted).not.toHaveBeenCalled();
  show(page('B'), geometry('B'), 10);
  await vi.advanceTimersByTimeAsync(0);
  expect(promoted).toHaveBeenCalled();
  expect(jobs[3].signal.aborted).toBe(false);
  expect(jobs).toHaveLength(4);
  await finish('Bs1');
  await vi.advanceTimersByTimeAsync(20);
  expect(drawn).toEqual(['Bs0', 'Bs1']);
  expect(await whole).toBe(true);
});

test('another prepared page cancels one that was prepared, and nothing of the visible page', async () => {
  const { show, prepare } = painter();
  show(page('A'), geometry('A'), 10);
  prepare(page('B'), geometry('B'), 10);
  prepare(page('C'), geometry('C'), 10);
  expect(jobs.map(({ name, signal }) => [name, signal.aborted])).toEqual([
    ['As0', false],
    ['As1', false],
    ['Bs0', true],
    ['Bs1', true],
    ['Cs0', false],
    ['Cs1', false],
  ]);
});

test('another page cancels one that was prepared', async () => {
  const { show, prepare } = painter();
  show(page('A'), geometry('A'), 10);
  prepare(page('B'), geometry('B'), 10);
  show(page('C'), geometry('C'), 10);
  expect(jobs.filter(({ name }) => name.startsWith('B')).map(({ signal }) => signal.aborted)).toEqual([true, true]);
});

test('a panel and the figure that steps out of it are one job, drawn anew together', async () => {
  const { show } = painter();
  const broken = (crop: object | null) =>
    page('A', {
      panels: [
        { photo: 'a', crop },
        { photo: 'b', crop: null, figure: '1x1:p' },
      ],
    });
  show(broken(null), geometry('A'), 10);
  expect(jobs.map(({ name }) => name)).toEqual(['As0', 'As1+2']);
  await finish('As0');
  await finish('As1+2');
  expect(drawn).toEqual(['As0', 'As1', 'As2']);
  // The content of another panel may clip the subject elsewhere.
  show(broken({ x: 0, y: 0, width: 0.5, height: 0.5 }), geometry('A'), 10);
  expect(jobs.slice(2).map(({ name }) => name)).toEqual(['As0', 'As1+2']);
  expect(jobs.map(({ signal }) => signal.aborted)).toEqual([false, false, false, false]);
  show(page('B'), geometry('B'), 10);
  expect(jobs[3].signal.aborted).toBe(true);
});

test('the quick pictures of a panel and its figure are one job, too', async () => {
  const { show } = painter();
  const broken = page('A', { panels: [{ photo: 'a' }, { photo: 'b', figure: '1x1:p' }], style: 'slow' });
  show(broken, geometry('A'), 10);
  await vi.advanceTimersByTimeAsync(5000);
  await finish('Aslow0');
  await finish('Aslow1+2');
  show({ ...broken, layout: 'B' }, geometry('B'), 10);
  const quick = jobs.filter(({ tier }) => tier === 'small').map(({ name }) => name);
  expect(quick).toEqual(['Bslow0', 'Bslow1+2']);
  jobs.filter(({ tier }) => tier === 'small').forEach((job) => job.done());
  await vi.advanceTimersByTimeAsync(200);
  expect(drawn).toEqual(['Bslow0', 'Bslow1', 'Bslow2']);
});

test('a style that takes as long at half size has no quick pictures', async () => {
  const { show } = painter();
  const asked = async (style: string) => {
    jobs = [];
    show(page('A', { style }), geometry('A'), 10);
    await vi.advanceTimersByTimeAsync(5000);
    await finish(`A${style}0`);
    await finish(`A${style}1`);
    show(page('B', { style }), geometry('B'), 10);
    return jobs.map(({ tier }) => tier);
  };
  expect(await asked('slow')).toContain('small');
  expect(await asked('painter-night')).not.toContain('small');
});

test('a panel shows the thumbnail of its file until its photo is read', async () => {
  const { show } = painter([], undefined, (photo) => photo === 'a' && { bitmap: { name: 'thumbnail' }, turn: 1 });
  show(page('A'), geometry('A'), 10);
  await vi.advanceTimersByTimeAsync(20);
  expect(drawn).toEqual(['wait', 'thumbnail', 'wait']);
});

test('while a moved crop is drawn, the old picture fills the part that the moved picture leaves', async () => {
  const { show } = painter();
  const cropped = (x: number) =>
    page('A', {
      panels: [{ photo: 'a', crop: { x, y: 0, width: 0.5, height: 1 } }, { photo: 'b' }],
      page: { width: 100, height: 100, gutter: 0, border: 0 },
    });
  show(cropped(0), geometry('A'), 100);
  await finish('As0');
  await finish('As1');
  show(cropped(0.4), geometry('A'), 100);
  await vi.advanceTimersByTimeAsync(20);
  expect(drawn).toEqual(['wait', 'As0', 'As0', 'As1']);
});
