//! The other contact laws against closed forms: Hunt-Crossley, Newton, friction on a slope, massless points in 3-D.

use smartbed::scene::parse;
use smartbed::scene::run::{EventRecord, Row, run};
use smartbed_runtime::contact::{ContactLaw, Ground, massless};
use smartbed_runtime::flexible::{Body, Massless, Spring};

const G: f64 = 9.81;

fn all(text: &str) -> (Vec<Row>, Vec<EventRecord>) {
    let scene = parse("law", &format!("format = 1\n{text}"), &[]).expect("scene");
    let mut rows = Vec::new();
    let events = run::<f64>(&scene, |row| rows.push(row.clone())).expect("run");
    (rows, events)
}

/// Root of a rising function.
fn bisect(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if f(middle) < 0.0 { low = middle } else { high = middle }
    }
    high
}

/// v dv = -(k/m) d^1.5 (1 + a v) dd on the way in and out, so G(v) = v/a - ln(1 + a v)/a^2 is 2/5 (k/m) d^2.5:
/// the depth follows from G(v0), the speed of leaving v1 from G(-v1) = G(v0).
#[test]
fn hunt_crossley_takes_what_its_closed_form_says() {
    const STIFFNESS: f64 = 1e5;
    for (v0, a) in [(1.0, 0.2), (0.3, 0.2), (1.0, 0.02), (2.0, 0.4)] {
        let text = format!(
            "points = [[0.0, 0.0, 0.001]]\ng = 0.0\ninitial_velocity = {:e}\nlaw = \"hunt_crossley\"\nstiffness = {STIFFNESS}\ndissipation = {a}\nmethod = \"rk4\"\nstep = 1e-5\nT = 0.1\n",
            -v0
        );
        let (rows, _) = all(&text);
        let potential = |v: f64| v / a - (a * v).ln_1p() / (a * a);
        let v1 = bisect(|v| potential(-v) - potential(v0), 0.0, v0);
        let depth = (2.5 / STIFFNESS * potential(v0)).powf(0.4);
        let end = rows.last().expect("rows");
        let deepest = rows.iter().map(|r| -r.pos[0][2]).fold(0.0, f64::max);
        println!(
            "Hunt-Crossley {v0} m/s, a {a}: e = {:.6} (closed form {:.6}), depth {deepest:.6e} ({depth:.6e})",
            end.vel[0][2] / v0,
            v1 / v0
        );
        // The force starts as depth^1.5: at its kink a method of order 4 is one of order 2.5, 1e-5^2.5.
        assert!((end.vel[0][2] - v1).abs() <= 1e-6 * v0);
        // Rows are 1e-5 s apart; around the deepest point depth changes by a h^2/2 of about 1e-7 of 1 cm.
        assert!((deepest / depth - 1.0).abs() <= 1e-5);
        let taken = 0.5 * (v0 * v0 - v1 * v1);
        assert!((end.energy.accounts[2] - taken).abs() <= 1e-5, "the ledger's impact account");
        assert!(end.energy.imbalance.abs() <= 1e-5);
    }
}

/// Drop from 1 m: speeds of approach e^n v, times 2 e^n v/g apart, impulses (1 + e) e^n v.
#[test]
fn newton_bounces_are_a_geometric_series() {
    const E: f64 = 0.8;
    let (rows, events) =
        all("points = [[0.0, 0.0, 1.0]]\nlaw = \"newton\"\ne = 0.8\nmethod = \"verlet\"\nT = 3.0\n");
    let speed = (2.0 * G).sqrt();
    let mut time = speed / G;
    for (n, event) in events.iter().enumerate() {
        let v = speed * E.powi(n as i32);
        let (_, approach, impulse) = event.touches[0];
        assert!((event.time - time).abs() <= 1e-12, "bounce {n}: {} against {time}", event.time);
        assert!((approach - v).abs() <= 1e-11 && (impulse - (1.0 + E) * v).abs() <= 1e-11);
        time += 2.0 * E * v / G;
    }
    assert!(events.len() >= 4);
    let left = G * E.powi(2 * events.len() as i32);
    let end = rows.last().expect("rows").energy;
    assert!((end.total - left).abs() <= 1e-11 && end.imbalance.abs() <= 1e-11);
}

