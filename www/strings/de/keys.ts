export const keyStrings = {
  letterKeys: 'Kürzel mit einem Buchstaben',
  // As the keyboard calls them; what is called alike everywhere is not here.
  keyNames: {
    Ctrl: 'Strg',
    Space: 'Leertaste',
    Shift: 'Umschalt',
    Enter: 'Eingabe',
    PageUp: 'Bild auf',
    PageDown: 'Bild ab',
  },
  // What the list says of keys that are no action with a name of its own.
  keyAbout: {
    walk: 'Von Panel zu Panel gehen',
    turn: 'Zwischen den Seiten blättern',
    frame: 'Das Foto eines Panels mit den Pfeilen bewegen',
    scrub: 'Früheres oder späteres Einzelbild eines Videos, mit Umschalt um eine Sekunde',
    zoom: 'Das Foto eines Panels vergrößern, verkleinern, zurücksetzen',
    choose: 'Ein Panel auswählen',
    slant: 'Eine Trennlinie des Layouts neigen',
    list: 'Diese Liste',
  },
};
