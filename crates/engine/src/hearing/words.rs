//! Selects sound effects for a sound, from a small table by loudness, length and pitch.

use super::{Kind, Word};
use Word::{
    Bang, Boom, Clang, Clap, Click, Clink, Crack, Crash, Ding, Knock, Note, Notes, Rumble, Slam, Snap, Swish,
    Tap, Thud, Thump, Tick, Tune, Vroom, Whoosh, Zip, Zoom,
};

/// Minimum level of a loud sound in dB below full scale.
const LOUD: f32 = -24.0;
/// Maximum duration of a short impact and minimum duration of a long one, in seconds.
const SHORT: f32 = 0.12;
const LONG: f32 = 0.4;
/// Range of spectral centroids in Hz of impacts that are neither low nor high.
const LOW: f32 = 600.0;
const HIGH: f32 = 2500.0;

/// Sound effects of loud and quiet impacts, by length, then by pitch. The best one is first.
const HITS: [[[[Word; 3]; 3]; 3]; 2] = [
    [
        [[Thud, Bang, Boom], [Bang, Crack, Slam], [Clap, Crack, Snap]],
        [[Boom, Thud, Bang], [Bang, Slam, Crash], [Crash, Clap, Clang]],
        [[Boom, Rumble, Bang], [Crash, Boom, Bang], [Crash, Clang, Bang]],
    ],
    [
        [[Thump, Thud, Knock], [Knock, Tap, Click], [Click, Tick, Snap]],
        [[Thud, Thump, Knock], [Knock, Clap, Tap], [Clink, Tap, Snap]],
        [[Thud, Rumble, Boom], [Clang, Clap, Knock], [Ding, Clink, Clang]],
    ],
];

/// Sweeps by their pitch.
const SWEEPS: [[Word; 3]; 3] = [[Vroom, Rumble, Whoosh], [Whoosh, Zoom, Swish], [Swish, Whoosh, Zip]];

/// Returns three sound effects for a sound of `level` dB, with a duration of `length` seconds and its
/// centroid at `centroid` Hz.
pub(super) fn words(kind: Kind, level: f32, length: f32, centroid: f32) -> [Word; 3] {
    let step = |value: f32, [low, high]: [f32; 2]| usize::from(value >= low) + usize::from(value > high);
    let pitch = step(centroid, [LOW, HIGH]);
    match kind {
        Kind::Hit => HITS[usize::from(level < LOUD)][step(length, [SHORT, LONG])][pitch],
        Kind::Sweep => SWEEPS[pitch],
        Kind::Music => [Note, Notes, Tune],
    }
}
