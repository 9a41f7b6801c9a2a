//! Friction between bladders of neighbouring tiles.

use crate::beside::{energy, pair};
use crate::draw::Draw;
use smartbed_bed::body::Body;
use smartbed_bed::dynamics::{Matter, Method, Motion};
use smartbed_bed::equilibrium::{Bed, Meeting, Rub, Solution, State, solve};
use smartbed_bed::sheet::air::Air;
use smartbed_runtime::vec3::{axpy, dot, norm, sub};

/// Friction coefficient at which sheets stick.
const MU: f64 = 0.3;
/// Friction coefficient at which sheets slide; at larger ones soft sheets roll on each other.
const LITTLE: f64 = 0.08;

/// Two soft bladders that lean towards each other, the second raised (m).
fn raised(rubbing: f64, height: f64) -> Bed {
    let mut bed = pair([4400.0; 2], 1.2);
    bed.rubbing = rubbing;
    bed.tiles[1].pose.place[2] += height;
    bed
}

/// Equilibria one after the other, as the second is raised.
fn lifted(rubbing: f64, heights: &[f64]) -> Vec<Solution> {
    let bed = raised(rubbing, 0.0);
    let mut found = vec![solve(&bed, &Body::default(), &bed.start(Vec::new())).expect("rests")];
    for height in heights {
        let state: &State = &found[found.len() - 1].state;
        let next = solve(&raised(rubbing, *height), &Body::default(), state).expect("rests");
        found.push(next);
    }
    found
}

/// The meeting that a rub belongs to.
fn meeting<'a>(solution: &'a Solution, rub: &Rub) -> &'a Meeting {
    solution.met.iter().find(|m| m.ends == rub.ends).expect("anchored where they met")
}

/// Largest distance of nodes (m).
fn apart(a: &Solution, b: &Solution) -> f64 {
    let places = |s: &Solution| s.state.sheets.concat();
    places(a).into_iter().zip(places(b)).map(|(a, b)| norm(sub(a, b))).fold(0.0, f64::max)
}

#[test]
fn what_slides_is_dragged_by_the_coefficient_times_the_force() {
    let heights: Vec<f64> = (1..=20).map(|k| 5e-4 * f64::from(k)).collect();
    let found = lifted(LITTLE, &heights);
    let (bed, end) = (raised(LITTLE, 0.01), &found[20]);
    let (mut sliding, mut all, mut drag, mut pressed) = (0, 0, 0.0, 0.0);
    for rub in &end.state.rubs {
        let met = meeting(end, rub);
        let normal_force = met.force(&bed, &end.state.sheets);
        assert!((rub.limit - LITTLE * normal_force).abs() < 1e-9 && dot(rub.force, rub.normal).abs() < 1e-9);
        assert!(norm(rub.force) <= rub.limit * (1.0 + 1e-9));
        (all, pressed) = (all + 1, pressed + normal_force);
        sliding += usize::from(norm(rub.force) > 0.999 * rub.limit);
        // On the first tile: the facet's share is 1, the node's -1, and a force is -share t.
        drag += if rub.ends[4].0 == 0 { rub.force[2] } else { -rub.force[2] };
    }
    println!("{sliding} of {all} slide; {drag:.3} N up on the first of {pressed:.2} N");
    // The second goes up and takes the first along: by mu N where all of it slides straight up.
    assert!(4 * sliding > 3 * all && all > 4, "{sliding} {all}");
    assert!(drag > 0.9 * LITTLE * pressed && drag <= LITTLE * pressed, "{drag} {pressed}");
    // Back down again the drag turns round, and sheets do not come back to where they were; without friction they do.
    let way: Vec<f64> = heights.iter().copied().chain((0..20).rev().map(|k| 5e-4 * f64::from(k))).collect();
    let [rough, smooth] = [LITTLE, 0.0].map(|rubbing| {
        let found = lifted(rubbing, &way);
        apart(&found[0], &found[40])
    });
    println!("back again {rough:.1e} m apart, {smooth:.1e} m without friction");
    assert!(rough > 1e-5 && smooth < 1e-6, "{rough} {smooth}");
}

