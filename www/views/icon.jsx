// @ts-check
/**
 * The icons: strokes on a 24-unit grid, drawn in the colour of the text.
 */

/** @type {Record<string, string>} */
const PATHS = {
  shuffle: 'M3 7h3.2c1.5 0 2.8.7 3.7 1.9l4.2 6.2c.9 1.2 2.2 1.9 3.7 1.9H21M3 17h3.2c1.5 0 2.8-.7 3.7-1.9M14.1 8.9c.9-1.2 2.2-1.9 3.7-1.9H21M18.5 4.5 21 7l-2.5 2.5M18.5 14.5 21 17l-2.5 2.5',
  layout: 'M4 4h16v16H4zM4 11h16M13 11v9',
  style: 'M12 3a9 9 0 1 0 0 18V3zM12 7l5.5 0M12 11h8.5M12 15h8M12 19h4.5',
  photos: 'M7 4h13v13H7zM4 8v12h13M7 14l4-4 3 3 2-2 4 4',
  lock: 'M6 11h12v9H6zM8.5 11V8a3.5 3.5 0 0 1 7 0v3',
  unlock: 'M6 11h12v9H6zM8.5 11V7a3.5 3.5 0 0 1 6.8-1.2',
  undo: 'M8.5 5 4 9.5 8.5 14M4.5 9.5H14a5.5 5.5 0 0 1 0 11h-3',
  redo: 'M15.5 5 20 9.5 15.5 14M19.5 9.5H10a5.5 5.5 0 0 0 0 11h3',
  previous: 'M14.5 5.5 8 12l6.5 6.5',
  next: 'M9.5 5.5 16 12l-6.5 6.5',
  download: 'M12 4v11M7.5 11l4.5 4.5 4.5-4.5M4.5 20h15',
  export: 'M12 15V4M8 7.5 12 3.5l4 4M6 11H5v9h14v-9h-1',
  add: 'M12 5v14M5 12h14',
  close: 'M6 6l12 12M18 6 6 18',
  moon: 'M19.5 14.5A8 8 0 0 1 9.5 4.5a8 8 0 1 0 10 10z',
  sun: 'M12 8a4 4 0 1 0 0 8 4 4 0 0 0 0-8zM12 2.5v2M12 19.5v2M2.5 12h2M19.5 12h2M5.3 5.3l1.4 1.4M17.3 17.3l1.4 1.4M5.3 18.7l1.4-1.4M17.3 6.7l1.4-1.4',
  help: 'M8.5 9a3.5 3.5 0 1 1 5 3.2c-.9.5-1.5 1.1-1.5 2.3M12 18.3v.2',
  settings: 'M4 7h9M17 7h3M4 17h3M11 17h9M15 5v4M9 15v4',
  surprise: 'M12 3.5l1.9 5.1 5.1 1.9-5.1 1.9L12 17.5l-1.9-5.1L5 10.5l5.1-1.9zM19 15.5v4M17 17.5h4',
  edit: 'M4 4h16v16H4zM4 14h16M12 4v4M12 11.5v2.5M9.5 9.8h5',
  save: 'M5 4h11l3 3v13H5zM8.5 4v5h6V4M8 20v-6.5h8V20',
  open: 'M3.5 19V6h6l2 2.5h7V11M3.5 19l3-8h14.5l-3 8z',
  bin: 'M5 7h14M10 7V4.5h4V7M7 7l.8 12.5h8.4L17 7M10.3 10.5v5.5M13.7 10.5v5.5',
  select: 'M5 4h3M11 4h2M16 4h3v3M19 10v2M5 7v-3M5 10v3M5 16v3h3M11 19h1M14.5 13l6 2.5-2.7 1.1-1.1 2.7z',
  merge: 'M4 5h16v14H4zM12 5v2.5M12 16.5V19M7 12h3.5M13.5 12H17M9 10.2l1.8 1.8L9 13.8M15 10.2 13.2 12l1.8 1.8',
  split: 'M4 5h16v14H4zM12 5v14M9.5 12H6.2M14.5 12h3.3M7.5 10.4 6 12l1.5 1.6M16.5 10.4 18 12l-1.5 1.6',
  rows: 'M5 4h14v16H5zM5 12h14',
  columns: 'M4 5h16v14H4zM12 5v14',
  zoomIn: 'M10.5 4a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zM15.3 15.3 20.5 20.5M10.5 7.8v5.4M7.8 10.5h5.4',
  zoomOut: 'M10.5 4a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zM15.3 15.3 20.5 20.5M7.8 10.5h5.4',
  fit: 'M4 8V4h4M16 4h4v4M20 16v4h-4M8 20H4v-4M12 8.5a2 2 0 1 0 0 4 2 2 0 0 0 0-4zM8.5 17c.4-2 1.7-3 3.5-3s3.1 1 3.5 3',
  reset: 'M4.5 9.5A8 8 0 1 1 4 12M4.5 4.5v5h5',
  swap: 'M4 8.5h14M14.5 5 18 8.5 14.5 12M20 15.5H6M9.5 12 6 15.5 9.5 19',
  focus: 'M12 6.5a5.5 5.5 0 1 0 0 11 5.5 5.5 0 0 0 0-11zM12 3v4M12 17v4M3 12h4M17 12h4M12 12v.1',
  put: 'M4 12h12M11.5 7 16.5 12l-5 5M20 4v16',
  check: 'M5 12.5l4.5 4.5L19 7.5',
  alert: 'M12 4 2.8 20h18.4zM12 10v4.5M12 17.3v.2',
};

/** @param {{ name: string }} props */
export function Icon({ name }) {
  return (
    <svg class="icon" viewBox="0 0 24 24" aria-hidden="true">
      <path d={PATHS[name]} />
    </svg>
  );
}
