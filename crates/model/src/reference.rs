//! References of a page to its layout and its style: the id of a built-in one, or a custom one as its file.

use crate::error::Result;
use crate::json::{Read, Wrong};
use crate::layout::{self, Template};
use crate::style::{Style, catalogue};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::Value;
use std::borrow::Cow;
use std::ops::Deref;
use std::sync::Arc;

/// The file of a custom layout or style: a JSON object. It stays as it was read, so that pages are saved unchanged.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
#[serde(transparent)]
pub struct CustomFile(Value);

/// A built-in layout or style by its id, or a custom one by its file. The file is checked when it is used.
#[derive(Debug, Clone, PartialEq)]
pub enum Reference {
    /// The id of a built-in layout or style.
    BuiltIn(String),
    /// The file of a custom one.
    Custom(CustomFile),
}

/// The layout of a page.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct LayoutRef(Reference);

/// The style of a page.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct StyleRef(Reference);

impl CustomFile {
    /// A file that is checked when it is used.
    #[must_use]
    pub fn new(file: Value) -> Self {
        Self(file)
    }

    /// Reads a layout file with an id.
    ///
    /// # Errors
    /// Returns the location of the error.
    pub fn layout(file: Value) -> Read<Arc<Self>> {
        let file = Self(file).identified()?;
        Template::from_value("layout", file.json()).map_err(Wrong::of)?;
        Ok(Arc::new(file))
    }

    /// Reads a style file with an id.
    ///
    /// # Errors
    /// Returns the location of the error.
    pub fn style(file: Value) -> Read<Arc<Self>> {
        let file = Self(file).identified()?;
        Style::from_value("style", file.json()).map_err(Wrong::of)?;
        Ok(Arc::new(file))
    }

    /// Its id, or an empty text.
    #[must_use]
    pub fn id(&self) -> &str {
        self.0["id"].as_str().unwrap_or_default()
    }

    /// The content of the file.
    #[must_use]
    pub fn json(&self) -> &Value {
        &self.0
    }

    fn identified(self) -> Read<Self> {
        if self.0["id"].is_string() { Ok(self) } else { Err(Wrong::new("is missing").at("id")) }
    }
}

impl Reference {
    /// The id of a built-in one.
    #[must_use]
    pub fn built_in(&self) -> Option<&str> {
        match self {
            Self::BuiltIn(id) => Some(id),
            Self::Custom(_) => None,
        }
    }

    /// The file of a custom one.
    #[must_use]
    pub fn custom(&self) -> Option<&CustomFile> {
        match self {
            Self::BuiltIn(_) => None,
            Self::Custom(file) => Some(file),
        }
    }

    /// The id of either; `None` for a file without an id.
    #[must_use]
    pub fn id(&self) -> Option<&str> {
        match self {
            Self::BuiltIn(id) => Some(id),
            Self::Custom(file) => Some(file.id()).filter(|id| !id.is_empty()),
        }
    }
}

impl LayoutRef {
    /// A custom layout by its file.
    #[must_use]
    pub fn from_file(file: Value) -> Self {
        Self(Reference::Custom(CustomFile::new(file)))
    }

    /// A custom layout.
    #[must_use]
    pub fn of(template: &Template) -> Self {
        Self::from_file(serde_json::from_str(&template.to_json()).unwrap_or_default())
    }

    /// The layout.
    ///
    /// # Errors
    /// `unknown-layout`, `invalid-layout`.
    pub fn template(&self) -> Result<Cow<'static, Template>> {
        match &self.0 {
            Reference::BuiltIn(id) => layout::find(id).map(Cow::Borrowed),
            Reference::Custom(file) => {
                Template::from_value("layout of the page", file.json()).map(Cow::Owned)
            }
        }
    }
}

impl StyleRef {
    /// A custom style.
    #[must_use]
    pub fn of(style: &Style) -> Self {
        Self(Reference::Custom(CustomFile(style.to_value())))
    }

    /// The style.
    ///
    /// # Errors
    /// `unknown-style`, `invalid-style`.
    pub fn style(&self) -> Result<Cow<'static, Style>> {
        match &self.0 {
            Reference::BuiltIn(id) => catalogue::find(id).map(Cow::Borrowed),
            Reference::Custom(file) => Style::from_value("style of the page", file.json()).map(Cow::Owned),
        }
    }
}

impl<'de> Deserialize<'de> for Reference {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
        match Value::deserialize(deserializer)? {
            Value::String(id) => Ok(Self::BuiltIn(id)),
            file @ Value::Object(_) => Ok(Self::Custom(CustomFile(file))),
            _ => Err(serde::de::Error::custom("must be an id or an object")),
        }
    }
}

impl Serialize for Reference {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        match self {
            Self::BuiltIn(id) => serializer.serialize_str(id),
            Self::Custom(file) => file.serialize(serializer),
        }
    }
}

impl Deref for LayoutRef {
    type Target = Reference;

    fn deref(&self) -> &Reference {
        &self.0
    }
}

impl Deref for StyleRef {
    type Target = Reference;

    fn deref(&self) -> &Reference {
        &self.0
    }
}

impl From<&str> for LayoutRef {
    fn from(id: &str) -> Self {
        Self(Reference::BuiltIn(id.to_owned()))
    }
}

impl From<&str> for StyleRef {
    fn from(id: &str) -> Self {
        Self(Reference::BuiltIn(id.to_owned()))
    }
}

/// The style of storyboard frames without a page.
impl Default for StyleRef {
    fn default() -> Self {
        Self::from("storyboard")
    }
}
