/** The names of the columns of a shot list in every language of the app, so that a list saved in one language is read in all. */

/** The columns of a list that is saved. */
const SAVED: readonly (readonly string[])[] = [
  ['Scene', 'Shot', 'Picture', 'Film', 'Time code', 'Duration', 'Frames', 'Action', 'Dialogue', 'Notes', 'Caption', 'Sound'],
  ['Szene', 'Einstellung', 'Bild', 'Film', 'Timecode', 'Dauer', 'Bilder', 'Handlung', 'Dialog', 'Notizen', 'Textkasten', 'Ton'],
  ['Escena', 'Plano', 'Imagen', 'Película', 'Código de tiempo', 'Duración', 'Fotogramas', 'Acción', 'Diálogo', 'Notas', 'Cartela', 'Sonido'],
  ['Scène', 'Plan', 'Image', 'Film', 'Timecode', 'Durée', 'Images', 'Action', 'Dialogue', 'Notes', 'Cartouche', 'Son'],
  ['シーン', 'カット', '画像', '映像', 'タイムコード', '長さ', 'フレーム', '内容', '台詞', 'メモ', 'キャプション', '効果音'],
  ['Cena', 'Plano', 'Imagem', 'Filme', 'Código de tempo', 'Duração', 'Quadros', 'Ação', 'Diálogo', 'Notas', 'Caixa de texto', 'Som'],
];

/** Names in the table of the app, which is copied to spreadsheets, and names that other programs use. */
const SHOWN: readonly (readonly (readonly string[])[])[] = [
  [
    [
      'Scene No',
      'Scene Number',
      'Sc',
      'Szene Nr',
      'Szenennummer',
      'Escena Nº',
      'Séquence',
      'N° de scène',
      'シーン番号',
      'Nº da cena',
    ],
    [
      'Shot No',
      'Shot Number',
      'Einstellung Nr',
      'Einstellungsnummer',
      'Toma',
      'N° de plan',
      'ショット',
      'カット番号',
      'Nº do plano',
    ],
    [],
    [],
    [],
    ['Length', 'Dur', 'Länge', '尺'],
    [],
    ['Description', 'Shot Description', 'Beschreibung', 'Descripción', 'Descrição', '説明'],
    ['Dialog', 'Lines', 'Dialoge', 'Diálogos', 'Dialogues', 'セリフ'],
    [
      'Note',
      'Comment',
      'Comments',
      'Remarks',
      'Anmerkungen',
      'Bemerkungen',
      'Observaciones',
      'Comentarios',
      'Remarques',
      '備考',
      'Observações',
      'Comentários',
    ],
    ['Captions', 'Textkästen', 'Cartelas', 'Cartouches', 'Caixas de texto'],
    ['Sounds', 'SFX', 'Sound effects', 'Töne', 'Geräusche', 'Sonidos', 'Sons', 'Bruitages', '音'],
  ],
];

/** Lists of names by place. A place may have several names in a list. */
export const HEADINGS: readonly (readonly (string | readonly string[])[])[] = [...SAVED, ...SHOWN];
