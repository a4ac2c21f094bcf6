//! Stage `layout`: a template laid on a page, with its gutters and margins.
//!
//!     cargo run --example stage_layout -- cinema-4

use std::error::Error;

use inkpanel_engine::layout::{PageSettings, catalogue, find, resolve};

fn main() -> Result<(), Box<dyn Error>> {
    let id = std::env::args().nth(1).ok_or("usage: stage_layout ID")?;
    let template = find(&id)?;
    let page = PageSettings::default();
    println!("{}, one of {} templates", template.name(), catalogue().len());
    for panel in resolve(template, page.aspect(), &page) {
        // The page is 1 wide.
        let at = panel.bounds;
        println!(
            "{:.3} x {:.3} at {:.3}, {:.3}, weight {:.2}",
            at.width, at.height, at.x, at.y, panel.weight
        );
    }
    Ok(())
}
