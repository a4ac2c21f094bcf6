//! Edits of pages as intents: the wish of the user without the resulting page. `carrying_out` plans the page.
//! Random choices come from a seed in the intent, so that an intent and a state give exactly one result.

use crate::choice::{Styling, Taste};
use crate::crop::Crop;
use crate::json::typed::typed;
use crate::json::{Fields, Read, Wrong};
use crate::layout::LayoutChange;
use crate::layout::PageSettings;
use crate::raster::Matte;
use crate::reference::{LayoutRef, StyleRef};
use serde::Deserialize;
use serde_json::{Map, Value};

/// An intent. In JSON, an object with its name as `type`, and its fields. Panels are indices into the panels
/// of the current page. An intent that is impossible, such as a change of a locked panel, changes nothing.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(tag = "type", rename_all = "kebab-case")]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[allow(clippy::large_enum_variant, reason = "one at a time exists")]
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
        #[cfg_attr(feature = "typescript", ts(type = "string | null"))]
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
    /// Computes the crops of a page again, for new measurements of its photos.
    Recrop {
        /// The page, by its place in the storyboard. Default: the current page.
        #[cfg_attr(feature = "typescript", ts(optional = nullable))]
        sheet: Option<u64>,
    },
    /// Computes the crops of a photo again, and drops its manual crops.
    RecropPhoto {
        /// Id of the photo.
        photo: String,
        /// Whether the photo itself changed. Locked panels and other pages then get new crops too.
        everywhere: bool,
    },
    /// Plans new parts of the page, as a new page. Nothing happens if the part is locked.
    Shuffle {
        /// The part of the page.
        part: Shuffled,
        /// Random choices.
        draw: Draw,
    },
    /// Plans a layout with the wanted number of panels, as a new page.
    FitLayout {
        /// Random choices.
        draw: Draw,
    },
    /// Gives the page a layout, as a new page.
    ChooseLayout {
        /// The layout.
        #[cfg_attr(feature = "typescript", ts(as = "crate::page::LayoutChoice"))]
        layout: LayoutRef,
        /// Seed of random choices.
        seed: u32,
    },
    /// Gives the page a style, as a new page.
    ChooseStyle {
        /// The style.
        #[cfg_attr(feature = "typescript", ts(as = "crate::page::StyleChoice"))]
        style: StyleRef,
        /// Seed of random choices.
        seed: u32,
    },
    /// Changes the style of the page, for example while the user designs it.
    Restyle {
        /// The style.
        #[cfg_attr(feature = "typescript", ts(as = "crate::page::StyleChoice"))]
        style: StyleRef,
    },
    /// Puts the photos of the page into the order of the photos in use, as a new page. Locked panels stay.
    SortPhotos,
    /// Shows a photo instead of its near-duplicates, as a new page. Locked panels stay.
    UseDuplicate {
        /// Id of the photo.
        photo: String,
        /// Ids of its near-duplicates.
        alike: Vec<String>,
    },
    /// Plans the page again after the photos in use changed, with as few changes as possible, as a new page.
    /// Without photos in use, the page is removed.
    Refit {
        /// Whether there are more photos than before.
        grow: bool,
        /// Random choices.
        draw: Draw,
    },
    /// Changes the page settings of the project, and plans its pages with them.
    SetPaper {
        /// All settings.
        settings: PageSettings,
        /// Whether the user still drags a control. Only the current page then changes, because planning all
        /// pages of an album at each step would delay the drag.
        held: bool,
        /// Learned preferences.
        #[serde(default)]
        #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
        taste: Taste,
    },
    /// Plans all parts of the current page again, from some of the photos in use.
    Compose {
        /// Ids of the photos, in order.
        photos: Vec<String>,
        /// Number of panels.
        panels: usize,
        /// The layout. Default: chosen automatically.
        #[cfg_attr(feature = "typescript", ts(as = "Option<crate::page::LayoutChoice>", optional = nullable))]
        layout: Option<LayoutRef>,
        /// The style. Default: chosen automatically.
        #[cfg_attr(feature = "typescript", ts(as = "Option<crate::page::StyleChoice>", optional = nullable))]
        style: Option<StyleRef>,
        /// Randomness of the choice, as in a request for a page.
        #[cfg_attr(feature = "typescript", ts(optional = nullable))]
        surprise: Option<f64>,
        /// Random choices.
        draw: Draw,
    },
    /// Inserts a page after the current page and makes it the current page. It has the style of the current
    /// page, and photos that no page shows, if there are any.
    AddPage {
        /// Random choices.
        draw: Draw,
    },
    /// Removes the current page, unless it is the only page.
    RemovePage,
    /// Moves a page. The current page stays the current page.
    MovePage {
        /// Its index in the storyboard.
        from: usize,
        /// Its index after the move.
        to: usize,
    },
    /// Makes another page the current page.
    GoToPage {
        /// Its index in the storyboard.
        at: usize,
    },
    /// Distributes the photos in use over as many pages as needed, which replace the present pages. Nothing
    /// happens if the photos are locked.
    SpreadAlbum {
        /// Random choices.
        draw: Draw,
    },
    /// Gives all pages the style of the current page.
    StylePages,
    /// Replaces missing photos on the other pages, and removes pages without photos.
    RepairPages {
        /// Groups of near-duplicates by photo id.
        #[cfg_attr(feature = "typescript", ts(type = "Record<string, number>"))]
        groups: Map<String, Value>,
        /// Learned preferences.
        #[serde(default)]
        #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
        taste: Taste,
    },
    /// Restores a version of the page history in its place in the storyboard. If the place does not exist any
    /// more, the version replaces the current page.
    RestoreVersion {
        /// Id of the page.
        #[serde(rename = "pageId")]
        page_id: u64,
        /// Learned preferences.
        #[serde(default)]
        #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
        taste: Taste,
    },
    /// An unknown intent, which is not read.
    #[serde(other)]
    #[cfg_attr(feature = "typescript", ts(skip))]
    Unknown,
}

