//! Trees in space, solved joint by joint: operations a link, and the accelerations against the equations before the
//! elimination.

use crate::augmented::{agree, with_augmented};
use crate::models::derived_from;
use crate::twofold::Twofold;
use smartbed_codegen::{Interpreted, Program, Settings, model};
use smartbed_runtime::mechanism::Mechanism;
use std::fmt::Write;
use std::time::{Duration, Instant};

/// A model's head.
fn head(name: &str, dof: usize) -> String {
    format!(
        "format = 1\nname = \"{name}\"\ndof = {dof}\ngravity = \"-g*N.z\"\n[parameters]\n\
         g = {{ value = 9.81, unit = \"m/s^2\" }}\nl = {{ value = 0.3, unit = \"m\" }}\nm = {{ value = 0.5, unit = \"kg\" }}\n\
         k = {{ value = 200, unit = \"N/m\" }}\nc = {{ value = 2, unit = \"N s/m\" }}\n"
    )
}

/// Point masses at the ends of rods on hinges about x, y and z in turn.
fn chain(n: usize) -> String {
    let mut text = head("chain", n);
    for i in 0..n {
        let (point, frame) = match i {
            0 => ("O".to_owned(), "N".to_owned()),
            _ => (format!("p{}", i - 1), format!("f{}", i - 1)),
        };
        let (hinge, rod) = (["x", "y", "z"][i % 3], ["z", "x", "y"][i % 3]);
        write!(
            text,
            "[coordinates.q{i}]\nunit = \"rad\"\n[frames.f{i}]\nparent = \"{frame}\"\nrotations = [[\"{hinge}\", \"q{i}\"]]\n\
             [points.p{i}]\nposition = \"{point} + l*f{i}.{rod}\"\n[bodies.b{i}]\ncentre = \"p{i}\"\nmass = \"m\"\n"
        )
        .expect("a string grows");
    }
    text
}

/// The accelerations against the equations before the elimination, solved numerically, at several states; `most` is
/// less than the operations of the other forms.
fn check(text: &str, most: usize) {
    check_at(text, most, |_| ());
}

/// The same at coordinates that are brought onto the constraints.
fn check_at(text: &str, most: usize, constrain: impl Fn(&mut [f64])) {
    let model = model::parse("tree.toml", text).unwrap_or_else(|e| panic!("{e}"));
    let program = with_augmented(&model, Settings::default());
    println!("{}: {} operations", program.name, program.operations());
    assert!(program.operations() <= most, "another form was taken: {} operations", program.operations());
    for round in 0..5 {
        let number = |i: usize| (1.7 * (i + 1) as f64 + 2.3 * f64::from(round)).sin();
        let mut q: Vec<f64> = (0..program.q.len()).map(|i| 2.0 * number(i)).collect();
        constrain(&mut q);
        let u: Vec<f64> = (0..program.u.len()).map(|i| 3.0 * number(i + 40)).collect();
        let inputs: Vec<f64> = (0..program.inputs.len()).map(|i| 5.0 * number(i + 80)).collect();
        agree(&program, &q, &u, &inputs);
        let error = rounding(&program, &q, &u, &inputs);
        println!("{}: rounding {error:.1e}", program.name);
        assert!(error < 1e-13, "{}: {error:e}", program.name);
    }
}

/// The rounding errors of the accelerations, relative to the largest of them: against twice the digits.
fn rounding(program: &Program, q: &[f64], u: &[f64], inputs: &[f64]) -> f64 {
    let wide = |list: &[f64]| list.iter().map(|&x| Twofold::new(x)).collect::<Vec<_>>();
    let (mut q_dot, mut u_dot) = (vec![0.0; q.len()], vec![0.0; u.len()]);
    Interpreted::new(program).rates(0.0, q, u, inputs, &mut q_dot, &mut u_dot).expect("lengths fit");
    let (mut wide_q_dot, mut exact) = (wide(&q_dot), wide(&u_dot));
    let [q, u, inputs] = [q, u, inputs].map(wide);
    let mut engine = Interpreted::<Twofold>::new(program);
    engine.rates(Twofold::new(0.0), &q, &u, &inputs, &mut wide_q_dot, &mut exact).expect("lengths fit");
    let size = exact.iter().fold(0.0_f64, |m, x| m.max(x.high.abs()));
    u_dot.iter().zip(&exact).fold(0.0, |worst: f64, (a, b)| worst.max((a - b.high).abs() / size))
}

