//! Schematic drawings: the tile (2.2 to 2.4), a site of sensors (3.8) and an array of four (3.9).
//!
//! In: a tile's pose in closed form, dimensions and the sensors' frequency bands. Out: drawings to scale, made from the
//! numbers with which the program computes; they are no results.

use crate::plot::chart::{LARGE, SMALL, line, text};
use crate::plot::drawing::{Anchor, Color, Drawing, INK, Item, PALE};
use smartbed_bed::sensor::array::Array;
use smartbed_bed::sensor::site::Site;
use smartbed_bed::tile::{Command, heights, pose};

const BLUE: Color = [0, 114, 178];
const RED: Color = [213, 94, 0];
const GREEN: Color = [0, 158, 115];
/// Radius of the circle of the screws (m), and the posture drawn.
const CIRCLE: f64 = 0.09;
const SHOWN: Command = Command { heave: 0.02, slope: [0.18, 0.12] };

/// Which drawing of the tile.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Tile {
    /// Screws, connectors, star and platform.
    Design,
    /// Frames seen from above.
    Frames,
    /// Closed loops.
    Loops,
}

/// Azimuth of a screw: screw A is in the direction of +y.
fn azimuth(k: usize) -> f64 {
    (90.0 + 120.0 * k as f64).to_radians()
}

/// The drawing of a tile.
pub(super) fn tile(what: Tile) -> Drawing {
    let star = pose(&SHOWN, CIRCLE);
    let high = heights(&SHOWN, CIRCLE);
    let flat = what == Tile::Frames;
    // Projection from above, or obliquely from the front.
    let at = |p: [f64; 3]| {
        let scale = 2200.0;
        if flat {
            (400.0 + scale * p[0], 300.0 - scale * p[1])
        } else {
            (400.0 + scale * (p[0] + 0.35 * p[1]), 430.0 - scale * (p[2] + 0.35 * p[1]))
        }
    };
    let foot = |k: usize| [CIRCLE * azimuth(k).cos(), CIRCLE * azimuth(k).sin(), 0.0];
    let connector = |k: usize| [foot(k)[0], foot(k)[1], 0.06 + high[k]];
    let centre = {
        let [x, y, z] = star.place;
        [x, y, z + 0.06]
    };
    let mut items = Vec::new();
    let mut put = |p: [f64; 3], words: &str, color: Color| {
        let (x, y) = at(p);
        items.push(Item::Area {
            points: vec![(x - 5.0, y - 5.0), (x + 5.0, y - 5.0), (x + 5.0, y + 5.0), (x - 5.0, y + 5.0)],
            color,
        });
        items.push(text((x + 10.0, y - 10.0), words, SMALL, Anchor::Start));
    };
    for k in 0..3 {
        put(connector(k), ["D", "E", "F"][k], RED);
        put(foot(k), ["A", "B", "C"][k], INK);
    }
    put(centre, "G", BLUE);
    for k in 0..3 {
        if !flat {
            items.push(line(
                vec![
                    at(foot(k)),
                    at({
                        let [x, y, z] = connector(k);
                        [x, y, z + 0.03]
                    }),
                ],
                INK,
                3.0,
            ));
        }
        // An arm extends beyond the connector that slides on it.
        let [c, q] = [centre, connector(k)];
        items.push(line(vec![at(c), at([0, 1, 2].map(|n| c[n] + 1.25 * (q[n] - c[n])))], BLUE, 4.0));
        if what == Tile::Frames {
            let [x, y, z] = foot(k);
            let turned = |angle: f64| [x + 0.03 * angle.cos(), y + 0.03 * angle.sin(), z];
            items.push(line(vec![at(foot(k)), at(turned(azimuth(k)))], GREEN, 1.5));
            items.push(line(vec![at(foot(k)), at(turned(azimuth(k) + 90_f64.to_radians()))], GREEN, 1.5));
        }
        if what == Tile::Loops {
            let ways = [[0.0; 3], foot(k), connector(k), centre];
            items.push(line(ways.map(at).to_vec(), [RED, GREEN, INK][k], 1.0));
        }
    }
    if what != Tile::Loops {
        let [a, b] = [0.1095, 0.13985];
        let corners = [[-a, -b], [a, -b], [a, b], [-a, b], [-a, -b]].map(|[x, y]| {
            let [x, y, z] = star.outwards([x, y, 0.05]);
            at([x, y, z + 0.06])
        });
        items.push(line(corners.to_vec(), PALE, 2.0));
    }
    let words: &[&str] = match what {
        Tile::Design => &[
            "Scheme: three screws A, B, C, 120 deg apart, each with a connector D, E, F",
            "that turns and slides on an arm of the star G; the plate is fixed to the star.",
        ],
        Tile::Frames => &[
            "Scheme, from above: N1 to the right, N2 upwards; frames of the screws, turned by their azimuths",
            "90, 210 and 330 deg; connectors slide along the arms of G, which is the Fermat point of the three.",
        ],
        Tile::Loops => &[
            "Scheme: three loops N - screw - connector - arm - G, each of which closes;",
            "12 coordinates, 3 freedoms: heave and two slopes (docs/notation.md).",
        ],
    };
    for (n, words) in words.iter().enumerate() {
        items.push(text((30.0, 560.0 + 22.0 * n as f64), words, SMALL, Anchor::Start));
    }
    Drawing { width: 800, height: 610, items }
}