impl Intent {
    /// Reads the intent of that name from its other fields.
    ///
    /// # Errors
    /// Returns the location of the error.
    pub(crate) fn read(name: &str, fields: Fields) -> Read<Self> {
        let mut fields = fields.rest();
        fields.insert("type".into(), name.into());
        match typed(Value::Object(fields))? {
            Self::Unknown => Err(Wrong::new("is not a known edit").at("type")),
            intent => Ok(intent),
        }
    }
}

/// Part of a page that a shuffle changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub enum Shuffled {
    /// All parts that are not locked.
    All,
    /// The layout.
    Layout,
    /// The style.
    Style,
    /// The choice and order of the photos.
    Photos,
}

/// The basis of random choices.
#[derive(Debug, Clone, PartialEq, Default, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Draw {
    /// The seed.
    pub seed: u32,
    /// Learned preferences.
    #[serde(default)]
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub taste: Taste,
    /// How a style is chosen.
    #[serde(default)]
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub styling: Styling,
}

impl Intent {
    /// Learned preferences for random choices.
    #[must_use]
    pub fn taste(&self) -> Taste {
        match self {
            Self::Shuffle { draw, .. }
            | Self::FitLayout { draw }
            | Self::Refit { draw, .. }
            | Self::Compose { draw, .. }
            | Self::AddPage { draw }
            | Self::SpreadAlbum { draw } => draw.taste.clone(),
            Self::SetPaper { taste, .. }
            | Self::RepairPages { taste, .. }
            | Self::RestoreVersion { taste, .. } => taste.clone(),
            _ => Taste::default(),
        }
    }
}

/// A change of the crop of a panel. `from` is the crop that it starts from; default: the current crop.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(tag = "type", rename_all = "kebab-case")]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub enum CropChange {
    /// Moves the photo.
    Pan {
        /// The crop at the start of the drag.
        #[cfg_attr(feature = "typescript", ts(optional = nullable))]
        from: Option<Crop>,
        /// Distance to the right, in widths of the image on the page.
        x: f64,
        /// Distance down, in heights of the image on the page.
        y: f64,
    },
    /// Zooms the photo.
    Zoom {
        /// The crop at the start of the gesture.
        #[cfg_attr(feature = "typescript", ts(optional = nullable))]
        from: Option<Crop>,
        /// Values above 1 zoom in.
        factor: f64,
        /// The fixed point, in fractions of the image on the page. Default: the centre.
        #[cfg_attr(feature = "typescript", ts(optional = nullable))]
        at: Option<[f64; 2]>,
    },
    /// Shows the subject large. Without a subject, it is the automatic crop.
    Fit,
    /// Restores the automatic crop.
    Reset,
}