/// A floor that rises at 30 degrees towards +x, a point on it with a speed along it.
fn slope(mu: f64, speed: f64, method: &str) -> (Vec<Row>, [f64; 2]) {
    let (sin, cos) = (30.0_f64.to_radians().sin(), 30.0_f64.to_radians().cos());
    let text = format!(
        "points = [[0.0, 0.0, 0.0]]\nmu = {mu}\nmethod = \"{method}\"\nT = 1.0\ninitial_velocity = [{:e}, 0.0, {:e}]\nfloor = {{ normal = [{:e}, 0.0, {cos:e}], offset = 0.0 }}\n",
        speed * cos,
        speed * sin,
        -sin
    );
    (all(&text).0, [sin, cos])
}

/// Way up the slope.
fn along(row: &Row, [sin, cos]: [f64; 2]) -> f64 {
    row.pos[0][0] * cos + row.pos[0][2] * sin
}

#[test]
fn sliding_down_a_slope_follows_its_parabola() {
    for method in ["verlet", "rk4", "energy_momentum"] {
        let (rows, unit) = slope(0.3, 0.0, method);
        let a = G * (unit[0] - 0.3 * unit[1]);
        for row in &rows {
            let error = along(row, unit) + 0.5 * a * row.t * row.t;
            assert!(error.abs() <= 1e-12, "{method} at {}: {error:e}", row.t);
            assert!(row.energy.imbalance.abs() <= 1e-11, "{method}: {:e}", row.energy.imbalance);
        }
        let taken = rows.last().expect("rows").energy.accounts[3];
        // mu m g cos times the way.
        assert!((taken - 0.3 * G * unit[1] * 0.5 * a).abs() <= 1e-11, "{method}: {taken}");
    }
}

/// On a slope with tan = mu gravity along it is as large as friction, so that the speed and its part downwards keep
/// their sum: thrown sideways with v a point ends straight down with v/2. Its slip turns within few steps or within
/// one.
#[test]
fn a_point_thrown_sideways_on_the_steepest_slope_ends_with_half_its_speed() {
    let (mu, step) = (0.5_f64, 1e-3);
    let cos = 1.0 / (1.0 + mu * mu).sqrt();
    let ended = |speed: f64, step: f64| {
        let (rows, _) = all(&format!(
            "points = [[0, 0, 0]]\nmass = [1.0]\ng = {G:e}\nlaw = \"newton\"\nmu = {mu}\nT = 1.0\nstep = {step:e}\n\
             initial_velocity = [0.0, {speed:e}, 0.0]\nfloor = {{ normal = [{:e}, 0.0, {cos:e}], offset = 0.0 }}\n",
            -mu * cos
        ));
        let end = rows.last().expect("rows");
        assert!(end.energy.imbalance.abs() <= 1e-12, "{:e}", end.energy.imbalance);
        end.vel[0].iter().map(|v| v * v).sum::<f64>().sqrt()
    };
    // Fast slip turns slowly: order 2.
    let errors = [step, step / 2.0].map(|step| (ended(1.0, step) - 0.5).abs());
    assert!(errors[0] <= 1e-4 && errors[1] <= errors[0] / 3.0, "{errors:?}");
    // Friction could stop slow slip within the step: it makes no speed, whatever the step.
    for speed in [1e-4, 1e-3, 4e-3] {
        for step in [1e-3, 1e-4] {
            let end = ended(speed, step);
            assert!(end <= 0.6 * speed, "{speed} in steps of {step}: {end:e}");
        }
    }
}

