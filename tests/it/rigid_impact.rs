//! Impact of rigid bodies with friction: works and impulses, closed forms, planar slip reversal, change of slip
//! direction.

use smartbed_runtime::rigid::attitude::Attitude;
use smartbed_runtime::rigid::impact::{Impact, Stage, Touch, resolve, trace};
use smartbed_runtime::rigid::{RigidBody, RigidState, Struck, strike};
use smartbed_tests::random::Random;

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

const UP: [f64; 3] = [0.0, 0.0, 1.0];
const BOX: RigidBody<f64> = RigidBody { mass: 2.0, inertia: [0.3, 0.5, 0.7] };

fn falling() -> RigidState<f64> {
    let attitude = Attitude::identity();
    let angular_momentum = [0.3, -1.0, 0.35];
    RigidState { position: [0.0; 3], velocity: [0.4, -0.2, -3.0], attitude, angular_momentum }
}

/// Sums of a few terms of 10 J.
const ROUNDING: f64 = 1e-13;

fn strike_ground(state: &mut RigidState<f64>, point: [f64; 3], friction: f64, e: f64) -> Impact<f64> {
    strike(Struck { body: &BOX, state, point }, None, UP, friction, e)
}

#[test]
fn net_work_is_the_change_of_kinetic_energy_and_stronges_share_of_the_compression() {
    let r = [0.3, -0.2, -0.4];
    for e in [0.0, 0.3, 0.8, 1.0] {
        for mu in [0.0, 0.2, 1.5] {
            let mut state = falling();
            let (before, approach) = (BOX.kinetic(&state), BOX.point_velocity(&state, r)[2]);
            let impact = strike_ground(&mut state, r, mu, e);
            // Eq. 4.2; Eq. 4.4.
            let net = BOX.kinetic(&state) - before;
            assert!((net - impact.normal_work - impact.friction_work).abs() <= ROUNDING);
            assert!((impact.normal_work - (1.0 - e * e) * impact.compression_work).abs() <= ROUNDING);
            assert!(impact.friction_work <= ROUNDING && impact.compression_work < 0.0);
            if mu == 0.0 {
                // Without friction the energetic coefficient is the kinematic one, and W_c = M v_0^2/2.
                assert!((BOX.point_velocity(&state, r)[2] + e * approach).abs() <= ROUNDING);
                assert!((impact.impulse[0] - (1.0 + e) * impact.compression).abs() <= ROUNDING);
                let mass = -impact.compression / approach;
                assert!((impact.compression_work + 0.5 * mass * approach.powi(2)).abs() <= ROUNDING);
            }
        }
    }
}

/// The normal of a central impact is a unit vector up to rounding: then K_tn and v_t are the same small multiples of
/// K_nn and v_n, and slip ends where compression does.
#[test]
fn a_central_impact_with_a_rounded_normal_keeps_its_restitution() {
    let mut random = Random::new(5);
    for case in 0..20_000 {
        let [speed, k, e, mu] = [0.1, 0.1, 0.0, 0.0].map(|least| random.between(least, 1.0));
        let friction = if case % 2 == 0 { 0.0 } else { mu };
        let [x, y] = std::array::from_fn(|_| f64::EPSILON * random.between(-4.0, 4.0).round());
        let touch = Touch {
            inverse_mass: [[k, k * x, k * y], [k * x, k, 0.0], [k * y, 0.0, k]],
            velocity: [-speed, -speed * x, -speed * y],
            friction,
            restitution: e,
        };
        let p = resolve(&touch).impulse[0];
        assert!((p * k / speed - (1.0 + e)).abs() <= 1e-12, "case {case}: {} of {e}", p * k / speed - 1.0);
    }
}

