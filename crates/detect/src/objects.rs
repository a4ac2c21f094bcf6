//! Objects: `SSDLite` on `MobileNetV2`, trained on COCO's eighty kinds of things, at 300 x 300 pixels.

use super::Detection;
use super::letterbox::letterbox;
use super::model::Net;
use super::ssd::{Anchor, Candidate, decode, mobilenet_anchors, sigmoid, suppress};
use inkpanel_image::error::{Error, Result};
use inkpanel_image::raster::Image;
use inkpanel_image::raster::resize::Region;

const SIDE: usize = 300;
/// Scores per anchor: the background, then COCO's classes 1 to 90. Ten of these numbers are unused.
const CLASSES: usize = 91;
const THRESHOLD: f64 = 0.4;
const SAME: f64 = 0.5;

/// The object detector.
pub struct Objects {
    net: Net,
    anchors: Vec<Anchor>,
}

impl Objects {
    /// Loads the model (an ONNX file).
    ///
    /// # Errors
    /// `detector` if the file is not the expected model.
    pub fn new(onnx: &[u8]) -> Result<Self> {
        Ok(Self { net: Net::new(onnx, SIDE)?, anchors: mobilenet_anchors() })
    }

    /// The objects of a photo, the surest first.
    ///
    /// # Errors
    /// `detector` if the model fails.
    pub fn look(&self, photo: &Image) -> Result<Vec<Detection>> {
        let (input, place) = letterbox(photo, Region::whole(photo.width(), photo.height()), self.net.side());
        let [boxes, logits] = self.net.run(&input)?;
        let count = self.anchors.len();
        if boxes.len() != 4 * count || logits.len() != CLASSES * count {
            return Err(Error::Detector("the file is not the object detector".into()));
        }
        let (boxes, _) = boxes.as_chunks::<4>();
        // As sigmoid rises, scores can be compared before it.
        let least = (THRESHOLD / (1.0 - THRESHOLD)).ln() as f32;
        let mut classes: Vec<Vec<Candidate>> = vec![Vec::new(); CLASSES];
        for ((anchor, numbers), scores) in self.anchors.iter().zip(boxes).zip(logits.chunks_exact(CLASSES)) {
            for (class, logit) in scores.iter().enumerate().skip(1).filter(|(_, logit)| **logit > least) {
                let corners = place.to_photo(decode(anchor, *numbers));
                classes[class].push(Candidate { corners, score: sigmoid(*logit), points: None });
            }
        }
        let mut found: Vec<Detection> = classes
            .into_iter()
            .enumerate()
            .filter_map(|(class, candidates)| Some((label(class)?, candidates)))
            .flat_map(|(label, candidates)| {
                suppress(candidates, SAME).into_iter().map(move |kept| detection(label, kept))
            })
            .filter(|found| found.width > 0.0 && found.height > 0.0)
            .collect();
        found.sort_by(|a, b| b.score.total_cmp(&a.score));
        Ok(found)
    }
}

fn detection(label: &'static str, kept: Candidate) -> Detection {
    let [left, top, right, bottom] = kept.corners;
    Detection {
        label: label.to_owned(),
        score: kept.score,
        x: left,
        y: top,
        width: right - left,
        height: bottom - top,
        points: None,
        expression: None,
        light: None,
    }
}

/// The name of a class; `None` for unused numbers.
fn label(class: usize) -> Option<&'static str> {
    let name = *NAMES.get(class.checked_sub(1)?)?;
    (!name.is_empty()).then_some(name)
}

/// COCO's names by their numbers, from 1.
#[rustfmt::skip]
const NAMES: [&str; 90] = [
    "person", "bicycle", "car", "motorcycle", "airplane", "bus", "train", "truck", "boat", "traffic light",
    "fire hydrant", "", "stop sign", "parking meter", "bench", "bird", "cat", "dog", "horse", "sheep",
    "cow", "elephant", "bear", "zebra", "giraffe", "", "backpack", "umbrella", "", "",
    "handbag", "tie", "suitcase", "frisbee", "skis", "snowboard", "sports ball", "kite", "baseball bat",
    "baseball glove", "skateboard", "surfboard", "tennis racket", "bottle", "", "wine glass", "cup", "fork",
    "knife", "spoon", "bowl", "banana", "apple", "sandwich", "orange", "broccoli", "carrot", "hot dog", "pizza",
    "donut", "cake", "chair", "couch", "potted plant", "bed", "", "dining table", "", "", "toilet",
    "", "tv", "laptop", "mouse", "remote", "keyboard", "cell phone", "microwave", "oven", "toaster",
    "sink", "refrigerator", "", "book", "clock", "vase", "scissors", "teddy bear", "hair drier", "toothbrush",
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn classes_have_cocos_numbers() {
        assert_eq!(NAMES.iter().filter(|name| !name.is_empty()).count(), 80);
        for (class, name) in [(1, "person"), (17, "cat"), (44, "bottle"), (62, "chair"), (90, "toothbrush")] {
            assert_eq!(label(class), Some(name));
        }
        assert_eq!([label(0), label(12), label(91)], [None; 3]);
    }
}
