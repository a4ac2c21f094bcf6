import { useEffect } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { Picture } from './picture.tsx';

/** Projects that fit into one row of the start screen. */
const SHOWN = 4;

/** The recent projects. */
export function RecentProjects() {
  const { keeping } = useApp();
  const recent = [...keeping.list.value].sort((a, b) => b.changed - a.changed).slice(0, SHOWN);
  useEffect(() => void keeping.refresh().catch(() => {}), []);
  if (recent.length === 0) return null;
  return (
    <section class="recent" aria-label={strings.recentProjects}>
      <h2>{strings.recentProjects}</h2>
      <ul>
        {recent.map(({ id, name, changed, picture }) => (
          <li key={id}>
            <button
              type="button"
              aria-label={strings.openNamed({ name: name || strings.untitled })}
              disabled={keeping.busy.value}
              onClick={() => void keeping.open(id)}
            >
              <span class="project-picture">{picture && <Picture blob={picture} />}</span>
              <strong>{name || strings.untitled}</strong>
              <span>{changed > 0 ? strings.moment(changed) : ''}</span>
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}
