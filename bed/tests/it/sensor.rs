//! Antennas against published numbers and other formulas, calibrations, maps read through them, instruments of a tile.

use smartbed_bed::map::{Frame, Grid, Recording};
use smartbed_bed::sensor::antenna::{Loop, Mode, Patch, mutual};
use smartbed_bed::sensor::array::{Array, SITES};
use smartbed_bed::sensor::drive::{Instruments, TileSensors};
use smartbed_bed::sensor::reader::{Quality, Reader, error};
use smartbed_bed::sensor::site::{Calibration, Load, Site, usual_skin};
use smartbed_bed::sensor::table::{NotMonotone, Table};
use smartbed_bed::sensor::{antenna, fine};
use std::f64::consts::PI;

/// Balanis, Antenna Theory, example 14.1: substrate 2.2, 1.588 mm, width 11.86 mm, length 9.06 mm: 10 GHz.
#[test]
fn a_patch_resonates_where_the_textbook_says() {
    let patch =
        Patch { sides: [9.06e-3, 11.86e-3], height: 1.588e-3, permittivity: 2.2, slot: [0.4e-3, 0.3e-3] };
    let frequency = patch.resonance(Mode::Along, 1.0, 0.0);
    assert!((frequency / 10e9 - 1.0).abs() < 2e-3, "{frequency:e}");
    // More overlap of a slot and a denser cover lower it; the slot by the perturbation's share, integrated here by
    // sums.
    assert!(patch.resonance(Mode::Along, 3.0, 0.0) < frequency);
    let (steps, overlap) = (20_000, 2e-3);
    let energy = |from: f64, to: f64| -> f64 {
        let width = (to - from) / f64::from(steps);
        let at = |n: i32| PI * (from + (f64::from(n) + 0.5) * width) / 9.06e-3;
        (0..steps).map(|n| (at(n).sin().powi(2) - at(n).cos().powi(2)) * width).sum()
    };
    let gained = energy(4.53e-3 - 0.2e-3, 4.53e-3 + 0.2e-3) * 0.3e-3 * overlap;
    // sin^2 + cos^2 over the whole cavity.
    let whole = 9.06e-3 * 11.86e-3 * 1.588e-3;
    let lowered = 1.0 - patch.resonance(Mode::Along, 1.0, overlap) / frequency;
    assert!((lowered / (gained / whole) - 1.0).abs() < 1e-6, "{lowered:e} {:e}", gained / whole);
}

/// Neumann's integral, mu_0 a^2/2 of cos(phi)/r over the circle, by the rule of equal steps.
fn neumann(a: f64, d: f64) -> f64 {
    let steps = 200_000;
    let one = |n: i32| {
        let phi = 2.0 * PI * (f64::from(n) + 0.5) / f64::from(steps);
        phi.cos() / (2.0 * a * a * (1.0 - phi.cos()) + d * d).sqrt()
    };
    4e-7 * PI * a * a / 2.0 * (0..steps).map(one).sum::<f64>() * 2.0 * PI / f64::from(steps)
}

#[test]
fn loops_couple_as_neumanns_integral_says() {
    for distance in [0.2e-3, 1e-3, 4e-3, 20e-3] {
        let (found, expected) = (mutual(2e-3, distance), neumann(2e-3, distance));
        assert!((found / expected - 1.0).abs() < 1e-9, "{distance}: {found:e} {expected:e}");
    }
    // Far away they are dipoles: mu_0 pi a^4/(2 d^3).
    let far = mutual(2e-3, 0.4) / (4e-7 * PI * PI * 2e-3_f64.powi(4) / (2.0 * 0.4_f64.powi(3)));
    assert!((far - 1.0).abs() < 1e-3, "{far}");
    // A loop of 25 mm radius in wire of 1 mm radius has 0.1 uH (Grover: mu_0 a (ln(8 a/b) - 2) = 0.1036 uH).
    let ring = Loop { radius: 25e-3, wire: 1e-3, capacitance: 1e-12 };
    assert!((ring.inductance(10.0) / 0.1036e-6 - 1.0).abs() < 1e-3);
    assert!(ring.resonance(5e-3) > ring.resonance(10e-3));
}

