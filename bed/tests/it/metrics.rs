//! Metrics against maps made by hand, whose answers are known.

use smartbed_bed::map::{Frame, Grid, MMHG, MapError, Recording, Region, Site};
use smartbed_bed::metrics::braden::Braden;
use smartbed_bed::metrics::report::Report;
use smartbed_bed::metrics::tissue::{Dose, Sigmoid};
use smartbed_bed::metrics::{Thresholds, shear, spatial, time, tissue};

const CM: Grid = Grid { rows: 6, columns: 6, row_pitch: 0.01, column_pitch: 0.01 };

#[track_caller]
fn near(found: f64, expected: f64) {
    let error = (found - expected).abs();
    assert!(error <= 1e-12 * expected.abs().max(1e-300), "{found} against {expected}: {error:e}");
}

fn frame(time: f64, seconds: f64, pressure: &[f64]) -> Frame {
    Frame { time, seconds, pressure: pressure.to_vec(), shear: Vec::new() }
}

fn two_sites(frames: &[(f64, [f64; 2])]) -> Recording {
    let sites = vec![Site { area: 1e-4, region: None }, Site { area: 3e-4, region: Some(Region::Sacrum) }];
    let mut time = 0.0;
    let mut made = Vec::new();
    for (seconds, pressure) in frames {
        made.push(frame(time, *seconds, pressure));
        time += seconds;
    }
    Recording::new(sites, made).expect("sound")
}

#[test]
fn the_window_finds_a_block_between_sensels() {
    // A block of 3 x 3 cm at 60 mmHg among 10 mmHg: the window of 9 cm^2 lies on it.
    let mut map = vec![10.0 * MMHG; 36];
    for row in 2..5 {
        for column in 1..4 {
            map[row * 6 + column] = 60.0 * MMHG;
        }
    }
    near(spatial::peak_pressure_index(&CM, &map, 9e-4).expect("fits"), 60.0 * MMHG);
    // 4 cm^2 too; 16 cm^2 holds the nine and seven others.
    near(spatial::peak_pressure_index(&CM, &map, 4e-4).expect("fits"), 60.0 * MMHG);
    near(
        spatial::peak_pressure_index(&CM, &map, 16e-4).expect("fits"),
        (9.0 * 60.0 + 7.0 * 10.0) / 16.0 * MMHG,
    );
    // Sensels of 2 cm: the window of 3 cm covers one whole, two halves and a quarter.
    let coarse = Grid { rows: 2, columns: 2, row_pitch: 0.02, column_pitch: 0.02 };
    let found = spatial::peak_pressure_index(&coarse, &[9.0, 3.0, 1.0, 2.0], 9e-4).expect("fits");
    near(found, (4.0 * 9.0 + 2.0 * 3.0 + 2.0 * 1.0 + 2.0) / 9.0);
    assert_eq!(spatial::peak_pressure_index(&coarse, &[1.0; 4], 17e-4), None);
    // As wide as the map itself: the mean of all.
    near(spatial::peak_pressure_index(&coarse, &[9.0, 3.0, 1.0, 3.0], 16e-4).expect("fits"), 4.0);
}

#[test]
fn one_map_by_hand() {
    let sites = [1e-4, 2e-4, 1e-4, 4e-4].map(|area| Site { area, region: None });
    let map = [30.0 * MMHG, 60.0 * MMHG, 4.0 * MMHG, 130.0 * MMHG];
    near(spatial::peak(&map), 130.0 * MMHG);
    let spread = spatial::spread(&sites, &map, 5.0 * MMHG).expect("contact");
    // Areas 1, 2 and 4: mean 670/7, variance (1 x 30^2 + 2 x 60^2 + 4 x 130^2)/7 - mean^2.
    let mean: f64 = 670.0 / 7.0;
    let deviation = ((900.0 + 7200.0 + 67600.0) / 7.0 - mean * mean).sqrt();
    near(spread.mean, mean * MMHG);
    near(spread.deviation, deviation * MMHG);
    near(spread.variation, deviation / mean);
    near(spatial::area_above(&sites, &map, 32.0 * MMHG), 6e-4);
    near(spatial::area_above(&sites, &map, 60.0 * MMHG), 4e-4);
    assert_eq!(spatial::spread(&sites, &[0.0; 4], 1.0), None);
    near(spatial::apart(&[1.0, 2.0, 3.0, 4.0], &[1.0, 4.0, 0.0, 4.0]), 13.0_f64.sqrt() / 2.0);
    let regions = [Some(Region::Sacrum), None, Some(Region::Ischia), None];
    let sites: Vec<Site> = regions.iter().map(|r| Site { area: 1e-4, region: *r }).collect();
    near(spatial::dispersion(&sites, &map, |s| s.region.is_some()).expect("load"), 100.0 * 34.0 / 224.0);
    near(
        spatial::load_error(&sites, &[1e4; 4], &[0.5; 4], &[1e3; 4], 2.5),
        (2.0 + 0.4 - 2.5_f64).abs() / 2.5,
    );
}

