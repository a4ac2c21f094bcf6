export const keyStrings = {
  letterKeys: 'Atajos de una letra',
  // Labels of the keys. Keys with the same label in every language are missing.
  keyNames: { Ctrl: 'Ctrl', Space: 'Espacio', Shift: 'Mayús', Enter: 'Intro', PageUp: 'Re Pág', PageDown: 'Av Pág' },
  // Descriptions of keys that belong to no named action.
  keyAbout: {
    walk: 'Pasar de una viñeta a otra',
    turn: 'Ir de una página a otra',
    frame: 'Mover la foto de una viñeta con las flechas',
    scrub: 'Fotograma anterior o posterior de un vídeo; con Mayús, un segundo',
    zoom: 'Ampliar o reducir la foto de una viñeta, o restablecerla',
    choose: 'Seleccionar una viñeta',
    slant: 'Inclinar una división de la plantilla',
    sizeInset: 'Cambiar el tamaño de un recuadro',
    originals: 'Mantener pulsada para ver las fotos originales',
    list: 'Esta lista',
  },
};