/// The best published count of articulated bodies is 429 a link.
#[test]
fn operations_of_a_spatial_chain_grow_linearly() {
    let operations = [20, 40, 80].map(|n| derived_from(&chain(n)).operations());
    println!("20, 40, 80 links in space: {operations:?} operations");
    assert!(operations[0] <= 5_500 && operations[1] <= 12_000, "{operations:?}");
    assert!(10 * operations[2] <= 21 * operations[1], "{operations:?}");
}

#[test]
fn forty_links_in_space_are_derived_within_a_second() {
    let text = chain(40);
    let least = (0..5).map(|_| {
        let begin = Instant::now();
        let program = derived_from(&text);
        assert!(program.operations() > 0);
        begin.elapsed()
    });
    let least = least.min().expect("some");
    println!("forty links in space: derived in {least:?}");
    assert!(least < Duration::from_secs(1), "{least:?}");
}

#[test]
fn a_chain_of_point_masses() {
    check(&chain(20), 4_000); // 7,712 by the mass matrix
}

/// A frame on a hinge at `place` turned by `angle` about `axis`, and a body without any symmetry in it.
fn link(text: &mut String, i: usize, (place, parent): (&str, &str), axis: &str) {
    write!(
        text,
        "[coordinates.q{i}]\nunit = \"rad\"\n[frames.f{i}]\nparent = \"{parent}\"\nrotations = [[\"{axis}\", \"q{i}\"]]\n\
         [points.J{i}]\nposition = \"{place} + 0.2_m*{parent}.x + 0.1_m*{parent}.z\"\n\
         [points.C{i}]\nposition = \"J{i} + 0.1_m*f{i}.x - 0.07_m*f{i}.y + 0.2_m*f{i}.z\"\n\
         [bodies.b{i}]\ncentre = \"C{i}\"\nframe = \"f{i}\"\nmass = \"1.5_kg\"\n\
         inertia = {{ Ixx = 0.03, Iyy = 0.04, Izz = 0.05, Ixy = 0.004, Ixz = -0.003, Iyz = 0.002 }}\n"
    )
    .expect("a string grows");
}

/// Two arms on one trunk; a mast slides out of one of them askew and carries a wheel and two hinges; drives, a rope
/// with a damper between the arms, a force at a tip.
fn tree() -> String {
    let mut text = head("tree", 25);
    for i in 0..3 {
        let place = if i == 0 {
            ("O".to_owned(), "N".to_owned())
        } else {
            (format!("J{}", i - 1), format!("f{}", i - 1))
        };
        link(&mut text, i, (&place.0, &place.1), ["z", "x", "y"][i]);
    }
    for (first, last, begin) in [(3, 11, 2), (12, 20, 2)] {
        for i in first..=last {
            let before = if i == first { begin } else { i - 1 };
            link(&mut text, i, (&format!("J{before}"), &format!("f{before}")), ["y", "z", "x"][i % 3]);
        }
    }
    text.push_str(
        "[coordinates.s]\nunit = \"m\"\n[points.M]\nposition = \"J20 + 0.8*s*f20.x + 0.6*s*f20.z\"\n\
         [coordinates.spin]\nunit = \"rad\"\n[frames.wheel]\nparent = \"f20\"\nrotations = [[\"y\", \"spin\"]]\n\
         [bodies.wheel]\ncentre = \"M\"\nframe = \"wheel\"\nmass = \"0.7_kg\"\ninertia = { Ixx = 0.01, Iyy = 0.02, Izz = 0.01 }\n",
    );
    link(&mut text, 21, ("M", "f20"), "x");
    link(&mut text, 22, ("J21", "f21"), "y");
    text.push_str(
        "[inputs]\nF = { unit = \"N\" }\nT = { unit = \"N m\" }\n\
         [forces]\ntip = { point = \"C11\", force = \"F*N.x\" }\n\
         [torques]\nmotor = { frame = \"f4\", torque = \"T*f4.z\", reaction = \"f3\" }\n\
         [springs]\nrope = { between = [\"C11\", \"C20\"], stiffness = \"k\", rest_length = \"0.1_m\", damping = \"c\" }\n",
    );
    text
}

