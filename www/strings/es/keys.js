// @ts-check
export const keyStrings = {
  letterKeys: 'Las letras sueltas son atajos',
  keyList: [
    { keys: ['Espacio'], does: 'Barajar' },
    { keys: ['L'], does: 'Barajar plantilla' },
    { keys: ['S'], does: 'Barajar estilo' },
    { keys: ['P'], does: 'Barajar fotos' },
    { keys: ['Ctrl', 'Z'], does: 'Deshacer' },
    { keys: ['Mayús', 'Ctrl', 'Z'], does: 'Rehacer' },
    { keys: ['←', '↑', '→', '↓'], does: 'Pasar de una viñeta a otra' },
    { keys: ['Re Pág', 'Av Pág'], does: 'Ir de una página a otra' },
    { keys: ['Intro'], does: 'Mover la foto de una viñeta con las flechas' },
    { keys: [',', '.'], does: 'Fotograma anterior o posterior de un vídeo; con Mayús, un segundo' },
    { keys: ['+', '−', '0'], does: 'Ampliar o reducir la foto de una viñeta, o restablecerla' },
    { keys: ['Mayús', 'Intro'], does: 'Seleccionar una viñeta' },
    { keys: ['Alt', '↑', '↓'], does: 'Inclinar un corte de la plantilla' },
    { keys: ['Ctrl', 'S'], does: 'Descargar PNG' },
    { keys: ['?'], does: 'Esta lista' },
  ],
};
