//! Made-up sounds.
#![allow(clippy::unwrap_used, reason = "a test may panic")]

use super::*;
use proptest::prelude::*;
use std::f32::consts::TAU;

const RATE: f32 = 16_000.0;

/// Seconds of noise of that amplitude.
fn noise(seconds: f32, amplitude: f32) -> Vec<f32> {
    let mut random = oorandom::Rand32::new(11);
    (0..(seconds * RATE) as usize).map(|_| amplitude * (2.0 * random.rand_float() - 1.0)).collect()
}

/// Adds a sound that begins at `start`; `sound` is given seconds since then.
fn add(samples: &mut [f32], start: f32, length: f32, sound: impl Fn(f32) -> f32) {
    let first = (start * RATE).round() as usize;
    for (i, sample) in samples.iter_mut().skip(first).take((length * RATE) as usize).enumerate() {
        *sample += sound(i as f32 / RATE);
    }
}

/// Noise that dies away at once.
fn click(samples: &mut [f32], start: f32, loud: f32) {
    let grain = noise(0.1, loud);
    add(samples, start, 0.1, |t| grain[(t * RATE) as usize] * (-t / 0.008).exp());
}

fn kinds(events: &[Event]) -> Vec<Kind> {
    events.iter().map(|event| event.kind).collect()
}

/// A tone of full scale.
fn tone(hertz: f32, t: f32) -> f32 {
    (TAU * hertz * t).sin()
}

#[test]
fn clicks_are_found_where_they_are_and_nothing_else_in_noise() {
    let times = [0.4, 0.953, 1.5, 2.7, 3.111, 4.6];
    for low in [0.0, 0.001, 0.004] {
        let mut samples = noise(6.0, low);
        for &time in &times {
            click(&mut samples, time, 0.7);
        }
        let found = events(samples, RATE);
        assert_eq!(found.len(), times.len(), "{low}: {found:?}");
        for (event, time) in found.iter().zip(times) {
            assert_eq!(event.kind, Kind::Hit);
            assert!((event.start - f64::from(time)).abs() < 0.02, "{low}, {time}: {event:?}");
            assert!(event.end - event.start < 0.12, "{event:?}");
        }
    }
}

#[test]
fn silence_and_what_only_hisses_give_nothing() {
    assert_eq!(events(vec![0.0; 48_000], RATE), []);
    for amplitude in [0.001, 0.1, 0.9] {
        assert_eq!(events(noise(5.0, amplitude), RATE), [], "{amplitude}");
    }
    assert_eq!(events(Vec::new(), RATE), []);
    assert_eq!(events(vec![0.5; 100], RATE), []);
}

#[test]
fn a_tone_that_rises_and_a_noise_that_swells_sweep_past() {
    for (from, to) in [(200.0f32, 3000.0f32), (3000.0, 250.0)] {
        let mut samples = noise(3.0, 0.0005);
        // Its phase is the integral of a frequency that grows by octaves.
        let octaves = (to / from).log2();
        let phase =
            |t: f32| from * 0.8 / octaves * ((octaves * t / 0.8).exp2() - 1.0) / std::f32::consts::LN_2;
        add(&mut samples, 1.0, 0.8, |t| 0.5 * (TAU * phase(t)).sin());
        let found = events(samples, RATE);
        assert_eq!(kinds(&found), [Kind::Sweep], "{from} to {to}: {found:?}");
        assert!(found[0].words.contains(&Word::Whoosh), "{found:?}");
        assert!((found[0].start - 1.0).abs() < 0.05 && (found[0].end - 1.8).abs() < 0.06, "{found:?}");
    }
    let mut samples = noise(3.0, 0.0005);
    let air = noise(0.8, 0.5);
    add(&mut samples, 1.0, 0.8, |t| air[(t * RATE) as usize] * (TAU / 2.0 * t / 0.8).sin().powi(2));
    let found = events(samples, RATE);
    assert_eq!(kinds(&found), [Kind::Sweep], "{found:?}");
}

#[test]
fn a_chord_that_holds_is_music_and_so_are_notes_one_after_the_other() {
    let mut samples = noise(6.0, 0.0005);
    add(&mut samples, 1.0, 4.0, |t| [261.6, 329.6, 392.0].iter().map(|&hertz| 0.15 * tone(hertz, t)).sum());
    let found = events(samples, RATE);
    assert_eq!(kinds(&found), [Kind::Music], "{found:?}");
    assert!((found[0].start - 1.0).abs() < 0.5 && (found[0].end - 5.0).abs() < 0.5, "{found:?}");
    assert_eq!(found[0].words[0], Word::Note);
    let mut samples = noise(8.0, 0.0005);
    for i in 0..16u8 {
        let hertz = 220.0 * (f32::from([0u8, 4, 7, 12, 7, 4, 5, 9][usize::from(i % 8)]) / 12.0).exp2();
        let string = |t: f32| (1..6u8).map(|n| tone(hertz * f32::from(n), t) / f32::from(n)).sum::<f32>();
        add(&mut samples, 0.5 * f32::from(i), 0.6, |t| 0.2 * string(t) * (-t / 0.4).exp());
    }
    click(&mut samples, 4.2, 3.0);
    let found = events(samples, RATE);
    assert_eq!(
        kinds(&found),
        [Kind::Music, Kind::Hit],
        "sounds louder than the music are detected: {found:?}"
    );
}

