//! Bladders of neighbouring tiles that press on each other.

use crate::draw::Draw;
use smartbed_bed::body::{Body, Segment, Shape};
use smartbed_bed::dynamics::{Matter, Method, Motion};
use smartbed_bed::equilibrium::{Bed, Fault, GRAVITY, Solution, Tile, put_down, solve};
use smartbed_bed::pose::Pose;
use smartbed_bed::sheet::air::Air;
use smartbed_bed::sheet::{Lattice, membrane};
use smartbed_runtime::vec3::{Vec3, add, axpy, cross, norm, scale, sub};

const SIZE: [f64; 2] = [0.219, 0.2797];

/// Two soft bladders with a gap of 6 mm, which lean towards each other by an angle (deg).
pub fn pair(pressures: [f64; 2], degrees: f64) -> Bed {
    softer(400.0, pressures, degrees)
}

/// The same with E t (N/m).
fn softer(modulus: f64, pressures: [f64; 2], degrees: f64) -> Bed {
    let lattice = Lattice::new([8, 10], SIZE, modulus).expect("a sheet");
    let tile = |k: usize| {
        let side = if k == 0 { -1.0 } else { 1.0 };
        let pose = Pose::turned([0.1125 * side, 0.0, 0.0], [0.0, 1.0, 0.0], -side * degrees.to_radians());
        Tile { pose, air: Air::Regulated(pressures[k]) }
    };
    Bed {
        lattice,
        depth: 0.1,
        tiles: vec![tile(0), tile(1)],
        friction: 0.4,
        rubbing: 0.0,
        beside: vec![[0, 1]],
        cover: smartbed_bed::equilibrium::Cover::default(),
    }
}

fn alone(bed: &Bed) -> Solution {
    solve(bed, &Body::default(), &bed.start(Vec::new())).expect("an equilibrium")
}

/// Sum of the forces of sheet and air on all free nodes of a tile, in the bed's frame: it balances the external forces.
fn pressed(bed: &Bed, solution: &Solution, tile: usize) -> Vec3<f64> {
    let sheet = &solution.state.sheets[tile];
    let mut gradient = vec![[0.0; 3]; sheet.len()];
    membrane::add_gradient(&bed.lattice, sheet, &mut gradient);
    membrane::add_volume_gradient(&bed.lattice, sheet, -solution.gauges[tile], &mut gradient);
    let free = gradient.iter().enumerate().filter(|(node, _)| bed.lattice.free(*node).is_some());
    bed.tiles[tile].pose.attitude.to_inertial(free.fold([0.0; 3], |sum, (_, g)| add(sum, *g)))
}

/// Energy of sheets and air, and of the contacts between sheets.
pub fn energy(bed: &Bed, solution: &Solution, sheets: &[Vec<Vec3<f64>>]) -> f64 {
    let own = |(tile, sheet): (usize, &Vec<Vec3<f64>>)| {
        membrane::energy(&bed.lattice, sheet) - solution.gauges[tile] * bed.volume(sheet)
    };
    let met: f64 = solution.met.iter().map(|m| m.energy(bed, sheets)).sum();
    sheets.iter().enumerate().map(own).sum::<f64>() + met
}

#[test]
fn neighbours_press_on_each_other_alike() {
    for pressures in [[4000.0, 4000.0], [4400.0, 4400.0], [4400.0, 4200.0]] {
        let bed = pair(pressures, 1.2);
        let solution = alone(&bed);
        let sheets = &solution.state.sheets;
        let forces: Vec<f64> = solution.met.iter().map(|m| m.force(&bed, sheets)).collect();
        let deepest = solution.met.iter().map(|m| m.depth(&bed, sheets)).fold(0.0, f64::max);
        let [left, right] = [0, 1].map(|tile| pressed(&bed, &solution, tile));
        println!(
            "{} steps, {} of {} press, {left:?} {right:?}, {deepest:.1e} m deep",
            solution.steps,
            forces.iter().filter(|f| **f > 0.0).count(),
            forces.len()
        );
        // To the right on the right one.
        assert!(right[0] > 1.0 && deepest < 2e-4, "{right:?} {deepest}");
        // What they do to each other is equal and opposite; facets at a rim give some of it to the rim.
        let on_rims = solution.met.iter().zip(&forces).fold([0.0; 3], |sum, (meeting, force)| {
            let rim = |end: &&(usize, usize, f64)| bed.lattice.free(end.1).is_none();
            meeting.ends.iter().filter(rim).fold(sum, |sum, end| axpy(sum, force * end.2, meeting.normal))
        });
        assert!(norm(sub(add(left, right), on_rims)) < 1e-9 * norm(left), "{left:?} {right:?} {on_rims:?}");
        // What a meeting does to node and facet is nothing in sum, neither as force nor as moment.
        for meeting in &solution.met {
            let force = meeting.force(&bed, sheets);
            let (mut sum, mut turn) = ([0.0; 3], [0.0; 3]);
            for (tile, node, share) in meeting.ends {
                let push = scale(meeting.normal, force * share);
                sum = add(sum, push);
                let place = bed.tiles[tile].pose.outwards(sheets[tile][node]);
                turn = add(turn, cross(place, push));
            }
            assert!(norm(sum) <= 1e-12 * force && norm(turn) <= 1e-9 * force, "{sum:?} {turn:?} {force}");
        }
        // The energy is least: its slope along any way is nothing, and it is curved upwards.
        let mut draw = Draw(7);
        let mut next = || 0.5 * draw.next();
        for _ in 0..5 {
            let way: Vec<Vec<Vec3<f64>>> =
                sheets
                    .iter()
                    .map(|s| {
                        (0..s.len())
                            .map(|n| {
                                if bed.lattice.free(n).is_some() {
                                    [next(), next(), next()]
                                } else {
                                    [0.0; 3]
                                }
                            })
                            .collect()
                    })
                    .collect();
            let at = |h: f64| {
                let moved: Vec<Vec<Vec3<f64>>> = sheets
                    .iter()
                    .zip(&way)
                    .map(|(s, w)| s.iter().zip(w).map(|(x, w)| axpy(*x, h, *w)).collect())
                    .collect();
                energy(&bed, &solution, &moved)
            };
            let h = 1e-5;
            let (slope, bend) = ((at(h) - at(-h)) / (2.0 * h), (at(h) - 2.0 * at(0.0) + at(-h)) / (h * h));
            assert!(slope.abs() < 1e-4 * bend * h.max(1e-3) && bend > 0.0, "{slope} {bend}");
        }
    }
}

