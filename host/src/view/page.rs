//! The page that shows a motion: scripts and data in one text.

/// The page without data and scripts.
const PAGE: &str = include_str!("page.html");
/// The library.
pub const THREE: &str = include_str!("three/three.min.js");
/// Our own scripts, in order.
const SCRIPTS: [&str; 5] = [
    include_str!("film.js"),
    include_str!("solids.js"),
    include_str!("skin.js"),
    include_str!("stage.js"),
    include_str!("player.js"),
];

/// The page's text, for data from [`Film::data`](super::film::Film::data).
#[must_use]
pub fn page(data: &str) -> String {
    // Escaped, so that a name cannot close the script element that contains the data.
    let data = data.replace('<', "\\u003c");
    let page = PAGE.replacen("/*THREE*/", THREE, 1).replacen("/*SCRIPT*/", &SCRIPTS.concat(), 1);
    page.replacen("<!--DATA-->", &data, 1)
}