#[test]
fn sliding_up_a_slope_ends_where_friction_says() {
    for method in ["verlet", "rk4", "energy_momentum"] {
        // tan 30 = 0.577: with mu = 0.8 it stays at the top, v^2/(2 g (sin + mu cos)) up.
        let (rows, unit) = slope(0.8, 2.0, method);
        let deceleration = G * (unit[0] + 0.8 * unit[1]);
        let top = 4.0 / (2.0 * deceleration);
        let end = rows.last().expect("rows");
        // The stop falls inside a step, which ends there.
        assert!((along(end, unit) - top).abs() <= 1e-12, "{method}: {:e}", along(end, unit) - top);
        assert_eq!(end.vel[0], [0.0; 3], "{method}");
        let stopped = &rows[rows.len() / 2];
        assert_eq!(stopped.pos, end.pos, "{method}: no creep");
        assert!(end.energy.imbalance.abs() <= 1e-11, "{method}: {:e}", end.energy.imbalance);
    }
}

/// A block of 0.5 kg on a rough floor and a spring of 200 N/m, let go with the spring drawn by a: place (m) after t.
/// In each half period the spring force oscillates about mu m g against the motion, until it cannot overcome friction.
fn block(mu: f64, a: f64, t: f64) -> f64 {
    let (rate, dead) = ((200.0_f64 / 0.5).sqrt(), mu * 0.5 * G / 200.0);
    let (mut start, mut left) = (a, t);
    loop {
        if start.abs() <= dead {
            return start;
        }
        let middle = dead * start.signum();
        if left * rate < std::f64::consts::PI {
            return middle + (start - middle) * (left * rate).cos();
        }
        (start, left) = (2.0 * middle - start, left - std::f64::consts::PI / rate);
    }
}

/// The block's largest error on a ground into which it sinks to this depth at rest.
fn block_error(ground: &str, depth: f64, method: &str, step: f64) -> f64 {
    (0..5).fold(0.0_f64, |worst, n| {
        let a = 0.15 + 0.0117 * f64::from(n);
        let z = -depth;
        let text = format!(
            "format = 1\npoints = [[0, 0, {z:e}], [{:e}, 0, {z:e}]]\nsprings = [[0, 1]]\nrest_lengths = [1]\nfixed = [0]\n\
             K = 200\nmass = 0.5\nmu = 0.3\ng = {G:e}\nT = 2.2\nstep = {step:e}\nmethod = \"{method}\"\n{ground}\n",
            1.0 + a
        );
        let scene = parse("block", &text, &[]).expect("a scene");
        let mut far = worst;
        let mut last = f64::NAN;
        run::<f64>(&scene, |row| {
            far = far.max((row.pos[1][0] - 1.0 - block(0.3, a, row.t)).abs());
            last = row.vel[1][0];
        })
        .expect("a run");
        assert_eq!(last, 0.0, "{ground} {method}: it sticks in the end");
        far
    })
}

#[test]
fn a_block_on_a_spring_turns_and_sticks_to_order_two() {
    let weight = 0.5 * G;
    let grounds = [
        ("", 0.0),
        ("law = \"penalty\"\nstiffness = 2e4", weight / 2e4),
        ("law = \"hunt_crossley\"\nstiffness = 2e6\ndissipation = 0", (weight / 2e6).powf(2.0 / 3.0)),
    ];
    for (ground, depth) in grounds {
        for method in [
            "verlet",
            "damped_verlet",
            "nystrom4",
            "blanes_moan4",
            "rk4",
            "implicit_midpoint",
            "energy_momentum",
        ] {
            let errors = [2e-3, 1e-3, 5e-4].map(|step| block_error(ground, depth, method, step));
            let order = 0.5 * (errors[0] / errors[2]).log2();
            println!("{ground} {method}: {errors:?}, order {order:.2}");
            assert!(order >= 1.9 && errors[1] <= 1e-4, "{ground} {method}: {errors:?}, order {order}");
        }
    }
}

