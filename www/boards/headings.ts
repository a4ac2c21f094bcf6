/** The names of the columns of a shot list in every language of the app, so that a list saved in one language is read in all. */

/** The columns of a list that is saved. */
const SAVED: readonly (readonly string[])[] = [
  ['Scene', 'Shot', 'Picture', 'Film', 'Time code', 'Duration', 'Frames', 'Action', 'Dialogue', 'Notes'],
  ['Szene', 'Einstellung', 'Bild', 'Film', 'Timecode', 'Dauer', 'Bilder', 'Handlung', 'Dialog', 'Notizen'],
  ['Escena', 'Plano', 'Imagen', 'Película', 'Código de tiempo', 'Duración', 'Fotogramas', 'Acción', 'Diálogo', 'Notas'],
  ['Scène', 'Plan', 'Image', 'Film', 'Timecode', 'Durée', 'Images', 'Action', 'Dialogue', 'Notes'],
  ['シーン', 'カット', '画像', '映像', 'タイムコード', '長さ', 'フレーム', '内容', '台詞', 'メモ'],
  ['Cena', 'Plano', 'Imagem', 'Filme', 'Código de tempo', 'Duração', 'Quadros', 'Ação', 'Diálogo', 'Notas'],
];

/** Alternative names: the headings of the app's table, because users copy it to spreadsheets. */
const SHOWN: readonly (readonly string[])[] = [
  ['', '', '', '', '', 'Length'],
  ['', '', '', '', '', 'Länge'],
];

export const HEADINGS: readonly (readonly string[])[] = [...SAVED, ...SHOWN];
