export const keyStrings = {
  letterKeys: 'Atalhos de uma letra',
  // As the keyboard calls them; what is called alike everywhere is not here.
  keyNames: { Ctrl: 'Ctrl', Space: 'Espaço', Shift: 'Shift', Enter: 'Enter', PageUp: 'Page Up', PageDown: 'Page Down' },
  // What the list says of keys that are no action with a name of its own.
  keyAbout: {
    walk: 'Ir de um quadro a outro',
    turn: 'Ir de uma página a outra',
    frame: 'Mover a foto de um quadro com as setas',
    scrub: 'Imagem anterior ou seguinte de um vídeo; com Shift, um segundo',
    zoom: 'Ampliar ou reduzir a foto de um quadro, ou redefini-la',
    choose: 'Selecionar um quadro',
    slant: 'Inclinar uma divisória do layout',
    list: 'Esta lista',
  },
};