/// A point of 1 kg thrown from 5 cm at a springy floor of 1e4 N/m: height (m) and its rate after t, flights and half
/// swings about the depth of balance in turn.
fn bouncing(t: f64) -> (f64, f64) {
    const DROP: f64 = 0.05;
    let (rate, sunk, speed) = (1e4_f64.sqrt(), G / 1e4, (2.0 * G * DROP).sqrt());
    // In contact z = -sunk + sunk cos(rate t) - (speed/rate) sin(rate t), 0 again where it rises with `speed`.
    let contact = 2.0 * (std::f64::consts::PI - (speed / rate).atan2(sunk)) / rate;
    let (flight, fall) = (2.0 * speed / G, speed / G);
    if t < fall {
        return (DROP - 0.5 * G * t * t, -G * t);
    }
    let since = (t - fall) % (contact + flight);
    if since < contact {
        let (sin, cos) = (rate * since).sin_cos();
        return (sunk * (cos - 1.0) - speed / rate * sin, -sunk * rate * sin - speed * cos);
    }
    let s = since - contact;
    (speed * s - 0.5 * G * s * s, speed - G * s)
}

/// The point slips while it bounces. Friction takes mu times the normal impulse m (v_z - v_z0 + g t) from its slip: the
/// displacement follows from height and its rate alone, until the slip ends.
#[test]
fn a_point_that_bounces_on_a_springy_floor_slips_by_its_normal_impulses() {
    const MU: f64 = 0.3;
    const SLIP: f64 = 1.2;
    let slip = |t: f64| SLIP - MU * (bouncing(t).1 + G * t);
    // The slip only decreases, because the normal force does not pull.
    let end = bisect(|t| -slip(t), 0.0, 1.0);
    let way = |t: f64| SLIP * t - MU * (bouncing(t).0 - bouncing(0.0).0 + 0.5 * G * t * t);
    for method in
        ["verlet", "damped_verlet", "nystrom4", "blanes_moan4", "rk4", "implicit_midpoint", "energy_momentum"]
    {
        let error = |step: f64| {
            let text = format!(
                "points = [[0, 0, 0.05]]\ninitial_velocity = [{SLIP}, 0, 0]\nmu = {MU}\nmass = 1\ng = {G:e}\nT = 0.6\n\
                 law = \"penalty\"\nstiffness = 1e4\nstep = {step:e}\nmethod = \"{method}\"\n"
            );
            let (rows, _) = all(&text);
            rows.iter().map(|row| (row.pos[0][0] - way(row.t.min(end))).abs()).fold(0.0, f64::max)
        };
        let errors = [1.0, 0.5, 0.25].map(|part| {
            // Kinks lie at random places within steps: take the worst of several similar step sizes.
            (0..5).map(|n| error(part * (1e-3 + 3.7e-5 * f64::from(n)))).fold(0.0, f64::max)
        });
        let order = 0.5 * (errors[0] / errors[2]).log2();
        println!("{method}: stops at {end:.4} s, {errors:?}, order {order:.2}");
        assert!(order >= 1.75 && errors[1] <= 1e-4, "{method}: {errors:?}, order {order}");
    }
}