#[test]
fn work_is_the_integral_of_speed_over_impulse_and_the_impulse_grows() {
    let touch = Touch {
        inverse_mass: [[1.0, 0.2, -0.1], [0.2, 2.0, 0.3], [-0.1, 0.3, 1.5]],
        velocity: [-2.0, 1.0, -0.5],
        friction: 0.4,
        restitution: 0.6,
    };
    let mut curve = Vec::new();
    let impact = trace(&touch, |point| curve.push(point));
    assert!(curve.len() > 3 && curve[0].stage == Stage::Collision && curve[0].impulse == 0.0);
    assert!(curve.windows(2).all(|pair| pair[0].impulse <= pair[1].impulse), "never backwards (Fig. 4.2)");
    // Simpson's rule on the middle of each piece would need v there; v_n is smooth, so the chord's error is the cube
    // of a piece: the sum over pieces shows the integral to their square.
    let chords: f64 = (curve.windows(2))
        .map(|p| 0.5 * (p[0].velocity[0] + p[1].velocity[0]) * (p[1].impulse - p[0].impulse))
        .sum();
    assert!((chords - impact.normal_work).abs() <= 1e-2 * impact.compression_work.abs());
    let least = curve.iter().map(|p| p.work).fold(0.0, f64::min);
    assert_eq!(least, impact.compression_work, "compression ends where the work is least");
}

#[test]
fn a_point_that_leaves_and_a_ball_without_arm() {
    let mut leaving = falling();
    (leaving.velocity, leaving.angular_momentum) = ([0.0, 0.0, 3.0], [0.0; 3]);
    let before = leaving;
    assert_eq!(strike_ground(&mut leaving, [0.0, 0.0, -1.0], 0.5, 1.0).impulse, [0.0; 3]);
    assert_eq!(leaving, before);
    // A ball with backspin rolls after the impact if mu is large: v_x + w r = 0, with J = 2/5 m r^2 (Stronge 2000,
    // 4.2).
    let ball = RigidBody { mass: 0.5, inertia: [0.4 * 0.5 * 0.01; 3] };
    let mut state =
        RigidState { velocity: [1.0, 0.0, -2.0], angular_momentum: [0.0, -0.02, 0.0], ..falling() };
    let spin = -0.02 / ball.inertia[1];
    strike(Struck { body: &ball, state: &mut state, point: [0.0, 0.0, -0.1] }, None, UP, 10.0, 0.5);
    // Angular momentum about the point of contact stays: v' = (5 v + 2 w r)/7.
    let rolls = (5.0 * 1.0 + 2.0 * spin * 0.1) / 7.0;
    assert!((state.velocity[0] - rolls).abs() <= ROUNDING);
    assert!((ball.angular_velocity(&state)[1] * 0.1 - rolls).abs() <= ROUNDING);
    assert!((state.velocity[2] - 1.0).abs() <= ROUNDING);
}

/// Planar impact with friction by cases (Wang and Mason 1992, in Stronge's energetic form): impulses (n, t).
///
/// K = [[a, b], [b, c]]; the line of sticking v_t = 0 and that of greatest compression v_n = 0 divide the plane of
/// impulses; each case is written out for s_0 >= 0.
fn planar([a, b, c]: [f64; 3], vn: f64, vt: f64, mu: f64, e: f64) -> [f64; 2] {
    let flip = if vt < 0.0 { -1.0 } else { 1.0 };
    let (b, vt) = (b * flip, vt * flip);
    // Slip forwards: dP_t = -mu dp.
    let (nf, tf) = (a - mu * b, b - mu * c);
    let slip_ends = if tf < 0.0 { vt / -tf } else { f64::INFINITY };
    // After slip: stick if |b/c| <= mu, else slip on (b > 0) or back (b < 0).
    let after = if b.abs() <= mu * c { -b / c } else { -mu * b.signum() };
    let na = a + after * b;
    let parabola = |v: f64, k: f64, p: f64| v * p + 0.5 * k * p * p;
    // Where compression ends, and its work.
    let (pc, wc) = if nf > 0.0 && -vn / nf <= slip_ends {
        let p = -vn / nf;
        (p, parabola(vn, nf, p))
    } else {
        let v = vn + nf * slip_ends;
        (slip_ends - v / na, parabola(vn, nf, slip_ends) + parabola(v, na, -v / na))
    };
    let gain = -e * e * wc;
    // Restitution: from v_n = 0 at pc to the work (1 - e^2) W_c.
    let p_end = if pc < slip_ends {
        let whole = (2.0 * gain / nf).sqrt();
        if pc + whole <= slip_ends {
            pc + whole
        } else {
            let part = slip_ends - pc;
            let (v, left) = (nf * part, gain - parabola(0.0, nf, part));
            slip_ends + (-v + (v * v + 2.0 * na * left).sqrt()) / na
        }
    } else {
        pc + (2.0 * gain / na).sqrt()
    };
    let forward = p_end.min(slip_ends);
    [p_end, flip * (-mu * forward + after * (p_end - forward))]
}