#[test]
fn what_frequencies_mean_is_what_was_there() {
    let site = Site::default();
    let calibration = Calibration::new(&site).expect("tells loads apart");
    for n in 0..200 {
        let share = |k: u32| f64::from((n * (2 * k + 7) + 13 * k) % 101) / 100.0;
        let load = Load { pressure: 15e3 * share(0), shear: [1, 2].map(|k| 3e3 * (2.0 * share(k) - 1.0)) };
        let found = calibration.load(site.loaded(&load));
        assert!((found.pressure - load.pressure).abs() < 5.0, "{found:?} {load:?}");
        for k in 0..2 {
            assert!((found.shear[k] - load.shear[k]).abs() < 15.0, "{found:?} {load:?}");
        }
        let (tables, skin) = (usual_skin(), [100.0 * share(3), 3.0 + 6.0 * share(4)]);
        let permittivities = [0, 1].map(|k| tables[k].at(skin[k]));
        let [moisture, acid]: [f64; 2] = calibration.skin(site.covered(permittivities), &tables);
        assert!(
            (moisture - skin[0]).abs() < 0.5 && (acid - skin[1]).abs() < 0.05,
            "{moisture} {acid} {skin:?}"
        );
    }
}

#[test]
fn four_sites_are_told_apart_by_frequency() {
    let array = Array::new(&Site::default());
    let bands = array.bands();
    assert_eq!(bands.len(), 5 * SITES);
    for pair in bands.windows(2) {
        // The width of a resonance is a hundredth or less of its frequency.
        assert!(pair[1].range[0] > 1.01 * pair[0].range[1], "{pair:?}");
    }
    let inside = |f: &f64| bands.iter().any(|b| (b.range[0]..=b.range[1]).contains(f));
    assert!(!array.unread().iter().any(inside), "{:?}", array.unread());
    for (k, site) in array.sites.iter().enumerate() {
        let sides = [site.shear, site.moisture, site.acid].map(|p| p.sides[0].max(p.sides[1]));
        assert!(sides.iter().all(|side| *side < site.side), "{sides:?}");
        let load = Load { pressure: 4e3, shear: [1e3, -500.0] };
        for (f, of) in site.loaded(&load).into_iter().zip(["pressure", "shear along y", "shear along x"]) {
            let heard = array.heard(f).expect("a band");
            assert_eq!((heard.site, heard.of), (k, of));
        }
    }
}

fn recording() -> (Grid, Recording) {
    let grid = Grid { rows: 20, columns: 16, row_pitch: 0.02857, column_pitch: 0.028125 };
    let bump = |site: usize| {
        let [x, y] = grid.middle(site);
        6e3 * (1.0 - ((x - 0.225).powi(2) + (y - 0.286).powi(2)) / 0.03).max(0.0)
    };
    let frame = |n: usize| Frame {
        time: 10.0 * n as f64,
        seconds: 10.0,
        pressure: (0..grid.sites()).map(bump).collect(),
        shear: (0..grid.sites()).map(|site| [0.2 * bump(site), -0.1 * bump(site)]).collect(),
    };
    (grid, Recording::new(grid.all(), (0..6).map(frame).collect()).expect("sound"))
}

#[test]
fn a_map_is_read_within_one_per_cent_and_the_same_again() {
    let (_, truth) = recording();
    let read = |quality: Quality| {
        Reader::new(&Site::default(), quality).expect("a surface").recording(&truth).expect("sound")
    };
    let usual = read(Quality::default());
    for (frame, found) in truth.frames().iter().zip(usual.frames()) {
        let apart = error(truth.sites(), &frame.pressure, &found.pressure);
        assert!(apart > 0.0 && apart < 0.01, "{apart}");
    }
    assert_eq!(usual, read(Quality::default()));
    assert_ne!(usual, read(Quality { seed: 2, ..Quality::default() }));
    // Without noise the calibration alone is left; noise, steps and drift each show.
    let pure = Quality { noise: 0.0, step: 0.0, drift: 0.0, seed: 1 };
    let of = |quality: Quality| {
        let last = |r: &Recording| r.frames().last().expect("a frame").pressure.clone();
        error(truth.sites(), &last(&truth), &last(&read(quality)))
    };
    let exact = of(pure);
    assert!(exact < 2e-4, "{exact}");
    for worse in
        [Quality { noise: 1e-4, ..pure }, Quality { step: 3e-4, ..pure }, Quality { drift: 0.02, ..pure }]
    {
        assert!(of(worse) > 10.0 * exact + 1e-3, "{worse:?}");
    }
}