/// The scene that `new scene` writes: a damped cube falls on a rough floor, tumbles and slides. Its loss of energy is
/// the sum of the accounts of dampers, impacts and friction.
#[test]
fn a_damped_cube_on_a_rough_floor_keeps_its_account_to_order_two() {
    let open = |ground: &str, step: f64| {
        let text = format!(
            "format = 1\nshape = \"cube\"\nside = 0.5\ndrop_height = 0.8\ntilt = 0.3\nK = 2000\nC = 2\nmass = 0.5\n\
             mu = 0.3\nT = 2\nstep = {step:e}\n{ground}\n"
        );
        let (mut worst, mut start) = (0.0_f64, f64::NAN);
        run::<f64>(&parse("cube", &text, &[]).expect("a scene"), |row| {
            start = if row.t == 0.0 { row.energy.total } else { start };
            worst = worst.max(row.energy.imbalance.abs());
        })
        .expect("a run");
        worst / start
    };
    // A springy floor has kinks of its own, at each touch and release.
    for (ground, bound) in [("", 1e-4), ("law = \"penalty\"\nstiffness = 2e4", 5e-4)] {
        let [coarse, middle, fine] = [1e-3, 5e-4, 2.5e-4].map(|step| open(ground, step));
        println!("{ground} {coarse:.1e} {middle:.1e} {fine:.1e}");
        assert!(middle <= bound, "{ground}: {middle:e} of the energy in no account");
        assert!(coarse / fine >= 10.0, "{ground}: {coarse:e} {fine:e}");
    }
}

/// Forces of the springs on point 0, computed independently.
fn pull(pos: &[[f64; 3]], springs: &[Spring<f64>]) -> [f64; 3] {
    let mut force = [0.0; 3];
    for s in springs.iter().filter(|s| s.tail == 0 || s.head == 0) {
        let other = s.tail + s.head;
        let d = [0, 1, 2].map(|c| pos[other][c] - pos[0][c]);
        let length = d.iter().map(|c| c * c).sum::<f64>().sqrt();
        (0..3).for_each(|c| force[c] += s.stiffness * (length - s.rest_length) * d[c] / length);
    }
    force
}

/// A massless corner under three springs in space, above and on grounds of any orientation: free, its springs
/// balance; on the ground they balance along it and press on it.
#[test]
fn massless_point_in_space_is_in_balance() {
    let springs: Vec<Spring<f64>> = [(1, 0, 900.0, 1.0), (0, 2, 1400.0, 1.1), (3, 0, 700.0, 0.9)]
        .map(|(tail, head, stiffness, rest_length)| Spring {
            tail,
            head,
            stiffness,
            damping: 0.0,
            rest_length,
        })
        .to_vec();
    let body = Body::new(Body {
        mass: &[0.0, 1.0, 1.0, 1.0],
        fixed: &[false; 4],
        inverse_mass: &[],
        springs: &springs,
        gravity: [0.0, 0.0, -G],
        air_drag: 0.0,
        facets: &[],
        inflation: None,
        massless: Massless { points: &[0], first: &[0, 3], springs: &[0, 1, 2] },
        grids: &[],
        patches: None,
    })
    .expect("body");
    let (mut pressed, mut hung) = (0, 0);
    for tilt in [[0.0, 0.0, 1.0], [0.2, 0.0, 1.0], [-0.1, 0.3, 1.0]] {
        let length = tilt.iter().map(|c| c * c).sum::<f64>().sqrt();
        let normal: [f64; 3] = tilt.map(|c| c / length);
        for height in [-0.3, -0.1, 0.0, 0.1, 0.3] {
            let ground = Ground {
                normal,
                offset: height,
                law: ContactLaw::MasslessPoint,
                friction: 0.0,
                tolerance: 1e-11,
            };
            let mut pos = [[0.05, -0.02, 0.0], [0.6, 0.0, 0.7], [-0.4, 0.5, 0.8], [-0.3, -0.6, 0.75]];
            massless::settle(&body, &ground, &mut pos, &mut [[0.0; 3]; 4]);
            let force = pull(&pos, &springs);
            let dot = |a: [f64; 3]| a.iter().zip(normal).map(|(x, n)| x * n).sum::<f64>();
            let (gap, press) = (dot(pos[0]) - height, -dot(force));
            let tangential = [0, 1, 2].map(|c| force[c] + press * normal[c]);
            let size = |a: [f64; 3]| a.iter().map(|c| c.abs()).fold(0.0, f64::max);
            // Rounding of lengths of 1 m under 1 kN/m.
            assert!(size(tangential) <= 1e-9, "{normal:?} {height}: {tangential:?}");
            if gap.abs() <= 1e-12 {
                assert!(press >= -1e-9, "the ground pulls by {press}");
                pressed += 1;
            } else {
                assert!(gap > 0.0 && press.abs() <= 1e-9, "gap {gap}, {press}");
                hung += 1;
            }
        }
    }
    assert!(pressed >= 3 && hung >= 3, "{pressed} pressed, {hung} free");
}