#[test]
fn a_tree_with_arms_a_slide_and_a_wheel() {
    check(&tree(), 23_500); // 42,224 by the mass matrix; most of it is the rope between tips
}

/// A base that flies: three slides, three turns at one point, then an arm.
#[test]
fn an_arm_on_a_free_base() {
    let mut text = head("flying", 16);
    text.push_str(
        "[coordinates]\nx = { unit = \"m\" }\ny = { unit = \"m\" }\nz = { unit = \"m\" }\n\
         roll = { unit = \"rad\", range = [-1, 1] }\npitch = { unit = \"rad\", range = [-1, 1] }\nyaw = { unit = \"rad\", range = [-1, 1] }\n\
         [frames.base]\nparent = \"N\"\nrotations = [[\"x\", \"roll\"], [\"y\", \"pitch\"], [\"z\", \"yaw\"]]\n\
         [points.B]\nposition = \"x*N.x + y*N.y + z*N.z\"\n\
         [bodies.base]\ncentre = \"B\"\nframe = \"base\"\nmass = \"4_kg\"\ninertia = { Ixx = 0.2, Iyy = 0.3, Izz = 0.4, Ixy = 0.02 }\n",
    );
    for i in 0..10 {
        let place = if i == 0 {
            ("B".to_owned(), "base".to_owned())
        } else {
            (format!("J{}", i - 1), format!("f{}", i - 1))
        };
        link(&mut text, i, (&place.0, &place.1), ["z", "x", "y"][i % 3]);
    }
    check(&text, 4_000); // 4,787 by the mass matrix
}

/// Bodies without any symmetry on ball joints, one on the other.
fn balls(n: usize) -> String {
    let mut text = head("balls", 3 * n);
    text.push_str("[joints]\n");
    for i in 0..n {
        let (parent, at) = match i {
            0 => ("N".to_owned(), "O".to_owned()),
            _ => (format!("f{}", i - 1), format!("f{0} + 0.3_m*f{0}.x + 0.1_m*f{0}.z", i - 1)),
        };
        writeln!(
            text,
            "b{i} = {{ kind = \"spherical\", parent = \"{parent}\", child = \"f{i}\", at = \"{at}\" }}"
        )
        .expect("a string grows");
    }
    text += &bodies(n);
    text
}

/// Bodies without symmetry, mass centres off the joints, on frames f0, f1, ...
fn bodies(n: usize) -> String {
    let body = |i| {
        format!(
            "[points.C{i}]\nposition = \"f{i} + 0.1_m*f{i}.x - 0.07_m*f{i}.y + 0.2_m*f{i}.z\"\n\
             [bodies.b{i}]\ncentre = \"C{i}\"\nframe = \"f{i}\"\nmass = \"1.5_kg\"\n\
             inertia = {{ Ixx = 0.03, Iyy = 0.04, Izz = 0.05, Ixy = 0.004, Ixz = -0.003, Iyz = 0.002 }}\n"
        )
    };
    (0..n).map(body).collect()
}

/// Makes Euler parameters of four numbers.
fn normalise(parameters: &mut [f64]) {
    let length = parameters.iter().map(|e| e * e).sum::<f64>().sqrt();
    parameters.iter_mut().for_each(|e| *e /= length);
}

#[test]
fn operations_of_ball_joints_in_a_row() {
    for (n, most) in [(1, 130), (2, 545), (3, 1_075), (4, 1_600), (8, 3_720)] {
        check_at(&balls(n), most, |q| q.chunks_exact_mut(4).for_each(normalise));
    }
}

