//! Pressure: Eq. 3.10 against the vector area, closed surfaces, p dV = work, the gas law, the inflation limit.

use smartbed::scene::run::run;
use smartbed::scene::{Scene, Simulation, parse, shape};
use smartbed_runtime::flexible::PressureForm;
use smartbed_runtime::flexible::pressure::{corner_shares, corners, enclosed_volume};

type Vector = [f64; 3];

fn sub(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn largest(a: Vector) -> f64 {
    a.iter().fold(0.0, |m, c| m.max(c.abs()))
}

/// 3 x 3 points of a bumpy grid, row by row.
fn grid() -> Vec<Vector> {
    (0..9)
        .map(|i| {
            let (x, y) = (f64::from(i % 3), f64::from(i / 3));
            [x + 0.1 * (3.0 * y).sin(), y + 0.2 * (2.0 * x).cos(), 0.3 * (x * x - 1.3 * x * y)]
        })
        .collect()
}

/// Sum of the shares at the middle of the grid.
fn at_middle(form: PressureForm) -> Vector {
    let pos = grid();
    let mut sum = [0.0; 3];
    for facet in [[0, 1, 4, 3], [1, 2, 5, 4], [3, 4, 7, 6], [4, 5, 8, 7]] {
        let shares = corner_shares(form, corners(&pos, &facet));
        for (corner, share) in facet.iter().zip(shares) {
            if *corner == 4 {
                (0..3).for_each(|c| sum[c] += share[c]);
            }
        }
    }
    sum
}

#[test]
fn eq_3_10_is_one_cross_product() {
    let x = grid();
    let (south, west, east, north) = (x[1], x[3], x[5], x[7]);
    let expected = cross(sub(east, west), sub(north, south));
    let fan = at_middle(PressureForm::Fan);
    assert!(largest(sub(fan, expected)) <= 1e-14, "{fan:?} {expected:?}");
}

#[test]
fn exact_form_is_the_gradient_of_the_bilinear_volume() {
    let x = grid();
    let (sw, s, se, w, e, nw, n, ne) = (x[0], x[1], x[2], x[3], x[5], x[6], x[7], x[8]);
    let terms = [
        cross(sub(e, w), sub(n, s)),
        cross(e, sub(ne, se)),
        cross(n, sub(nw, ne)),
        cross(w, sub(sw, nw)),
        cross(s, sub(se, sw)),
    ];
    let expected = [0, 1, 2].map(|c| terms.iter().map(|t| t[c]).sum::<f64>() / 12.0);
    let exact = at_middle(PressureForm::Exact);
    assert!(largest(sub(exact, expected)) <= 1e-14, "{exact:?} {expected:?}");
}

fn text(name: &str) -> String {
    let path = format!("{}/../models/scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(path).expect("scene")
}

fn scene(name: &str, settings: &[&str]) -> Scene {
    let settings: Vec<String> = settings.iter().map(|s| (*s).to_string()).collect();
    parse(name, &text(name), &settings).expect("scene")
}

#[test]
fn closed_surfaces_feel_no_net_force_and_work_is_p_dv() {
    for body in [shape::cube(1.0), shape::prism(1.0, 1.0), shape::ball(8, 6, 0.5)] {
        let mut pos = body.points.clone();
        pos.iter_mut().enumerate().for_each(|(i, x)| x[i % 3] += 0.05 * (i as f64).sin());
        let lists = body.clone();
        let (own, tetrahedra) = (enclosed(&lists, &pos), volume_of(&lists, &pos));
        assert!((own - tetrahedra).abs() <= 1e-14, "{own} {tetrahedra}");
        for form in [PressureForm::Facet, PressureForm::Exact] {
            let mut sum = [0.0; 3];
            let mut shares = vec![[0.0; 3]; pos.len()];
            for facet in &lists.facets {
                for (corner, share) in facet.iter().zip(corner_shares(form, corners(&pos, facet))) {
                    (0..3).for_each(|c| (sum[c] += share[c], shares[*corner][c] += share[c]).0);
                }
            }
            assert!(largest(sum) <= 1e-14, "{form:?}: {sum:?}");
            if form == PressureForm::Exact {
                // dV/dx by central differences of the volume of tetrahedra.
                let h = 1e-6;
                for i in 0..pos.len() {
                    for c in 0..3 {
                        let mut volume = |d: f64| {
                            pos[i][c] += d;
                            let v = volume_of(&lists, &pos);
                            pos[i][c] -= d;
                            v
                        };
                        let slope = (volume(h) - volume(-h)) / (2.0 * h);
                        assert!((slope - shares[i][c]).abs() <= 1e-9, "{i} {c}: {slope} {}", shares[i][c]);
                    }
                }
            }
        }
    }
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Volume under all facets from tetrahedra alone: a patch over a skew quadrilateral halves the tetrahedron of its
/// corners, so it encloses the mean of what its two triangulations do.
fn volume_of(lists: &smartbed::scene::Lists, pos: &[Vector]) -> f64 {
    let under = |[p, q, r]: [usize; 3]| dot(pos[p], cross(pos[q], pos[r])) / 6.0;
    let patch = |f: &[usize; 4]| {
        let [a, b, c, d] = *f;
        0.5 * [[a, b, c], [a, c, d], [a, b, d], [b, c, d]].map(under).iter().sum::<f64>()
    };
    lists.facets.iter().map(patch).sum()
}

/// The program's own volume, which the gas law reads.
fn enclosed(lists: &smartbed::scene::Lists, pos: &[Vector]) -> f64 {
    let body = smartbed_runtime::flexible::Body {
        mass: &lists.masses,
        fixed: &lists.fixed,
        inverse_mass: &[],
        springs: &[],
        gravity: [0.0; 3],
        air_drag: 0.0,
        facets: &lists.facets,
        inflation: None,
        massless: smartbed_runtime::flexible::Massless::default(),
        grids: &[],
        patches: None,
    };
    enclosed_volume(body.facets, pos)
}

#[test]
fn a_cube_of_gas_keeps_its_energy() {
    let gas = ["pressure=2000", "gas=polytropic", "volume=1.0", "ambient=100000", "exponent=1.4"];
    // Constant pressure: mean gradients make the work exact; the gas law's mean pressure is of order h^4.
    for (settings, allowed) in [(&["pressure=500"][..], 1e-11), (&gas, 1e-6)] {
        let mut first = None;
        let mut worst = 0.0_f64;
        run::<f64>(&scene("cube", &[&["method=energy_momentum"], settings].concat()), |row| {
            let start = *first.get_or_insert(row.energy.total);
            worst = worst.max((row.energy.total - start).abs());
        })
        .expect("run");
        println!("{settings:?}: energy changes by {worst:.2e} J");
        assert!(worst <= allowed, "{settings:?}: {worst:e} J");
    }
}

/// The sheet of 27 x 27 with strong drag, which moves slowly to its equilibrium if there is one.
fn inflate(settings: &[&str]) -> Result<(f64, f64), String> {
    let creep = ["method=verlet", "step=5e-3", "T=10", "air_drag=50", "g=0", "every=100"];
    let mut last = (0.0, 0.0);
    run::<f64>(&scene("bladder", &[&creep[..], settings].concat()), |row| {
        let top = row.pos.iter().map(|x| x[2]).fold(0.0, f64::max);
        last = (top, row.energy.stored[0]);
    })?;
    Ok(last)
}

#[test]
fn inflation_has_a_limit_that_is_named() {
    let (top, kinetic) = inflate(&["pressure=6000"]).expect("an equilibrium at 6 kPa");
    println!("6 kPa: {top:.3} m high, kinetic energy {kinetic:.1e} J");
    assert!(kinetic <= 1e-5);
    let message = inflate(&["pressure=7000", "T=60"]).expect_err("no equilibrium at 7 kPa");
    println!("{message}");
    assert!(message.contains("7000.000000 Pa"), "{message}");
    // A given amount of gas loses its pressure as it grows: no runaway.
    let gas = ["pressure=9000", "gas=polytropic", "volume=0.2", "dead_volume=0.2", "exponent=1.0"];
    let (_, kinetic) = inflate(&gas).expect("an equilibrium");
    assert!(kinetic <= 1e-4);
}

#[test]
fn collapsed_and_inverted_cells_have_stated_outcomes() {
    // A cell pressed flat or turned inside out: the force turns with it and stays finite.
    let flat: [Vector; 4] = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0; 3]];
    let share = |form, corners| corner_shares::<f64>(form, corners).concat();
    for form in [PressureForm::Fan, PressureForm::Facet, PressureForm::Exact] {
        assert!(share(form, flat).iter().all(|c| *c == 0.0));
        let up = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        let down = [up[0], up[3], up[2], up[1]];
        assert!(share(form, up)[2] > 0.0 && share(form, down)[2] < 0.0);
    }
    // A body of gas with no volume left is refused by name.
    let settings = ["pressure=2000", "gas=polytropic", "volume=1.0"];
    let mut inside_out = scene("cube", &settings);
    inside_out.lists.points.iter_mut().for_each(|x| x[0] = -x[0]);
    let mut simulation =
        Simulation::<f64>::new(&inside_out.lists, &inside_out.around, inside_out.method).expect("body");
    let error = simulation.begin(1e-3, &mut ()).expect_err("no volume");
    assert!(matches!(error, smartbed_runtime::flexible::BodyError::Collapsed { volume } if volume < 0.0));
}