#[test]
fn mirrored_neighbours_meet_in_the_middle() {
    let bed = pair([4000.0; 2], 1.2);
    let solution = alone(&bed);
    let places = |tile: usize| solution.state.sheets[tile].iter().map(move |x| (tile, *x));
    let beyond = places(0).chain(places(1)).map(|(tile, x)| {
        let side = if tile == 0 { 1.0 } else { -1.0 };
        side * bed.tiles[tile].pose.outwards(x)[0]
    });
    let beyond = beyond.fold(f64::NEG_INFINITY, f64::max);
    assert!((0.0..3e-4).contains(&beyond), "{beyond}");
    // Without their meeting they would run into each other.
    let apart = Bed { beside: Vec::new(), ..bed };
    let free = alone(&apart);
    let over = free.state.sheets[0].iter().map(|x| apart.tiles[0].pose.outwards(*x)[0]);
    assert!(over.fold(0.0, f64::max) > 3e-3 && free.met.is_empty());
}

#[test]
fn what_does_not_touch_stays_as_it_was() {
    let mut bed = pair([4000.0; 2], 0.5);
    bed.lattice = Lattice::new([8, 10], SIZE, 5000.0).expect("a sheet");
    let with = alone(&bed);
    let without = alone(&Bed { beside: Vec::new(), ..bed.clone() });
    assert!(with.met.is_empty());
    assert_eq!(with.state, without.state);
}

#[test]
fn a_load_on_bladders_that_touch_is_carried_in_both_clocks() {
    let bed = pair([4400.0; 2], 1.2);
    let mut body = Body::single(Segment {
        name: "slab".to_owned(),
        shape: Shape { half: [0.15, 0.1, 0.02], radius: 0.03 }.into(),
        mass: 6.0,
        centre: [0.0; 3],
        foundation: 1e6,
        free: [true; 6],
    });
    body.segments[0].free = [false, false, true, false, false, false];
    let start = bed.start(vec![Pose::at([0.0, 0.0, 0.25])]);
    let rest = put_down(&bed, &body, &start).expect("rests");
    assert!(rest.imbalance < 1e-6 && rest.met.iter().any(|m| m.depth(&bed, &rest.state.sheets) > 0.0));
    let mut motion =
        Motion::new(bed.clone(), body, rest.state.clone(), Matter::default(), Method::Bdf2, 5e-3);
    // One bladder loses pressure and regains it.
    let told = |time: f64| {
        let mut bed = bed.clone();
        bed.tiles[0].air = Air::Regulated(4400.0 - 500.0 * (std::f64::consts::PI * time.min(1.0)).sin());
        bed
    };
    let mut left_over = 0.0_f64;
    while motion.time() < 3.0 - 1e-9 {
        motion.step(told).expect("a step");
        assert!(motion.now.imbalance < 1e-6, "{}", motion.now.imbalance);
        left_over = left_over.max(motion.ledger.left_over().abs());
    }
    let end = &motion.now.state;
    let off = norm(sub(end.segments[0].place, rest.state.segments[0].place));
    let still = solve(&motion.bed, &motion.body, end).expect("an equilibrium");
    let away = norm(sub(still.state.segments[0].place, end.segments[0].place));
    println!(
        "{off:.1e} m from the start, {away:.1e} m from rest, {left_over:.1e} J left over of {:.2}",
        6.0 * GRAVITY * 0.05
    );
    assert!(off < 1e-3 && away < 1e-5 && left_over < 0.01 * 6.0 * GRAVITY * 0.05);
}

