//! Quality of subject masks: compares the masks of the model with manually marked subjects.

#[path = "../../examples/subjects/measure.rs"]
mod measure;

use std::fs;

use inkpanel_engine::detect::Segmenter;
use measure::{HELD_OUT, Measured, TUNED, WIDTH, measure};

/// Intersection over union, in the mean of each half.
const OVERLAP: f64 = 0.85;

#[test]
fn masks_are_what_a_person_would_cut_out() {
    let model = crate::root("www/models/subject.onnx");
    let onnx = fs::read(model).expect("run `cargo xtask models`");
    let net = Segmenter::new(&onnx).unwrap();
    for (half, names) in [("tuned on", &TUNED[..]), ("held out", &HELD_OUT[..])] {
        let found: Vec<Measured> = names.iter().map(|name| measure(&net, name).unwrap()).collect();
        for (name, found) in names.iter().zip(&found) {
            let Measured { overlap, near, sure, covers, .. } = found;
            println!("{name}: {overlap:.3}, border {near:.2?}, sure {sure:.2}, covers {covers:.2}");
            assert_eq!(found.picture.width(), WIDTH, "{name}");
            assert_eq!(found.mask.len(), found.mark.len(), "{name}");
            assert!(found.mark.contains(&true), "{name} has a mark");
        }
        let mean = |of: &dyn Fn(&Measured) -> f64| found.iter().map(of).sum::<f64>() / found.len() as f64;
        let overlap = mean(&|found| found.overlap);
        let border = [0, 1].map(|i| mean(&|found| found.near[i]));
        println!("{half}, {}: {overlap:.3}, border {border:.3?}", names.len());
        assert!(overlap >= OVERLAP, "{half}: {overlap:.3} of {OVERLAP}");
    }
}
