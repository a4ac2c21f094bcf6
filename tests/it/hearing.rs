//! Sound detection in videos: it finds the onsets that librosa finds (`tests/oracles/hearing.py`), and no
//! others.

use inkpanel_engine::hearing::{Kind, events};
use serde_json::Value;
use std::f64::consts::TAU;
use std::fs;

/// Seconds that two may differ in when a sound begins, as is usual where onsets are judged (MIREX).
const NEAR: f64 = 0.05;

fn told() -> Value {
    let path = crate::root("tests/oracles/data/hearing.json");
    serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap()
}

/// The sound that the oracle made.
fn sound(told: &Value) -> Vec<f32> {
    let rate = told["rate"].as_f64().unwrap();
    let mut state = 1u32;
    let mut draw = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(state) / 2f64.powi(31) - 1.0
    };
    let noise: Vec<f64> = (0..(rate * told["seconds"].as_f64().unwrap()) as usize).map(|_| draw()).collect();
    let mut sound: Vec<f64> = noise.iter().map(|sample| 0.002 * sample).collect();
    for stroke in told["strokes"].as_array().unwrap() {
        let number = |name: &str| stroke[name].as_f64().unwrap();
        let first = (number("second") * rate).round() as usize;
        for i in 0..(rate / 2.0) as usize {
            let t = i as f64 / rate;
            let tone = number("tone");
            let wave = if tone > 0.0 { (TAU * tone * t).sin() } else { noise[i] };
            sound[first + i] += number("loudness") * (-t / number("fading")).exp() * wave;
        }
    }
    sound.into_iter().map(|sample| sample as f32).collect()
}

#[test]
fn hits_are_the_onsets_that_librosa_hears() {
    let told = told();
    let found = events(sound(&told), told["rate"].as_f64().unwrap() as f32);
    let heard: Vec<f64> = found.iter().map(|event| event.start).collect();
    let onsets: Vec<f64> =
        told["onsets"].as_array().unwrap().iter().map(|time| time.as_f64().unwrap()).collect();
    assert!(onsets.len() >= 18, "{}", onsets.len());
    assert!(found.iter().all(|event| event.kind == Kind::Hit), "{found:?}");
    let missed = |of: &[f64], among: &[f64]| {
        let alone = |time: &&f64| among.iter().all(|other| (*time - other).abs() > NEAR);
        of.iter().filter(alone).copied().collect::<Vec<_>>()
    };
    assert_eq!(missed(&onsets, &heard), [0.0; 0], "what librosa hears, of {heard:?}");
    assert_eq!(missed(&heard, &onsets), [0.0; 0], "what it does not, of {onsets:?}");
    for stroke in told["strokes"].as_array().unwrap() {
        let second = stroke["second"].as_f64().unwrap();
        assert!(heard.iter().any(|time| (time - second).abs() < 0.02), "{second} of {heard:?}");
    }
}