#[test]
fn the_gradient_of_a_plane_and_of_a_step() {
    let grid = Grid { rows: 3, columns: 4, row_pitch: 0.02, column_pitch: 0.01 };
    let plane: Vec<f64> = (0..12).map(|i| 300.0 * (i % 4) as f64 + 800.0 * (i / 4) as f64).collect();
    let gradient = spatial::gradient(&grid, &plane);
    near(gradient.largest, 4e4);
    near(gradient.root_mean_square, 5e4);
    // A spike of 8 in the middle of a 3 x 3 map of pitch 1: neighbours see central differences of 8/2 across the edge.
    let grid = Grid { rows: 3, columns: 3, row_pitch: 1.0, column_pitch: 1.0 };
    let mut spike = [0.0; 9];
    spike[4] = 8.0;
    let gradient = spatial::gradient(&grid, &spike);
    near(gradient.largest, 8.0);
    // One-sided at the four edges beside it (8), nothing at corners, 0 in the middle.
    near(gradient.root_mean_square, (4.0 * 64.0 / 9.0_f64).sqrt());
}

#[test]
fn the_centre_of_pressure_and_its_shifts() {
    let one = |site: usize| {
        let mut map = vec![0.0; 36];
        map[site] = 1000.0;
        map
    };
    let [x, y] = spatial::centre(&CM, &one(8)).expect("load");
    near(x, 0.025);
    near(y, 0.015);
    assert_eq!(spatial::centre(&CM, &[0.0; 36]), None);
    // 1, 1, 1 cm along x, back 3 cm: 30 mm counted once at 30 mm, and once on the way back.
    let places = [0, 1, 2, 3, 0];
    let frames = places.iter().enumerate().map(|(k, site)| frame(k as f64, 1.0, &one(*site))).collect();
    let recording = Recording::new(CM.all(), frames).expect("sound");
    let mobility = time::mobility(&CM, &recording, 0.02);
    near(mobility.path, 0.06);
    assert_eq!(mobility.shifts, 2);
}

#[test]
fn histories_by_hand() {
    let m = MMHG;
    let recording =
        two_sites(&[(300.0, [40.0 * m, 50.0 * m]), (200.0, [20.0 * m, 33.0 * m]), (100.0, [0.0, 60.0 * m])]);
    near(recording.seconds(), 600.0);
    near(time::persistent_occlusion(&recording, 600.0, 32.0 * m).expect("long enough"), 3e-4);
    // The last 100 s only: the second site; a longer cycle than was recorded is not answered.
    near(time::persistent_occlusion(&recording, 100.0, 32.0 * m).expect("long enough"), 3e-4);
    assert_eq!(time::persistent_occlusion(&recording, 601.0, 32.0 * m), None);
    near(time::always_at_risk(&recording, 32.0 * m), 3e-4);
    assert_eq!(time::always_at_risk(&recording, 50.0 * m), 0.0);
    let contrast = time::contrast(&recording, 600.0).expect("long enough");
    near(contrast[0], 40.0 * m);
    near(contrast[1], 27.0 * m);
    let integral = time::pressure_time(&recording, 0.0);
    near(integral[0], (12000.0 + 4000.0) * m);
    near(integral[1], (15000.0 + 6600.0 + 6000.0) * m);
    near(time::pressure_time(&recording, 32.0 * m)[1], (18.0 * 300.0 + 200.0 + 2800.0) * m);
    let relief = time::relief(&recording, 30.0 * m);
    near(relief[0], 0.5);
    assert_eq!(relief[1], 0.0);
    near(tissue::reswick_rogers_margin(150.0 * m * 3600.0), 0.5);
}

