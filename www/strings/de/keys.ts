export const keyStrings = {
  letterKeys: 'Kürzel mit einem Buchstaben',
  // Labels of the keys. Keys with the same label in every language are missing.
  keyNames: {
    Ctrl: 'Strg',
    Space: 'Leertaste',
    Shift: 'Umschalt',
    Enter: 'Eingabe',
    PageUp: 'Bild auf',
    PageDown: 'Bild ab',
  },
  // Descriptions of keys that belong to no named action.
  keyAbout: {
    walk: 'Von Panel zu Panel gehen',
    turn: 'Zwischen den Seiten blättern',
    frame: 'Das Foto eines Panels mit den Pfeilen bewegen',
    scrub: 'Früheres oder späteres Einzelbild eines Videos, mit Umschalt um eine Sekunde',
    zoom: 'Das Foto eines Panels vergrößern, verkleinern, zurücksetzen',
    choose: 'Ein Panel auswählen',
    slant: 'Eine Trennlinie des Layouts neigen',
    sizeInset: 'Die Größe eines Einsatzes ändern',
    originals: 'Gedrückt halten: Originalfotos zeigen',
    list: 'Diese Liste',
  },
};
