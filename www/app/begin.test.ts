import { expect, test, vi } from 'vitest';
import { fakeApp } from '../document/testing.ts';
import { warmPlanner } from './begin.ts';

vi.useFakeTimers();

test('while the user chooses photos, pages are planned of an album that fills them, and the project stays', async () => {
  const { store, planner, scheduler } = fakeApp();
  const plan = vi.spyOn(planner, 'plan');
  const { value } = store.project;
  warmPlanner({ store, scheduler });
  await vi.runAllTimersAsync();
  const pages = plan.mock.results.map(({ value: page }) => new Set(page.panels.map(({ photo }: any) => photo)).size);
  expect(pages).toHaveLength(6);
  expect(Math.min(...pages)).toBeGreaterThan(2);
  expect(store.project.value).toBe(value);
});