#[test]
fn what_muscle_bears() {
    let sigmoid = Sigmoid::default();
    // 40 digits by another program, rounded: P(t min) in kPa, t(P kPa) in min.
    for (minutes, kilopascal) in [
        (0.0, 31.999_968_5),
        (60.0, 31.747_3),
        (75.0, 29.807_0),
        (90.0, 20.5),
        (105.0, 11.193),
        (120.0, 9.252_7),
    ] {
        let found = sigmoid.pressure(minutes * 60.0) / 1000.0;
        assert!((found - kilopascal).abs() < 1e-3, "{found} {kilopascal}");
    }
    for (kilopascal, minutes) in [(12.0, 102.647), (15.0, 96.943), (25.0, 84.489)] {
        let found = sigmoid.time(kilopascal * 1000.0) / 60.0;
        assert!((found - minutes).abs() < 1e-3, "{found} {minutes}");
    }
    near(sigmoid.pressure(90.0 * 60.0), 20.5e3);
    assert_eq!(sigmoid.time(9e3), f64::INFINITY);
    assert_eq!(sigmoid.time(32e3), 0.0);
    // The two are inverses of one another.
    for time in [3000.0, 5400.0, 6600.0] {
        assert!((sigmoid.time(sigmoid.pressure(time)) / time - 1.0).abs() < 1e-12);
    }
    // Constant load: t/t_crit; a release begins anew.
    let shares = sigmoid.shares(&two_sites(&[(600.0, [6e3, 12.5e3])]), 1.0, 2.0);
    near(shares[0], 600.0 / sigmoid.time(12e3));
    near(shares[1], 600.0 / sigmoid.time(25e3));
    let released = two_sites(&[(600.0, [6e3, 6e3]), (10.0, [0.0, 6e3]), (300.0, [6e3, 6e3])]);
    let shares = sigmoid.shares(&released, 1.0, 2.0);
    near(shares[0], 600.0 / sigmoid.time(12e3));
    near(shares[1], 910.0 / sigmoid.time(12e3));
}

#[test]
fn a_dose_rises_and_recovers() {
    let dose = Dose { harmless: 4e3, exponent: 2.0, scale: 1e6, recovery: 100.0 };
    // Rate (1 kPa)^2/1e6 = 1/s for 100 s: 100 (1 - 1/e); then it only falls.
    let one = two_sites(&[(100.0, [5e3, 4e3]), (50.0, [0.0, 0.0])]);
    near(dose.largest(&one)[0], 100.0 * (1.0 - (-1.0_f64).exp()));
    assert_eq!(dose.largest(&one)[1], 0.0);
    // Two frames are one: the solution of each is exact.
    let split = two_sites(&[(40.0, [5e3, 0.0]), (60.0, [5e3, 0.0])]);
    near(dose.largest(&split)[0], 100.0 * (1.0 - (-1.0_f64).exp()));
}

#[test]
fn shear_by_hand() {
    let sites = vec![Site { area: 1e-4, region: None }, Site { area: 2e-4, region: None }];
    let with = |time: f64, shear: [[f64; 2]; 2]| Frame {
        time,
        seconds: 2.0,
        pressure: vec![4e3, 2e3],
        shear: shear.to_vec(),
    };
    let frames = vec![with(0.0, [[300.0, 400.0], [0.0, 1000.0]]), with(2.0, [[-400.0, 300.0], [0.0, 0.0]])];
    let recording = Recording::new(sites.clone(), frames).expect("sound");
    let first = &recording.frames()[0];
    near(shear::peak(&first.shear), 1000.0);
    let [x, y] = shear::resultant(&sites, &first.shear);
    near(x, 0.03);
    near(y, 0.24);
    near(shear::slip(first, 100.0, 0.4).expect("contact"), 1.25);
    assert_eq!(shear::slip(first, 5e3, 0.4), None);
    // 4000 (1 + 2 500/250) Pa; 2000 (1 + 2 1000/250) Pa is less.
    near(shear::equivalent_pressure(first, 2.0, 250.0).expect("sheared"), 20_000.0);
    assert_eq!(shear::equivalent_pressure(&Frame { shear: Vec::new(), ..first.clone() }, 2.0, 250.0), None);
    near(shear::shear_time(&recording)[0], 2000.0);
    near(shear::turning(&recording, 100.0)[0], std::f64::consts::FRAC_PI_2);
    assert_eq!(shear::turning(&recording, 100.0)[1], 0.0);
    near(shear::differential_drag([0.011, 0.0], [-0.011, 0.0], 0.006), 0.022 / 0.006);
}