#[test]
fn a_rod_with_friction_meets_the_planar_solution_through_stick_and_reversal() {
    let mut random = Random::new(7);
    let mut between = |low, high| random.between(low, high);
    let (mut stuck, mut reversed) = (0, 0);
    for _ in 0..20_000 {
        // A slender rod of mass m and length l at an angle to the ground, struck at its end.
        let (m, l, angle) = (between(0.1, 5.0), between(0.2, 2.0), between(0.05, 1.5));
        let (x, y) = (-0.5 * l * f64::cos(angle), -0.5 * l * f64::sin(angle));
        let j = m * l * l / 12.0;
        let k = [1.0 / m + x * x / j, -x * y / j, 1.0 / m + y * y / j];
        let (vn, vt, mu, e) = (-between(0.1, 3.0), between(-3.0, 3.0), between(0.0, 1.5), between(0.0, 1.0));
        let [pn, pt] = planar(k, vn, vt, mu, e);
        let touch = Touch {
            inverse_mass: [[k[0], k[1], 0.0], [k[1], k[2], 0.0], [0.0, 0.0, 1.0 / m]],
            velocity: [vn, vt, 0.0],
            friction: mu,
            restitution: e,
        };
        let impact = resolve(&touch);
        let off = (impact.impulse[0] - pn).abs().max((impact.impulse[1] - pt).abs());
        assert!(off <= 1e-12 * pn, "{off} of {pn} for {touch:?}");
        assert_eq!(impact.impulse[2], 0.0);
        let end = vt + k[1] * pn + k[2] * pt;
        stuck += usize::from(end.abs() <= 1e-12);
        reversed += usize::from(end * vt < -1e-12);
    }
    assert!(stuck > 1000 && reversed > 1000, "{stuck} stuck, {reversed} reversed");
}

/// The same impact by Runge and Kutta's method over the impulse, in small steps: (P, W_n) at the end.
fn by_small_steps(touch: &Touch<f64>, dp: f64) -> [f64; 3] {
    let k = &touch.inverse_mass;
    let velocity = |p: [f64; 3]| -> [f64; 3] { std::array::from_fn(|i| touch.velocity[i] + dot(k[i], p)) };
    let rate = |p: [f64; 3]| {
        let [_, x, y] = velocity(p);
        let s = x.hypot(y);
        [1.0, -touch.friction * x / s, -touch.friction * y / s]
    };
    let along = |p: [f64; 3], h: f64, r: [f64; 3]| -> [f64; 3] { std::array::from_fn(|i| p[i] + h * r[i]) };
    let (mut p, mut work, mut least) = ([0.0; 3], 0.0, 0.0);
    loop {
        let a = rate(p);
        let b = rate(along(p, 0.5 * dp, a));
        let c = rate(along(p, 0.5 * dp, b));
        let d = rate(along(p, dp, c));
        let mean: [f64; 3] = std::array::from_fn(|i| (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]) / 6.0);
        let next = along(p, dp, mean);
        let middle = along(p, 0.5 * dp, mean);
        let speeds = [p, middle, next].map(|p| velocity(p)[0]);
        let step_work = dp * (speeds[0] + 4.0 * speeds[1] + speeds[2]) / 6.0;
        if speeds[2] >= 0.0 && least == 0.0 {
            // v_n is straight over so short a step.
            let part = dp * speeds[0] / (speeds[0] - speeds[2]);
            least = work + 0.5 * speeds[0] * part;
        }
        let target = (1.0 - touch.restitution.powi(2)) * least;
        if least < 0.0 && work + step_work >= target {
            return along(p, dp * (target - work) / step_work, mean);
        }
        (p, work) = (next, work + step_work);
    }
}

#[test]
fn slip_swerves_as_small_steps_say() {
    let mut random = Random::new(11);
    let mut between = |low, high| random.between(low, high);
    for _ in 0..20 {
        // Friction too weak to end the slip, so that the small steps stay smooth.
        let inverse_mass = [[1.0, 0.3, -0.2], [0.3, between(1.5, 3.0), 0.4], [-0.2, 0.4, between(1.0, 4.0)]];
        let velocity = [-1.0, between(2.0, 3.0), between(1.0, 3.0)];
        let touch = Touch { inverse_mass, velocity, friction: 0.3, restitution: between(0.2, 1.0) };
        let (exact, stepped) = (resolve(&touch).impulse, by_small_steps(&touch, 1e-5));
        for i in 0..3 {
            assert!((exact[i] - stepped[i]).abs() <= 2e-9, "{exact:?} {stepped:?}");
        }
    }
}