/// The largest distance between nodes of two states (m).
fn apart(one: &Solution, other: &Solution) -> f64 {
    let nodes = |s: &Solution| s.state.sheets.concat();
    nodes(one).into_iter().zip(nodes(other)).map(|(a, b)| norm(sub(a, b))).fold(0.0, f64::max)
}

#[test]
fn sheets_that_lean_far_over_their_rims_meet_and_rest() {
    for (modulus, pressure, degrees) in [(300.0, 3600.0, 0.0), (300.0, 3200.0, 1.2), (250.0, 2800.0, 0.0)] {
        let bed = softer(modulus, [pressure; 2], degrees);
        let solution = alone(&bed);
        let sheets = &solution.state.sheets;
        let deepest = solution.met.iter().map(|m| m.depth(&bed, sheets)).fold(0.0, f64::max);
        let beyond = sheets[0].iter().map(|x| bed.tiles[0].pose.outwards(*x)[0]).fold(0.0, f64::max);
        let free = alone(&Bed { beside: Vec::new(), ..bed.clone() });
        let over = free.state.sheets[0].iter().map(|x| bed.tiles[0].pose.outwards(*x)[0]).fold(0.0, f64::max);
        println!(
            "{modulus} N/m, {pressure} Pa, {degrees} deg: {} steps, {:.1} N, {:.2} mm deep, {:.2} mm beyond the middle, {:.1} mm alone",
            solution.steps,
            pressed(&bed, &solution, 1)[0],
            1e3 * deepest,
            1e3 * beyond,
            1e3 * over
        );
        // By themselves they would run into each other by more than a centimetre.
        assert!(over > 5e-3 && beyond < 3e-4 && (1e-6..2e-4).contains(&deepest), "{over} {beyond} {deepest}");
        assert!(pressed(&bed, &solution, 1)[0] > 1.0);
        // It is the same rest when their pressure rises little by little.
        let mut state = bed.start(Vec::new());
        let mut slow = None;
        for step in 1..=8 {
            let bed = softer(modulus, [pressure * f64::from(step) / 8.0; 2], degrees);
            let found = solve(&bed, &Body::default(), &state).expect("an equilibrium");
            state = found.state.clone();
            slow = Some(found);
        }
        let off = apart(&solution, &slow.expect("steps"));
        assert!(off < 1e-5, "{off}");
    }
}

#[test]
fn a_bed_of_soft_bladders_rests() {
    // Each of six meets its neighbours on all sides.
    let bed = softer(300.0, [4000.0; 2], 0.0);
    let tile = |k: usize| {
        let place = [0.225 * ((k % 2) as f64 - 0.5), 0.2857 * ((k / 2) as f64 - 1.0), 0.0];
        Tile { pose: Pose::at(place), air: Air::Regulated(4000.0) }
    };
    let beside = vec![[0, 1], [2, 3], [4, 5], [2, 0], [3, 1], [4, 2], [5, 3]];
    let bed = Bed { tiles: (0..6).map(tile).collect(), beside, ..bed };
    let solution = alone(&bed);
    let deepest = solution.met.iter().map(|m| m.depth(&bed, &solution.state.sheets)).fold(0.0, f64::max);
    let forces = (0..6).map(|tile| pressed(&bed, &solution, tile));
    let across = |f: Vec3<f64>| (f[0].abs(), f[1].abs());
    println!("{} steps, {:.2} mm deep", solution.steps, 1e3 * deepest);
    assert!(deepest < 5e-4, "{deepest}");
    for (tile, force) in forces.enumerate() {
        let (x, y) = across(force);
        // Those in the middle row are pressed from both sides alike.
        assert!(x > 1.0 && if tile / 2 == 1 { y < 0.05 * x } else { y > 1.0 }, "{tile} {force:?}");
    }
}

#[test]
fn a_sheet_too_soft_for_its_pressure_is_refused_by_name() {
    // Springs T = k (l - L) bear a pressure of some 12.5/m times E t and no more; a neighbour holds a sheet some
    // further.
    let say = |modulus: f64, pressure: f64, is_alone: bool| {
        let mut bed = softer(modulus, [pressure; 2], 0.0);
        if is_alone {
            bed.beside.clear();
        }
        solve(&bed, &Body::default(), &bed.start(Vec::new())).map(|s| s.steps)
    };
    for modulus in [250.0, 300.0, 400.0] {
        let found = [11.0, 14.5].map(|share| say(modulus, share * modulus, true));
        assert!(found[0].is_ok(), "{modulus} {found:?}");
        assert!(matches!(found[1], Err(Fault::Burst(..))), "{modulus} {found:?}");
    }
    assert!(say(250.0, 3200.0, true).is_err() && say(250.0, 3200.0, false).is_ok());
    let said = say(300.0, 4500.0, false).expect_err("too soft").to_string();
    assert!(
        said.starts_with("the sheet of tile ") && said.contains("a larger `modulus` or less pressure"),
        "{said}"
    );
}
