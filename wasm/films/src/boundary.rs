//! wasm bindings of the `films` module: selects representative frames of a video from frames that the browser
//! decodes, and analyses its sound. The worker that reads videos loads it with the first video.

// Every function that returns a Result throws as the module's documentation says.
#![allow(clippy::missing_errors_doc)]

use inkpanel_engine::error::Result;
use inkpanel_engine::hearing;
use inkpanel_engine::select::look::{Look, Samples};
use inkpanel_engine::select::shots::Film;
use inkpanel_engine::select::stills::{self, Wish};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(start)]
fn start() {
    console_error_panic_hook::set_once();
}

/// The samples of a video.
#[wasm_bindgen]
#[derive(Default)]
pub struct Looking {
    film: Film,
}

#[wasm_bindgen]
impl Looking {
    /// A video without samples.
    #[wasm_bindgen(constructor)]
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Looks at a frame of `width` x `height` pixels that is shown at `time`, in seconds. `format` is `I420`, `NV12` or
    /// `RGBA`, and `planes` are the offset and the stride of each plane in `bytes`. Throws `buffer-size`.
    pub fn look(
        &mut self,
        time: f64,
        format: &str,
        width: usize,
        height: usize,
        bytes: &[u8],
        planes: &[u32],
    ) -> Result<()> {
        let look = look(format, [width, height], bytes, planes)?;
        self.film.add(time, look);
        Ok(())
    }

    /// Number of analysed frames.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn looks(&self) -> usize {
        self.film.times().len()
    }

    /// How much the frames on both sides of a moment differ, in grey steps.
    #[must_use]
    pub fn change(&self, time: f64) -> f32 {
        self.film.change(time)
    }

    /// Selects the frames of the video, which ends at `end`. Returns the time in seconds and the shot number
    /// (from 1) of each. `count` is the number of frames, 0 for automatic. The result contains the frames
    /// `taken`, and has frames close to `moments`.
    #[must_use]
    pub fn choose(&self, end: f64, count: usize, taken: &[f64], moments: &[f64]) -> Vec<f64> {
        let shots = self.film.shots(end);
        let wish = Wish { count: (count > 0).then_some(count), taken, moments };
        let chosen = stills::choose(&self.film, &shots, &wish);
        chosen.iter().flat_map(|still| [still.time, (still.shot + 1) as f64]).collect()
    }

    /// Start times of the shots in seconds.
    #[must_use]
    pub fn shots(&self, end: f64) -> Vec<f64> {
        self.film.shots(end).iter().map(|shot| shot.start).collect()
    }
}

/// The sounds in samples of one channel and full scale 1, at `rate` a second, as the JSON of `SoundEvent[]`.
#[wasm_bindgen(js_name = soundEvents)]
#[must_use]
pub fn sound_events(samples: Vec<f32>, rate: f32) -> String {
    hearing::to_json(&hearing::events(samples, rate))
}

fn look(format: &str, size: [usize; 2], bytes: &[u8], planes: &[u32]) -> Result<Look> {
    if format == "RGBA" {
        return Look::of_rgba(bytes, size[0], size[1]);
    }
    let half = size.map(|side| side.div_ceil(2));
    let number = |i: usize| planes.get(i).map_or(usize::MAX, |&number| number as usize);
    let plane = |offset: usize, stride: usize, step: usize, size: [usize; 2]| {
        Samples::new(bytes.get(offset..).unwrap_or_default(), [stride, step], size)
    };
    let luma = plane(number(0), number(1), 1, size)?;
    let [blue, red] = if format == "NV12" {
        [plane(number(2), number(3), 2, half)?, plane(number(2).saturating_add(1), number(3), 2, half)?]
    } else {
        [plane(number(2), number(3), 1, half)?, plane(number(4), number(5), 1, half)?]
    };
    Ok(Look::of(&luma, [&blue, &red]))
}
