export const keyStrings = {
  letterKeys: 'Atalhos de uma letra',
  // Labels of the keys. Keys with the same label in every language are missing.
  keyNames: { Ctrl: 'Ctrl', Space: 'Espaço', Shift: 'Shift', Enter: 'Enter', PageUp: 'Page Up', PageDown: 'Page Down' },
  // Descriptions of keys that belong to no named action.
  keyAbout: {
    walk: 'Ir de um quadro a outro',
    turn: 'Ir de uma página a outra',
    frame: 'Mover a foto de um quadro com as setas',
    scrub: 'Imagem anterior ou seguinte de um vídeo; com Shift, um segundo',
    zoom: 'Ampliar ou reduzir a foto de um quadro, ou redefini-la',
    choose: 'Selecionar um quadro',
    slant: 'Inclinar uma divisória do layout',
    sizeInset: 'Mudar o tamanho de um encaixe',
    originals: 'Segurar para ver as fotos originais',
    list: 'Esta lista',
  },
};