/// Random impacts of two bodies of any shape; `SMARTBED_IMPACTS` for another number of them.
#[test]
fn no_impact_creates_energy_leaves_the_cone_or_changes_the_momentum() {
    let wanted = std::env::var("SMARTBED_IMPACTS").ok().and_then(|n| n.parse().ok());
    let mut random = Random::new(2024);
    for _ in 0..wanted.unwrap_or(100_000) {
        let mut vector = |scale: f64| -> [f64; 3] { std::array::from_fn(|_| random.between(-scale, scale)) };
        let [m1, m2, mu] = vector(1.0).map(|x| 10_f64.powf(2.0 * x));
        let moments = |mass: f64, [x, y, z]: [f64; 3]| {
            // Those of a box of these edges: the triangle rule holds.
            [y * y + z * z + 1e-3, x * x + z * z + 1e-3, x * x + y * y + 1e-3].map(|s| mass * s / 12.0)
        };
        let one = RigidBody { mass: m1, inertia: moments(m1, vector(2.0)) };
        let two = RigidBody { mass: m2, inertia: moments(m2, vector(2.0)) };
        let mut state = |body: &RigidBody<f64>| {
            let [a, b, c] = vector(1.0);
            let momentum = vector(1.0);
            let angular_momentum = std::array::from_fn(|i| momentum[i] * body.inertia[i]);
            let attitude = Attitude::new([a, b, c, 1.1 - a]);
            RigidState { position: vector(1.0), velocity: vector(3.0), attitude, angular_momentum }
        };
        let (mut a, mut b) = (state(&one), state(&two));
        let point = vector(1.0);
        let n = vector(1.0);
        let normal = n.map(|x| x / dot(n, n).sqrt());
        let friction = if mu > 50.0 { 0.0 } else { mu };
        let restitution = vector(1.0)[0].abs().mul_add(1.1, -0.05).clamp(0.0, 1.0);
        let kinetic = |a: &_, b: &_| one.kinetic(a) + two.kinetic(b);
        let (energy, momentum) = (kinetic(&a, &b), momenta(&one, &a, &two, &b));
        let struck = |body, state| Struck { body, state, point };
        let impact = strike(struck(&one, &mut a), Some(struck(&two, &mut b)), normal, friction, restitution);
        let after = kinetic(&a, &b);
        assert!(after <= energy * (1.0 + 1e-12), "{energy} {after} {impact:?}");
        let [pn, px, py] = impact.impulse;
        assert!(pn >= 0.0 && px.hypot(py) <= friction * pn * (1.0 + 1e-12), "{impact:?}");
        let share = (1.0 - restitution * restitution) * impact.compression_work;
        assert!((impact.normal_work - share).abs() <= 1e-12 * energy, "{impact:?}");
        let size = pn * 10.0 + momentum.iter().map(|x| x.abs()).sum::<f64>();
        for (x, y) in momentum.iter().zip(momenta(&one, &a, &two, &b)) {
            assert!((x - y).abs() <= 1e-12 * size);
        }
        let at = |body: &RigidBody<f64>, state: &RigidState<f64>| {
            let r: [f64; 3] = std::array::from_fn(|i| point[i] - state.position[i]);
            dot(body.point_velocity(state, r), normal)
        };
        if pn > 0.0 {
            assert!(at(&one, &a) - at(&two, &b) >= -1e-9, "they part");
        }
    }
}

/// Linear momentum, and angular momentum about the origin, of two bodies.
fn momenta(one: &RigidBody<f64>, a: &RigidState<f64>, two: &RigidBody<f64>, b: &RigidState<f64>) -> [f64; 6] {
    let mut total = [0.0; 6];
    for (body, s) in [(one, a), (two, b)] {
        let p = s.velocity.map(|v| body.mass * v);
        let [x, y, z] = s.position;
        let moment = [y * p[2] - z * p[1], z * p[0] - x * p[2], x * p[1] - y * p[0]];
        for i in 0..3 {
            total[i] += p[i];
            total[3 + i] += moment[i] + s.angular_momentum[i];
        }
    }
    total
}