#[test]
fn what_sticks_holds_like_a_spring_and_the_energy_is_least() {
    // A twentieth of a millimetre is held by all but what hardly presses.
    let found = lifted(MU, &[5e-5]);
    let (bed, end) = (raised(MU, 5e-5), &found[1]);
    let rubs = &end.state.rubs;
    let stuck = rubs.iter().filter(|rub| norm(rub.force) < 0.999 * rub.limit).count();
    assert!(2 * stuck > rubs.len() && stuck > 4, "{stuck} of {}", rubs.len());
    assert!(rubs.iter().any(|rub| norm(rub.force) > 1e-3));
    // Along any way of the free nodes the energy of sheets, air, meetings and friction has no slope and bends up.
    let mut draw = Draw(11);
    let mut next = || 0.5 * draw.next();
    for _ in 0..3 {
        let mut way = end.state.sheets.clone();
        for (node, x) in way.iter_mut().flat_map(|sheet| sheet.iter_mut().enumerate()) {
            *x = if bed.lattice.free(node).is_some() { [next(), next(), next()] } else { [0.0; 3] };
        }
        let at = |h: f64| {
            let mut sheets = end.state.sheets.clone();
            for (sheet, way) in sheets.iter_mut().zip(&way) {
                sheet.iter_mut().zip(way).for_each(|(x, w)| *x = axpy(*x, h, *w));
            }
            let rubbed: f64 =
                found[0].state.rubs.iter().map(|rub| renewed(rub, end).energy(&bed, &sheets)).sum();
            energy(&bed, end, &sheets) + rubbed
        };
        let h = 1e-6;
        let (slope, bend) = ((at(h) - at(-h)) / (2.0 * h), (at(h) - 2.0 * at(0.0) + at(-h)) / (h * h));
        assert!(slope.abs() < 1e-3 * bend * h.max(1e-4) && bend > 0.0, "{slope} {bend}");
    }
}

/// A rub of the state before with the limit and the normal that hold at the end.
fn renewed(rub: &Rub, end: &Solution) -> Rub {
    let of = |r: &&Rub| (r.ends[4], r.ends[0].0) == (rub.ends[4], rub.ends[0].0);
    end.state.rubs.iter().find(of).map_or(Rub { limit: 0.0, ..*rub }, |now| Rub {
        limit: now.limit,
        normal: now.normal,
        ..*rub
    })
}

#[test]
fn slip_between_sheets_takes_energy_and_the_ledger_knows_it() {
    for rubbing in [LITTLE, MU] {
        // The second goes up by 4 mm and down again, twice; what is missed in the end, and what drives have given.
        let run = |step: f64| {
            let bed = raised(rubbing, 0.0);
            let rest = solve(&bed, &Body::default(), &bed.start(Vec::new())).expect("rests");
            let mut motion =
                Motion::new(bed, Body::default(), rest.state, Matter::default(), Method::Bdf2, step);
            let told = |time: f64| raised(rubbing, 2e-3 * (1.0 - (std::f64::consts::TAU * time).cos()));
            while motion.time() < 2.0 - 1e-9 {
                motion.step(told).expect("a step");
            }
            let ledger = motion.ledger;
            assert!(ledger.lost_by_friction > ledger.lost_in_sheets, "{ledger:?}");
            (ledger.left_over().abs(), ledger.driven)
        };
        let [(long, _), (short, driven)] = [5e-3, 2.5e-3].map(run);
        println!("mu {rubbing}: {long:.1e} and {short:.1e} J left over of {driven:.1e} J at 5 and 2.5 ms");
        assert!(short < 0.05 * driven && short < 0.75 * long, "{long} {short} {driven}");
    }
}

#[test]
fn what_sheets_give_by_turning_on_each_other_is_booked_at_any_step() {
    // Without friction: one goes up and down, or loses pressure and regains it.
    let rises = |time: f64| raised(0.0, 2e-3 * (1.0 - (std::f64::consts::TAU * time).cos()));
    let changes = |time: f64| {
        let mut bed = raised(0.0, 0.0);
        let low = 500.0 * (std::f64::consts::PI * time).sin().powi(2);
        bed.tiles[0].air = Air::Regulated(4400.0 - low);
        bed
    };
    let missed = |told: &dyn Fn(f64) -> Bed, step: f64| {
        let bed = told(0.0);
        let rest = solve(&bed, &Body::default(), &bed.start(Vec::new())).expect("rests");
        let mut motion = Motion::new(bed, Body::default(), rest.state, Matter::default(), Method::Bdf2, step);
        let (mut worst, mut without) = (0.0_f64, 0.0_f64);
        while motion.time() < 1.0 - 1e-9 {
            motion.step(told).expect("a step");
            let ledger = motion.ledger;
            worst = worst.max(ledger.left_over().abs());
            without = without.max((ledger.left_over() + ledger.turned).abs());
        }
        (worst, without)
    };
    for (name, told) in [("rises", &rises as &dyn Fn(f64) -> Bed), ("changes its pressure", &changes)] {
        let found = [10e-3, 5e-3, 2.5e-3].map(|step| missed(told, step));
        println!("one {name}: left over, and what would be without it: {found:?}");
        // What would be missed does not go away with the step.
        assert!(found.iter().all(|f| f.1 > 6e-3), "{found:?}");
        assert!(found[2].0 < 1e-4 && found.windows(2).all(|f| f[0].0 > 3.0 * f[1].0), "{found:?}");
    }
}
