//! Edits of pages as intents: the wish of the user without the resulting page. `carrying_out` plans the page.
//! Random choices come from a seed in the intent, so that an intent and a state give exactly one result.

use crate::framing::Crop;
use crate::json::typed::typed;
use crate::json::{Fields, Read, Wrong};
use crate::page::layouts::LayoutChange;
use crate::raster::Matte;
use serde::Deserialize;
use serde_json::Value;

/// An intent. In JSON, an object with its name as `type`, and its fields. Panels are indices into the panels
/// of the current page. An intent that is impossible, such as a change of a locked panel, changes nothing.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(tag = "type", rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Intent {
    /// Changes the crop of a panel.
    CropPanel {
        /// The panel.
        panel: usize,
        /// The change.
        crop: CropChange,
    },
    /// Swaps the photos of two panels.
    SwapPanels {
        /// A panel.
        panel: usize,
        /// The other panel.
        with: usize,
    },
    /// Shows a photo in a panel.
    PlacePhoto {
        /// The panel.
        panel: usize,
        /// Id of the photo, which must be in use.
        photo: String,
    },
    /// Locks a panel, or unlocks it.
    LockPanel {
        /// The panel.
        panel: usize,
        /// Whether it is locked.
        on: bool,
    },
    /// Lets the subject of a panel break the panel border, for which the crop may change.
    BreakFrame {
        /// The panel.
        panel: usize,
        /// Mask of the subject; `None` removes the breakout.
        #[cfg_attr(test, ts(type = "string | null"))]
        mask: Option<Matte>,
    },
    /// Merges panels: they share one image.
    MergePanels {
        /// The panels. All panels of a group that contains one of them are included.
        panels: Vec<usize>,
    },
    /// Separates merged panels. The first panel of a group keeps the photo, and the others get new ones.
    SplitPanels {
        /// Panels of the groups; empty for all groups.
        panels: Vec<usize>,
    },
    /// Changes the layout manually. The page then stores the complete layout.
    Reshape {
        /// The change. To join panels, all panels of a group that contains one of them are included.
        change: LayoutChange,
    },
    /// Enlarges a panel, if the layout allows it. Nothing happens if the layout or the panel is locked.
    EnlargePanel {
        /// The panel.
        panel: usize,
    },
    /// Computes the crops of the page again, for new measurements of its photos.
    Recrop,
    /// Computes the crops of a photo again on all pages, and drops its manual crops.
    RecropPhoto {
        /// Id of the photo.
        photo: String,
        /// Whether locked panels get new crops too.
        locked: bool,
    },
    /// An unknown intent, which is not read.
    #[serde(other)]
    #[cfg_attr(test, ts(skip))]
    Unknown,
}

impl Intent {
    /// Reads the intent of that name from its other fields.
    ///
    /// # Errors
    /// Returns the location of the error.
    pub(super) fn read(name: &str, fields: Fields) -> Read<Self> {
        let mut fields = fields.rest();
        fields.insert("type".into(), name.into());
        match typed(Value::Object(fields))? {
            Self::Unknown => Err(Wrong::new("is not a known edit").at("type")),
            intent => Ok(intent),
        }
    }
}

/// A change of the crop of a panel. `from` is the crop that it starts from; default: the current crop.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(tag = "type", rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum CropChange {
    /// Moves the photo.
    Pan {
        /// The crop at the start of the drag.
        #[cfg_attr(test, ts(optional = nullable))]
        from: Option<Crop>,
        /// Distance to the right, in widths of the image on the page.
        x: f64,
        /// Distance down, in heights of the image on the page.
        y: f64,
    },
    /// Zooms the photo.
    Zoom {
        /// The crop at the start of the gesture.
        #[cfg_attr(test, ts(optional = nullable))]
        from: Option<Crop>,
        /// Values above 1 zoom in.
        factor: f64,
        /// The fixed point, in fractions of the image on the page. Default: the centre.
        #[cfg_attr(test, ts(optional = nullable))]
        at: Option<[f64; 2]>,
    },
    /// Shows the subject large. Without a subject, it is the automatic crop.
    Fit,
    /// Restores the automatic crop.
    Reset,
}
