import { expect, it } from 'vitest';
import { createPreviewLoop } from './preview-loop.ts';

const settle = (ms = 5) =>
  new Promise((done) => {
    setTimeout(done, ms);
  });

function loop(draw: (style: any) => any = () => ({}), whole = false) {
  const calls: { style: any; stages: number; end: () => void }[] = [];
  const shown: any[] = [];
  const told: string[] = [];
  let busy = false;
  const picture = async (style: any, { stages = 0 }: any): Promise<any> => {
    await new Promise((end: (value?: any) => void) => calls.push({ style, stages, end }));
    return { ...draw(style), bitmap: style, stages: [] };
  };
  const made = createPreviewLoop({
    draw: picture,
    drawCards: async (style: any, size: any) => ({ designed: await picture(style, size), whole }),
    drawWhole: async (style: any): Promise<any> => ({ bitmap: `full ${style}` }),
    cards: () => true,
    onPicture: ({ bitmap }) => shown.push(bitmap),
    onStages: () => shown.push('cards'),
    onBusy: (now) => {
      busy = now;
    },
    onError: ({ message }) => told.push(message),
  });
  const show = (style: any) => made.show({ style, width: 960, height: 540, full: 1920 });
  return { made, calls, shown, told, show, busy: () => busy };
}

it('draws one, lets one wait, and passes over what was overtaken', async () => {
  const { show, calls, shown } = loop();
  for (const style of ['a', 'b', 'c', 'd', 'e']) show(style);
  expect(calls.map(({ style }) => style)).toEqual(['a', 'b']);
  calls[0].end();
  await settle();
  expect(calls.map(({ style }) => style)).toEqual(['a', 'b', 'e']);
  calls[1].end();
  calls[2].end();
  await settle();
  expect(shown).toEqual(['a', 'b', 'e']);
});

it('refines when the hand rests: the cards first, then the full size', async () => {
  const { show, calls, shown, busy } = loop();
  show('a');
  calls[0].end();
  await settle(200);
  expect([calls[1].stages > 0, busy()]).toEqual([true, true]);
  calls[1].end();
  await settle();
  expect([shown, busy()]).toEqual([['a', 'cards', 'full a'], false]);
});

it('shows the picture that comes with the cards where it is the same one', async () => {
  const { show, calls, shown } = loop(undefined, true);
  show('a');
  calls[0].end();
  await settle(200);
  calls[1].end();
  await settle();
  expect(shown).toEqual(['a', 'a', 'cards', 'full a']);
});

it('says what fails, and goes on with the next', async () => {
  const { show, calls, told, shown } = loop((style) => {
    if (style === 'bad') throw Object.assign(new Error('no such block'), { code: 'invalid-style' });
    return {};
  });
  show('bad');
  calls[0].end();
  await settle();
  show('good');
  calls[1].end();
  await settle();
  expect([told, shown]).toEqual([['no such block'], ['good']]);
});

it('shows nothing once it is closed', async () => {
  const { made, show, calls, shown } = loop();
  show('a');
  made.dispose();
  calls[0].end();
  await settle(200);
  expect([shown, calls.length]).toEqual([[], 1]);
});
