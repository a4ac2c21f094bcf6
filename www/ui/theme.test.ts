import { expect, it } from 'vitest';
import { createTheme } from './theme.ts';

/** A window of a system that becomes dark, with its storage. */
function fakeWindow({ dark = false, kept = {} as Record<string, string>, refuses = false } = {}) {
  const root = { dataset: {} as Record<string, string> };
  const metas = ['light', 'dark'].map((own) => ({
    media: `(prefers-color-scheme: ${own})`,
    dataset: {} as Record<string, string>,
  }));
  const list = { matches: dark, addEventListener: (_: string, hear: () => void) => heard.push(hear) };
  const heard: (() => void)[] = [];
  const refuse = () => {
    throw new DOMException('no storage', 'SecurityError');
  };
  const box = {
    getItem: (key: string) => kept[key] ?? null,
    setItem: (key: string, value: string) => void (kept[key] = value),
    removeItem: (key: string) => void delete kept[key],
  };
  const window = {
    document: { documentElement: root, querySelectorAll: () => metas },
    matchMedia: () => list,
    get localStorage() {
      return refuses ? refuse() : box;
    },
  };
  return {
    root,
    kept,
    bars: () => metas.map(({ media }) => media),
    theme: createTheme(window as unknown as Window),
    turn(to: boolean) {
      list.matches = to;
      for (const hear of heard) hear();
    },
  };
}

it('is that of the system, as it changes, until one is chosen', () => {
  const { theme, root, turn } = fakeWindow();
  expect([theme.theme.value, theme.dark.value, root.dataset]).toEqual(['system', false, {}]);
  turn(true);
  expect([theme.dark.value, root.dataset]).toEqual([true, {}]);
  theme.useTheme('light');
  expect([theme.dark.value, root.dataset]).toEqual([false, { theme: 'light' }]);
});

it('is kept, and that of the system again when one asks for it', () => {
  const kept = { 'inkpanel.theme': 'dark' };
  const { theme, root } = fakeWindow({ kept });
  expect([theme.dark.value, root.dataset.theme]).toEqual([true, 'dark']);
  theme.useTheme('light');
  expect(kept).toEqual({ 'inkpanel.theme': 'light' });
  theme.useTheme('system');
  expect([kept, root.dataset, theme.dark.value]).toEqual([{}, {}, false]);
});

it('is chosen where nothing can be kept, and what is kept may be nonsense', () => {
  const { theme, root } = fakeWindow({ refuses: true });
  theme.useTheme('dark');
  expect([theme.dark.value, root.dataset.theme]).toEqual([true, 'dark']);
  expect(fakeWindow({ kept: { 'inkpanel.theme': 'pink' } }).theme.theme.value).toBe('system');
});

it('colours the bars of the browser', () => {
  const { theme, bars } = fakeWindow();
  const asSystem = ['(prefers-color-scheme: light)', '(prefers-color-scheme: dark)'];
  expect(bars()).toEqual(asSystem);
  theme.useTheme('dark');
  expect(bars()).toEqual(['not all', 'all']);
  theme.useTheme('light');
  expect(bars()).toEqual(['all', 'not all']);
  theme.useTheme('system');
  expect(bars()).toEqual(asSystem);
});
