//! `cargo xtask bench batch`: albums by the command line, by one worker, by two, and by one program that has all cores.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;
use std::thread;
use std::time::Instant;

use anyhow::{Context, Result, ensure};

use crate::albums::{own_folders, photos_in};
use crate::project::Project;
use crate::{models, tables, tools};

const ALBUMS: usize = 100;
/// Photos of an album.
const PHOTOS: usize = 12;

/// Makes albums of the repository's photos, has each drawn as a page of A4 in a PDF file, and writes the table of
/// `docs/guide/batches.md`.
///
/// # Errors
/// When something cannot be built or written, or an album does not become a page.
pub fn run(project: &Project) -> Result<()> {
    models::make(project)?;
    tools::run(project.cargo().args(["build", "--release", "--bin", "inkpanel"]))?;
    let program = project.target.join("release").join(format!("inkpanel{}", std::env::consts::EXE_SUFFIX));
    let top = project.target.join("batch");
    let albums = make_albums(project, &top.join("albums"))?;
    let drawn = |workers: usize, threads: Option<usize>| {
        let pages = top.join("pages");
        let _ = fs::remove_dir_all(&pages);
        fs::create_dir_all(&pages)?;
        let start = Instant::now();
        let tries = shared(&albums, workers, |album| {
            let mut command = Command::new(&program);
            command.arg("render").arg(album).arg("--models").arg(project.www().join("models"));
            command.arg("-o").arg(pages.join(album.file_name().unwrap_or_default()).with_extension("pdf"));
            if let Some(threads) = threads {
                command.env("RAYON_NUM_THREADS", threads.to_string());
            }
            // The output lists photos without a panel.
            let told = command.output().context("cannot start the command line")?;
            ensure!(told.status.success(), "{}", String::from_utf8_lossy(&told.stderr));
            Ok(())
        });
        let _: Vec<()> = tries.into_iter().collect::<Result<_>>()?;
        let rate = ALBUMS as f64 * 60.0 / start.elapsed().as_secs_f64();
        println!("{workers} at a time: {rate:.1} pages per minute");
        anyhow::Ok(rate)
    };
    let [one, two, all] = [drawn(1, Some(1))?, drawn(2, Some(1))?, drawn(1, None)?];
    let table = format!(
        "| {ALBUMS} albums of {PHOTOS} photos of 0.1 to 1.9 megapixels, detection, one A4 page at 300 DPI as PDF | Pages per minute |\n\
         |---|--:|\n\
         | One process with one thread | {one:.1} |\n\
         | Two processes with one thread each | {two:.1} ({:.2} times) |\n\
         | One process with all {} cores, one album after another | {all:.1} ({:.2} times) |",
        two / one,
        thread::available_parallelism()?,
        all / one,
    );
    println!("{table}");
    tables::put(&project.root.join("docs/guide/batches.md"), "batch", &table)
}

/// Folders of photos, each with others of the repository's.
fn make_albums(project: &Project, top: &Path) -> Result<Vec<PathBuf>> {
    let photos = photos_in(&own_folders(project))?;
    let _ = fs::remove_dir_all(top);
    let album = |number: usize| {
        let folder = top.join(format!("{number:03}"));
        fs::create_dir_all(&folder)?;
        for place in 0..PHOTOS {
            let photo = &photos[(number + place * 3) % photos.len()];
            fs::copy(photo, folder.join(format!("{place:02}.jpg")))?;
        }
        Ok(folder)
    };
    (0..ALBUMS).map(album).collect()
}

/// Processes each item with a pool of threads.
fn shared<T: Sync, R: Send>(items: &[T], workers: usize, work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let (next, done) = (Mutex::new(items.iter()), Mutex::new(Vec::new()));
    // The lock is given back before the work begins.
    let take = || next.lock().ok().and_then(|mut items| items.next());
    thread::scope(|scope| {
        for _ in 0..workers {
            scope.spawn(|| {
                while let Some(item) = take() {
                    let result = work(item);
                    if let Ok(mut done) = done.lock() {
                        done.push(result);
                    }
                }
            });
        }
    });
    done.into_inner().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_item_is_done_once_by_some_worker() {
        let items: Vec<usize> = (0..40).collect();
        let mut done = shared(&items, 3, |item| item * 2);
        done.sort_unstable();
        assert_eq!(done, items.iter().map(|item| item * 2).collect::<Vec<_>>());
        assert!(shared(&items[..0], 2, |item| *item).is_empty());
    }
}
