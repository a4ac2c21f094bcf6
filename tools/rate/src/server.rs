//! The local web page that shows two pages and waits for a key for the better one.

use std::fs;
use std::io::Read as _;
use std::path::Path;

use anyhow::{Result, anyhow};
use serde_json::json;
use tiny_http::{Header, Method, Request, Response, Server};

use crate::pages::Page;
use crate::pairs::{self, Pair};

/// Bytes of an answer at most.
const MOST: u64 = 100;

/// Serves the comparison on this machine until all pairs are rated or the program is stopped.
///
/// # Errors
/// If the port is taken, or a pair cannot be stored.
pub(crate) fn serve(pages: &[Page], duels: &[[usize; 2]], file: &Path, port: u16) -> Result<()> {
    let server =
        Server::http(("127.0.0.1", port)).map_err(|error| anyhow!("cannot use port {port}: {error}"))?;
    println!("Rate {} pairs at http://127.0.0.1:{port}/ (stop with Ctrl+C)", duels.len());
    for mut request in server.incoming_requests() {
        let url = request.url().to_owned();
        match (request.method(), url.as_str()) {
            (Method::Get, "/") => answer(request, html(duels), "text/html; charset=utf-8"),
            (Method::Post, "/better") => {
                let Some([number, side]) = answer_of(&mut request, duels.len()) else {
                    refuse(request, 400);
                    continue;
                };
                let (better, worse) = (&pages[duels[number][side]], &pages[duels[number][1 - side]]);
                let pair = Pair {
                    album: better.album.clone(),
                    seeds: [better.seed, worse.seed],
                    better: better.terms.clone(),
                    worse: worse.terms.clone(),
                };
                pairs::store(file, &pair)?;
                answer(request, Vec::new(), "text/plain");
                if number + 1 == duels.len() {
                    println!("All pairs are rated: {}", file.display());
                    break;
                }
            }
            (Method::Get, path) => {
                let number = path.strip_prefix("/page/").and_then(|number| number.parse::<usize>().ok());
                match number.and_then(|number| pages.get(number)).and_then(|page| fs::read(&page.file).ok()) {
                    Some(bytes) => answer(request, bytes, "image/png"),
                    None => refuse(request, 404),
                }
            }
            _ => refuse(request, 405),
        }
    }
    Ok(())
}

/// Returns the number of a pair and the side that is better, from a body such as `3 0`.
fn answer_of(request: &mut Request, count: usize) -> Option<[usize; 2]> {
    let mut body = String::new();
    request.as_reader().take(MOST).read_to_string(&mut body).ok()?;
    let (number, side) = body.split_once(' ')?;
    let answer = [number.parse().ok()?, side.parse().ok()?];
    (answer[0] < count && answer[1] < 2).then_some(answer)
}

/// Sends bytes and ignores a closed connection.
fn answer(request: Request, bytes: Vec<u8>, kind: &str) {
    let mut response = Response::from_data(bytes);
    if let Ok(header) = Header::from_bytes("Content-Type", kind) {
        response.add_header(header);
    }
    let _ = request.respond(response);
}

fn refuse(request: Request, status: u16) {
    let _ = request.respond(Response::empty(status));
}

fn html(duels: &[[usize; 2]]) -> Vec<u8> {
    let page = include_str!("rate.html");
    page.replace("[/* pairs */]", &json!(duels).to_string()).into_bytes()
}