/// A massless foot under a strut and between two springs, moved to and fro over a rough floor by masses so heavy that
/// its forces do not affect them: it lags behind by the distance s at which T(s) = mu N(s), the play operator.
#[test]
fn a_massless_foot_follows_by_the_operator_of_play() {
    const MU: f64 = 0.4;
    const HEIGHT: f64 = 0.9;
    const STRUT: f64 = 500.0;
    const SIDE: f64 = 2000.0;
    const SWING: f64 = 0.05;
    const RATE: f64 = 10.0;
    let pull = |s: f64| {
        let length = HEIGHT.hypot(s);
        let push = STRUT * (1.0 - length);
        (2.0 * SIDE * s - push * s / length, push * HEIGHT / length)
    };
    let lag = bisect(|s| pull(s).0 - MU * pull(s).1, 0.0, 0.1);
    let (mut points, heavy) = (vec![format!("[{SWING}, 0, 0]")], 1e9 * RATE * RATE);
    for (x, z) in [(0.0, HEIGHT), (-0.5, 0.0), (0.5, 0.0)] {
        points.extend([format!("[{}, 0, {z}]", x + SWING), format!("[{}, 0, {z}]", x - 100.0)]);
    }
    let run = |method: &str, step: f64| {
        let (rows, _) = all(&format!(
            "points = [{}]\nsprings = [[0, 1], [2, 1], [0, 3], [4, 3], [0, 5], [6, 5]]\nfixed = [2, 4, 6]\ng = 0\nmu = {MU}\n\
             rest_lengths = [1, 100, 0.5, 100, 0.5, 100]\nK = [{STRUT}, {heavy}, {SIDE}, {heavy}, {SIDE}, {heavy}]\n\
             mass = [1, 1e9, 1, 1e9, 1, 1e9, 1]\nlaw = \"massless_point\"\nmassless = [0]\nmethod = \"{method}\"\n\
             step = {step:e}\nT = 1.5\n",
            points.join(", ")
        ));
        let (mut foot, mut way, mut worst) = (SWING, 0.0, 0.0_f64);
        for pair in rows.windows(2) {
            for part in 1..=100 {
                let t = pair[0].t + (pair[1].t - pair[0].t) * f64::from(part) / 100.0;
                let carried = SWING * (RATE * t).cos();
                let next = foot.clamp(carried - lag, carried + lag);
                (way, foot) = (way + (next - foot).abs(), next);
            }
            worst = worst.max((pair[1].pos[0][0] - foot).abs());
        }
        let taken = rows.last().expect("rows").energy.accounts[3];
        (worst, (taken / (MU * pull(lag).1 * way) - 1.0).abs())
    };
    for method in ["verlet", "rk4", "blanes_moan4", "implicit_midpoint"] {
        let [coarse, fine] = [2e-3, 5e-4].map(|step| run(method, step));
        println!(
            "{method}: lag {lag:.4} m, errors {:.1e} {:.1e}, friction {:.1e} {:.1e}",
            coarse.0, fine.0, coarse.1, fine.1
        );
        assert!(fine.0 <= 2e-6 && coarse.0 >= 10.0 * fine.0, "{method}: {coarse:?} {fine:?}");
        assert!(fine.1 <= 1e-5 && coarse.1 >= 10.0 * fine.1, "{method}: {coarse:?} {fine:?}");
    }
}
