import { beforeEach, expect, test } from 'vitest';
import { createTaste } from './taste.ts';
import type { PageDocument } from '../engine/types.ts';

const layouts = () => [
  { id: 'cinema-3', family: 'cinema' },
  { id: 'grid-4', family: 'grid' },
];
const page = (layout: string | object, style: string | object) => ({ layout, style }) as PageDocument;

let kept: Map<string, string>;
let asked: any[];

beforeEach(() => {
  kept = new Map();
  asked = [];
});

const open = (box: any = { getItem: (key: string) => kept.get(key) ?? null, setItem: kept.set.bind(kept) }) => {
  const taste = createTaste({ planner: () => ({ layouts }) as any, box: () => box });
  return { taste, plan: (request: any) => void asked.push(taste.asked(request)) };
};
const free = { keep: { layout: false, style: false, photos: false } };
const told = () => asked.at(-1).taste;

test('what is kept is drawn more often, here and at the next visit', () => {
  const { taste, plan } = open();
  plan(free);
  expect(told()).toEqual({ families: {}, styles: {} });
  taste.learn(page('cinema-3', 'noir'));
  taste.learn(page('cinema-3', { id: 'my-1' }));
  plan(free);
  expect(told().families.cinema).toBeGreaterThan(told().styles.noir);
  expect(told().styles['my-1']).toBeGreaterThan(told().styles.noir);
  open().plan(free);
  expect(asked.at(-1).taste).toEqual(asked.at(-2).taste);
});

test('it is bounded, and fades with what comes after', () => {
  const { taste, plan } = open();
  for (let i = 0; i < 100; i += 1) taste.learn(page('cinema-3', 'noir'));
  plan(free);
  expect(told()).toEqual({ families: { cinema: 1.6 }, styles: { noir: 1.6 } });
  for (let i = 0; i < 200; i += 1) taste.learn(page('grid-4', 'pop'));
  plan(free);
  expect(told()).toEqual({ families: { grid: 1.6 }, styles: { pop: 1.6 } });
});

test('it is forgotten, and learns nothing while it is switched off', () => {
  const { taste, plan } = open();
  taste.learn(page('cinema-3', 'noir'));
  expect(taste.known.value).toBe(true);
  taste.forget();
  expect(taste.known.value).toBe(false);
  taste.setOn(false);
  taste.learn(page('cinema-3', 'noir'));
  plan(free);
  expect(told()).toBeUndefined();
  expect(open().taste.on.value).toBe(false);
  expect(kept.get('inkpanel.taste')).not.toContain('noir');
});

test('what stays is not drawn, so nothing is told', () => {
  const { plan } = open();
  plan({ keep: { layout: true, style: true, photos: false } });
  expect(told()).toBeUndefined();
});

test.each(['{', '5', '{"version":1,"families":[],"styles":{"a":"b","c":1e999,"d":null}}', '{"version":2}'])(
  'a record of garbage is no taste: %s',
  (text) => {
    kept.set('inkpanel.taste', text);
    const { taste, plan } = open();
    plan(free);
    expect(told()).toEqual({ families: {}, styles: {} });
    expect(taste.on.value).toBe(true);
  },
);

test('where nothing can be kept, it learns as long as the page is there', () => {
  const refuse = () => {
    throw new Error('no storage');
  };
  const { taste, plan } = open({ getItem: refuse, setItem: refuse });
  taste.learn(page('grid-4', 'pop'));
  plan(free);
  expect(told().styles.pop).toBeGreaterThan(0);
});