#[test]
fn a_nurse_enters_the_braden_scale() {
    let braden = Braden::new([2, 3, 1, 2, 2, 1]).expect("within");
    assert_eq!((braden.sum(), braden.band()), (11, "high risk"));
    assert_eq!(Braden::new([4, 4, 4, 4, 4, 3]).expect("within").band(), "no particular risk");
    let wrong = Braden::new([4, 4, 4, 4, 4, 4]).expect_err("beyond").to_string();
    assert_eq!(wrong, "Braden mark `friction_and_shear` is 4, expected 1 to 3");
}

#[test]
fn a_report_has_every_metric_of_bed_and_region() {
    let mut sites = CM.all();
    (12..18).for_each(|i| sites[i].region = Some(Region::Sacrum));
    let pressure: Vec<f64> = (0..36).map(|i| if i / 6 == 2 { 40.0 * MMHG } else { 20.0 * MMHG }).collect();
    let shear = vec![[100.0, 0.0]; 36];
    let frames = vec![Frame { time: 0.0, seconds: 600.0, pressure, shear }];
    let recording = Recording::new(sites, frames).expect("sound");
    let rows =
        Report { recording: &recording, grid: Some(&CM), thresholds: Thresholds::default(), friction: 0.4 }
            .rows();
    let value = |place: &str, metric: &str| {
        let found = rows.iter().find(|r| r.place == place && r.metric == metric);
        found.unwrap_or_else(|| panic!("no {metric} of {place}")).value
    };
    near(value("bed", "peak pressure").expect("load"), 40.0);
    near(value("bed", "mean pressure").expect("load"), (6.0 * 40.0 + 30.0 * 20.0) / 36.0);
    near(value("sacrum", "mean pressure").expect("load"), 40.0);
    for (place, name) in
        [("sacrum", "share of all pressures"), ("bed", "dispersion index of sacrum and seat bones")]
    {
        near(value(place, name).expect("load"), 100.0 * 240.0 / 840.0);
    }
    // Twice the pressure, and p (1 + 5 tau/10 kPa) at 100 Pa of shear.
    near(value("sacrum", "peak stress in muscle").expect("load"), 2.0 * 40.0 * MMHG / 1000.0);
    near(value("bed", "peak pressure of the same risk without shear").expect("shear"), 40.0 * 1.05);
    near(value("bed", "persistent occlusion, last cycle").expect("a cycle"), 6.0);
    assert_eq!(value("bed", "persistent occlusion, last 2 h"), None);
    near(value("bed", "peak pressure index, 9 cm2").expect("fits"), (40.0 + 20.0 + 20.0) / 3.0);
    near(value("sacrum", "pressure time integral").expect("load"), 40.0 / 6.0);
    assert!(rows.iter().filter(|r| r.place == "bed").count() > 25, "{}", rows.len());
}

#[test]
fn unsound_readings_are_refused_with_their_place() {
    let site = |area| Site { area, region: None };
    let make = |frames: Vec<Frame>| Recording::new(vec![site(1.0), site(1.0)], frames);
    assert_eq!(Recording::new(vec![site(0.0)], Vec::new()), Err(MapError::Area { site: 0, area: 0.0 }));
    let short = make(vec![frame(0.0, 1.0, &[1.0])]);
    assert_eq!(short, Err(MapError::Length { frame: 0, found: 1, expected: 2 }));
    let negative = make(vec![frame(0.0, 1.0, &[1.0, 1.0]), frame(1.0, 1.0, &[1.0, -1.0])]);
    assert_eq!(negative, Err(MapError::Value { frame: 1, site: 1 }));
    let back = make(vec![frame(1.0, 1.0, &[1.0, 1.0]), frame(1.0, 1.0, &[1.0, 1.0])]);
    assert_eq!(back, Err(MapError::Time { frame: 1 }));
    assert!(make(vec![frame(0.0, f64::NAN, &[1.0, 1.0])]).is_err());
}