#[test]
fn words_follow_loudness_length_and_pitch() {
    let best = |hertz: f32, loud: f32, fades: f32| {
        let mut samples = noise(3.0, 0.0005);
        let grain = noise(2.0, 1.0);
        // Noise about a frequency.
        add(&mut samples, 1.0, 1.5, |t| {
            loud * (-t / fades).exp() * tone(hertz, t) * (0.95 + 0.05 * grain[(t * RATE) as usize])
        });
        let found = events(samples, RATE);
        assert_eq!(kinds(&found), [Kind::Hit], "{hertz} {loud} {fades}: {found:?}");
        found[0].words[0]
    };
    assert_eq!(best(90.0, 0.9, 0.3), Word::Boom);
    assert_eq!(best(90.0, 0.12, 0.015), Word::Thump);
    assert_eq!(best(3500.0, 0.9, 0.01), Word::Clap);
    assert_eq!(best(3500.0, 0.06, 0.4), Word::Ding);
}

#[test]
fn what_begins_in_speech_is_left_out_unless_it_is_louder() {
    // Vowels, each after a burst like t or k, which has no tone.
    let mut samples = noise(6.0, 0.0005);
    let burst = noise(0.05, 0.2);
    for i in 0..10u8 {
        let start = 0.5 + 0.4 * f32::from(i);
        add(&mut samples, start, 0.03, |t| burst[(t * RATE) as usize]);
        let buzz = |t: f32| (1..12u8).map(|n| tone(130.0 * f32::from(n), t) / f32::from(n)).sum::<f32>();
        add(&mut samples, start + 0.08, 0.16, |t| {
            0.2 * buzz(t) * (t / 0.03).min(1.0) * ((0.16 - t) / 0.05).min(1.0)
        });
    }
    assert_eq!(events(samples.clone(), RATE), []);
    click(&mut samples, 2.45, 4.0);
    let found = events(samples, RATE);
    assert_eq!(kinds(&found), [Kind::Hit], "{found:?}");
    assert!((found[0].start - 2.45).abs() < 0.02, "{found:?}");
}

#[test]
fn what_a_voice_says_is_left_out() {
    let mut samples = noise(4.0, 0.0005);
    for (start, pitch) in [(0.5, 120.0), (1.0, 140.0), (1.4, 110.0), (2.2, 210.0)] {
        let vowel = |t: f32| {
            let partial = |n: u8| {
                let hertz = pitch * (1.0 - 0.2 * t) * f32::from(n);
                let formants = 1.0 / (1.0 + ((hertz - 700.0) / 200.0).powi(2))
                    + 0.5 / (1.0 + ((hertz - 1200.0) / 200.0).powi(2));
                formants * tone(hertz, t)
            };
            (1..20).map(partial).sum::<f32>()
        };
        add(&mut samples, start, 0.25, |t| {
            0.3 * vowel(t) * (t / 0.03).min(1.0) * ((0.25 - t) / 0.05).min(1.0)
        });
    }
    assert_eq!(events(samples, RATE), []);
}

#[test]
fn json_is_as_serde_writes_it() {
    use Word::{
        Bang, Boom, Clang, Clap, Click, Clink, Crack, Crash, Ding, Knock, Note, Notes, Rumble, Slam, Snap,
        Swish, Tap, Thud, Thump, Tick, Tune, Vroom, Whoosh, Zip, Zoom,
    };
    let event = |start: f64, kind, words| Event { start, end: start + 0.25, kind, loudness: -7, words };
    let words = [
        [Bang, Boom, Clang],
        [Clap, Click, Clink],
        [Crack, Crash, Ding],
        [Knock, Note, Notes],
        [Rumble, Slam, Snap],
        [Swish, Tap, Thud],
        [Thump, Tick, Tune],
        [Vroom, Whoosh, Zip],
        [Zoom, Zoom, Zoom],
    ];
    let kinds = [Kind::Hit, Kind::Sweep, Kind::Music].into_iter().cycle();
    let events: Vec<Event> =
        words.into_iter().zip(kinds).map(|(words, kind)| event(61.005, kind, words)).collect();
    let value = |text: &str| serde_json::from_str::<serde_json::Value>(text).unwrap();
    assert_eq!(value(&to_json(&events)), serde_json::to_value(&events).unwrap());
    assert_eq!(to_json(&[]), "[]");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn any_samples_are_heard(
        seeds in prop::collection::vec(prop_oneof![8 => -1.0f32..1.0, 1 => any::<f32>()], 0..400),
        repeat in 1usize..60,
        rate in prop_oneof![3 => 4000.0f32..60_000.0, 1 => any::<f32>()],
    ) {
        let samples: Vec<f32> = seeds.iter().flat_map(|&sample| std::iter::repeat_n(sample, repeat)).collect();
        let length = samples.len() as f64 / f64::from(rate);
        let found = events(samples, rate);
        prop_assert!(found.windows(2).all(|pair| pair[0].start <= pair[1].start));
        for event in found {
            prop_assert!(0.0 <= event.start && event.start < event.end, "{:?}", event);
            prop_assert!(event.start <= length + 0.01 && event.end <= length + 0.05, "{:?} of {}", event, length);
        }
    }
}
