import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';

/** Controls of the difference between children and parents, and of the random seed. */
export function Dials() {
  const { explorer } = useApp();
  const surprise = explorer.surprise.value;
  return (
    <>
      <label class="dial">
        <span>{strings.surpriseDial}</span>
        <input
          type="range"
          min="0"
          max="1"
          step="0.05"
          value={surprise}
          aria-valuetext={strings.percent(surprise)}
          onInput={(event) => {
            explorer.surprise.value = event.currentTarget.valueAsNumber;
          }}
        />
      </label>
      <details class="dial-more">
        <summary>{strings.moreSettings}</summary>
        <label class="dial">
          <span>{strings.firstSeed}</span>
          <input
            class="number seed"
            type="number"
            min="0"
            max="4294967295"
            step="1"
            value={explorer.first.value}
            onChange={({ currentTarget }) => {
              const value = Math.round(currentTarget.valueAsNumber);
              if (value >= 0 && value < 2 ** 32) explorer.begin(value);
              currentTarget.value = String(explorer.first.peek());
            }}
          />
        </label>
      </details>
    </>
  );
}