/// Hinges, ball joints and a slide in a row, with a motor between two of them, a force at the tip and a rope to the
/// ground.
#[test]
fn hinges_and_ball_joints_in_a_row_under_loads() {
    let mut text = head("mixed", 9);
    text.push_str(
        "[inputs]\nF = { unit = \"N\" }\nT = { unit = \"N m\" }\n\
         [joints]\n\
         h0 = { kind = \"revolute\", axis = \"z\", child = \"f0\" }\n\
         b1 = { kind = \"spherical\", parent = \"f0\", child = \"f1\", at = \"f0 + 0.3_m*f0.x + 0.1_m*f0.z\" }\n\
         h2 = { kind = \"revolute\", axis = \"y\", parent = \"f1\", child = \"f2\", at = \"f1 + 0.2_m*f1.y\" }\n\
         b3 = { kind = \"spherical\", parent = \"f2\", child = \"f3\", at = \"f2 + 0.2_m*f2.x\" }\n\
         s4 = { kind = \"prismatic\", axis = \"x\", parent = \"f3\", child = \"f4\", at = \"f3 + 0.1_m*f3.z\" }\n\
         [forces]\ntip = { point = \"f4\", force = \"F*N.x\" }\n\
         [torques]\nmotor = { frame = \"f1\", torque = \"T*f1.z\", reaction = \"f0\" }\n\
         [springs]\nrope = { between = [\"f4\", \"O\"], stiffness = \"k\", rest_length = \"0.1_m\", damping = \"c\" }\n",
    );
    text += &bodies(5);
    check_at(&text, 1_800, |q| [1, 6].into_iter().for_each(|first| normalise(&mut q[first..first + 4])));
}

/// Links without symmetry, each on the joint whose kind `kind` gives.
fn jointed(n: usize, kind: impl Fn(usize) -> &'static str) -> String {
    let freedoms = |kind: &str| match kind {
        "spherical" | "planar" => 3,
        "cylindrical" | "universal" => 2,
        _ => 1,
    };
    let mut text = head("jointed", (0..n).map(|i| freedoms(kind(i))).sum());
    text.push_str("[joints]\n");
    for i in 0..n {
        let (parent, at) = match i {
            0 => ("N".to_owned(), "O".to_owned()),
            _ => (format!("f{}", i - 1), format!("f{0} + 0.3_m*f{0}.x + 0.1_m*f{0}.z", i - 1)),
        };
        let letters = ["x", "y", "z"];
        let axis = match kind(i) {
            "spherical" => String::new(),
            "universal" => format!("axes = [\"{}\", \"{}\"], ", letters[i % 3], letters[(i + 1) % 3]),
            _ => format!("axis = \"{}\", ", letters[i % 3]),
        };
        let turned = if i % 5 == 4 { ", turned = [[\"x\", \"20*deg\"]]" } else { "" };
        let kind = kind(i);
        writeln!(
            text,
            "j{i} = {{ kind = \"{kind}\", {axis}parent = \"{parent}\", child = \"f{i}\", at = \"{at}\"{turned} }}"
        )
        .expect("a string grows");
    }
    text + &bodies(n)
}

const KINDS: [&str; 6] = ["revolute", "prismatic", "cylindrical", "spherical", "universal", "planar"];

#[test]
fn operations_of_chains_with_all_joints_grow_linearly() {
    let hinges = |n| derived_from(&jointed(n, |_| "revolute")).operations();
    let mixed = |n| derived_from(&jointed(n, |i| KINDS[i % 6])).operations();
    let [short, long, longer] = [12, 24, 48].map(mixed);
    println!("12, 24, 48 links on joints of all kinds: {short}, {long}, {longer} operations");
    assert!(10 * (longer - long) <= 21 * (long - short), "{short}, {long}, {longer}");
    // Slides in a chain of hinges cost no more than hinges in their place.
    let all = hinges(30);
    for slides in [&[0][..], &[15], &[29], &[15, 16], &[3, 9, 20]] {
        let kind = |i| if slides.contains(&i) { "prismatic" } else { "revolute" };
        let begin = Instant::now();
        let some = derived_from(&jointed(30, kind)).operations();
        let took = begin.elapsed();
        println!("30 hinges, {slides:?} of them slides: {some} operations in {took:?}, {all} without");
        assert!(took < Duration::from_secs(3), "{slides:?}: {took:?}");
        assert!(some <= all, "{slides:?}: {some} of {all}");
    }
}

#[test]
fn chains_with_all_joints_move_as_before_the_elimination() {
    check_at(&jointed(12, |i| KINDS[i % 6]), 4_500, |q| {
        [4, 17].into_iter().for_each(|first| normalise(&mut q[first..first + 4]));
    });
}