#[test]
fn a_grid_of_one_millimetre_feels_the_same_load() {
    let (grid, truth) = recording();
    let parts = fine::parts(&grid, 1e-3);
    assert_eq!(parts, [29, 29]);
    let finer = fine::grid(&grid, parts);
    assert!(finer.column_pitch <= 1e-3 && finer.row_pitch <= 1e-3);
    let frame = fine::frame(&grid, truth.sites(), &truth.frames()[0], parts);
    let coarse: f64 = truth.frames()[0].pressure.iter().sum::<f64>() * grid.cell();
    let found: f64 = frame.pressure.iter().sum::<f64>() * finer.cell();
    assert!((found / coarse - 1.0).abs() < 1e-9, "{found} {coarse}");
    let reader = Reader::new(&Site::default(), Quality::default()).expect("a surface");
    let read = reader.frame(0, &frame);
    let apart = error(&finer.all(), &frame.pressure, &read.pressure);
    assert!(apart < 0.01, "{apart}");
}

#[test]
fn sensors_weigh_more_than_the_sheet() {
    let site = Site::default();
    let node = 55e-6;
    let heavy = site.borne(node, 95e-6, None);
    assert!((heavy - 555e-6).abs() < 1e-12);
    // The fastest vibration falls with the root of the mass: 4 (k + k_d)/m = w^2.
    let fastest = |mass: f64| (4.0 * (3750.0 + 1875.0) / mass).sqrt();
    assert!((fastest(node) / fastest(heavy) - 10.09_f64.sqrt()).abs() < 0.01);
    // One a square of 5 mm: 95 mm^2 bear 3.8 of them.
    assert!((site.borne(node, 95e-6, Some(5e-3)) - (55e-6 + 1.9e-3)).abs() < 1e-9);
}

#[test]
fn tables_are_read_both_ways_or_refused() {
    let table = Table::new(vec![[0.0, 5.0], [1.0, 3.0], [3.0, 2.0]]).expect("falls");
    assert_eq!((table.at(0.5), table.back(4.0), table.at(9.0), table.back(9.0)), (4.0, 0.5, 2.0, 0.0));
    assert_eq!(Table::new(vec![[0.0, 1.0]]), Err(NotMonotone(1)));
    assert_eq!(Table::new(vec![[0.0, 1.0], [1.0, 2.0], [2.0, 2.0]]), Err(NotMonotone(2)));
    let deaf = Site { moduli: [f64::INFINITY, 35e3], ..Site::default() };
    assert!(Calibration::new(&deaf).is_err(), "a spacer that does not give way tells nothing");
    assert!(antenna::mutual(1e-3, 1.0) > 0.0);
}

#[test]
fn a_tile_is_measured_within_its_instruments() {
    let mut sensors = TileSensors::new(Instruments::default(), 7, 4000.0).expect("a channel");
    let heights = |tick: u64| [0.0, 1.0, 2.0].map(|k| 0.028 * (0.002 * tick as f64 + k).sin());
    for tick in 0..5000 {
        let truth = heights(tick);
        let read = sensors.observe(tick, truth, 4000.0);
        for (height, (encoder, lvdt)) in truth.iter().zip(read.encoders.iter().zip(read.lvdts)) {
            assert!((encoder - height).abs() <= 0.5 * 4e-3 / (4.0 * 1024.0 * 30.0) + 1e-12);
            // 0.25 % of 30 mm, six deviations of noise and half a step.
            assert!((lvdt - height).abs() < 75e-6 + 30e-6 + 1e-6);
        }
        assert_eq!(read.disagree(), None);
        assert!((read.pressure - 4000.0).abs() < 75.0, "{}", read.pressure);
    }
    let at_the_end = (5000..5010).map(|t| sensors.observe(t, [0.0301, -0.0301, 0.0], 4000.0)).last();
    let read = at_the_end.expect("read");
    assert_eq!(read.switches, [[false, true], [true, false], [false, false]]);
    let mut broken = read;
    broken.encoders[1] += 0.6e-3;
    assert_eq!(broken.disagree(), Some(2));
    // A step of pressure is seen late: the lag of the membrane and a delay of 10 ms.
    let late = sensors.observe(5010, [0.0; 3], 8000.0).pressure;
    let settled = (5011..5300).map(|t| sensors.observe(t, [0.0; 3], 8000.0)).last().expect("read").pressure;
    assert!((late - 4000.0).abs() < 75.0 && (settled - 8000.0).abs() < 75.0, "{late} {settled}");
}
