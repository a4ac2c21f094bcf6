//! Manual changes of a layout.

use super::edit::{move_cut, place_overlay, remove_panel, split_panel};
use super::join::join_panels;
use super::tree::Axis;
use super::{Bounds, PageSettings, Template};
use crate::error::Result;
use serde::Deserialize;

/// A manual change of a layout.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(tag = "type", rename_all = "kebab-case")]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub enum LayoutChange {
    /// A cut is moved or slanted.
    MoveCut {
        /// Its place among the cuts.
        cut: usize,
        /// Position in its cell, 0 to 1.
        fraction: f64,
        /// As in the file.
        slant: f64,
    },
    /// A panel becomes two.
    Split {
        /// Which.
        panel: usize,
        /// Direction of the division.
        axis: Axis,
    },
    /// Removes a panel.
    Remove {
        /// Which.
        panel: usize,
    },
    /// Panels become one.
    Join {
        /// Which.
        panels: Vec<usize>,
    },
    /// An inset is moved and sized.
    MoveInset {
        /// Which.
        panel: usize,
        /// Its new bounds on the page of the request, in page widths.
        bounds: Bounds,
    },
}

impl LayoutChange {
    /// Returns the changed layout. `page`: a valid page, for the bounds of insets.
    ///
    /// # Errors
    /// `invalid-layout` for a change that the layout does not allow.
    pub fn of(&self, template: &Template, page: &PageSettings) -> Result<Template> {
        match self {
            Self::MoveCut { cut, fraction, slant } => move_cut(template, *cut, *fraction, *slant),
            Self::Split { panel, axis } => split_panel(template, *panel, *axis),
            Self::Remove { panel } => remove_panel(template, *panel),
            Self::Join { panels } => join_panels(template, panels),
            Self::MoveInset { panel, bounds } => {
                place_overlay(template, *panel, *bounds, page.aspect(), page)
            }
        }
    }
}