/// A site of sensors in section.
pub(super) fn platform() -> Drawing {
    let site = Site::default();
    let scale = 60_000.0;
    let (left, bottom) = (120.0, 640.0);
    let mut items = vec![text((30.0, 26.0), "Scheme of one site in section, to scale", LARGE, Anchor::Start)];
    let mut z = 0.0;
    let mut layer = |height: f64, color: Color, words: &str, of: [f64; 2]| {
        let (a, b) = (left + scale * of[0], left + scale * of[1]);
        let (low, high) = (bottom - scale * z, bottom - scale * (z + height));
        items.push(Item::Area { points: vec![(a, low), (b, low), (b, high), (a, high)], color });
        items.push(text((left + scale * site.side + 20.0, 0.5 * (low + high)), words, SMALL, Anchor::Start));
        z += height;
    };
    let whole = [0.0, site.side];
    let inner = |width: f64| [0.5 * (site.side - width), 0.5 * (site.side + width)];
    let rest = site.thickness - site.gap - 2.0 * site.shear.height - 3.0 * 0.1e-3;
    layer(rest, [235, 235, 235], "body of the site", whole);
    layer(0.1e-3, RED, "loop antenna: gap to its reflector, pressure", inner(2.0 * site.ring.radius));
    layer(site.gap, [250, 240, 200], "soft spacer: pressed and sheared", whole);
    layer(0.1e-3, INK, "ground with two blind slots, reflector of the loop", whole);
    layer(
        site.shear.height,
        [200, 225, 240],
        "substrate of the shear patch: f10, f01 by the slots' overlap",
        whole,
    );
    layer(0.1e-3, BLUE, "patch", inner(site.shear.sides[0]));
    layer(
        site.moisture.height,
        [200, 225, 240],
        "substrates of the patches for moisture and pH, under a film",
        whole,
    );
    items.push(text(
        (30.0, 690.0),
        &format!(
            "{:.0} mm square, {:.0} mm high, {:.1} g",
            1e3 * site.side,
            1e3 * site.thickness,
            1e3 * site.mass
        ),
        SMALL,
        Anchor::Start,
    ));
    Drawing { width: 900, height: 720, items }
}

/// Frequency bands of four sites on one line.
pub(super) fn array() -> Drawing {
    let bands = Array::new(&Site::default()).bands();
    let mut items = vec![text(
        (30.0, 26.0),
        "Scheme of four sites on one line: bands of their resonances, GHz",
        LARGE,
        Anchor::Start,
    )];
    let ends = [0.6e9_f64.ln(), 32e9_f64.ln()];
    let x = |f: f64| 140.0 + 720.0 * (f.ln() - ends[0]) / (ends[1] - ends[0]);
    for tick in [1.0, 2.0, 5.0, 10.0, 20.0, 30.0] {
        items.push(line(vec![(x(1e9 * tick), 50.0), (x(1e9 * tick), 250.0)], PALE, 1.0));
        items.push(text((x(1e9 * tick), 266.0), &format!("{tick}"), SMALL, Anchor::Middle));
    }
    let rows = ["pressure", "shear along x", "shear along y", "moisture", "pH"];
    for (n, row) in rows.iter().enumerate() {
        items.push(text((30.0, 70.0 + 40.0 * n as f64), row, SMALL, Anchor::Start));
    }
    for band in &bands {
        let row = rows.iter().position(|r| *r == band.of).unwrap_or_default();
        let (a, b, y) =
            (x(band.range[0]), x(band.range[1]).max(x(band.range[0]) + 2.0), 70.0 + 40.0 * row as f64);
        let color = [INK, BLUE, RED, GREEN][band.site];
        items.push(Item::Area {
            points: vec![(a, y + 10.0), (b, y + 10.0), (b, y - 10.0), (a, y - 10.0)],
            color,
        });
    }
    items.push(text(
        (30.0, 300.0),
        "one colour a site; a sweep finds one resonance in each band",
        SMALL,
        Anchor::Start,
    ));
    Drawing { width: 900, height: 320, items }
}
