/** What the columns of a shot list are called in every language of the page: a list that was saved in one is read in all. */

export const HEADINGS: readonly (readonly string[])[] = [
  ['Scene', 'Shot', 'Picture', 'Film', 'Time code', 'Duration', 'Frames', 'Action', 'Dialogue', 'Notes'],
  ['Szene', 'Einstellung', 'Bild', 'Film', 'Timecode', 'Dauer', 'Bilder', 'Handlung', 'Dialog', 'Notizen'],
  ['Escena', 'Plano', 'Imagen', 'Película', 'Código de tiempo', 'Duración', 'Fotogramas', 'Acción', 'Diálogo', 'Notas'],
  ['Scène', 'Plan', 'Image', 'Film', 'Timecode', 'Durée', 'Images', 'Action', 'Dialogue', 'Notes'],
  ['シーン', 'カット', '画像', '映像', 'タイムコード', '長さ', 'フレーム', '内容', '台詞', 'メモ'],
  ['Cena', 'Plano', 'Imagem', 'Filme', 'Código de tempo', 'Duração', 'Quadros', 'Ação', 'Diálogo', 'Notas'],
];
