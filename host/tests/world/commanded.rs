//! Mechanisms of which the scene commands some coordinates, or all.

use super::rigid::G;
use super::support::{fails, rows, scene};

/// The numbers of a column.
fn column((names, rows): &(Vec<String>, Vec<Vec<f64>>), name: &str) -> Vec<f64> {
    let at = names.iter().position(|own| own == name).unwrap_or_else(|| panic!("no column {name}"));
    rows.iter().map(|row| row[at]).collect()
}

/// The upper rod of a double pendulum stands still as commanded: the lower one keeps its energy, that of a rod about its end.
#[test]
fn one_coordinate_of_an_open_chain_is_commanded() {
    let text = "format = 2\n[parts.arm]\nmechanism = \"double_pendulum\"\ncommand = { q1 = \"0*t/1_s\" }\nset = { c = 0 }\n\
                start = { q2 = \"50_deg\" }\n[run]\nseconds = 1\n";
    let rows = rows(&[&scene("open_chain", text)]);
    let (m, l) = (0.8, 0.4);
    let energy = |q: f64, u: f64| 0.5 * (m * l * l / 3.0) * u * u - m * G * 0.5 * l * q.cos();
    let (q, u) = (column(&rows, "arm.q2"), column(&rows, "arm.u_q2"));
    assert!(q.iter().any(|q| *q < -0.5), "it swings through");
    for (q, u) in q.iter().zip(&u) {
        assert!((energy(*q, *u) - energy(q_start(), 0.0)).abs() < 1e-9, "{q} {u}");
    }
    assert!(column(&rows, "arm.q1").iter().all(|q| *q == 0.0));
}

fn q_start() -> f64 {
    50_f64.to_radians()
}

#[test]
fn commanded_coordinates_have_columns() {
    let text = |sensor: &str| {
        format!(
            "format = 2\n[parts.arm]\nmechanism = \"pendulum\"\ncommand = {{ q = \"0.2*sin(t/0.1_s)\" }}\n{sensor}[run]\nseconds = 0.1\n"
        )
    };
    let sensor = "[sensors.angle]\nof = \"arm.q\"\nunit = \"deg\"\n";
    let rows = rows(&[&scene("columns", &text(sensor))]);
    let seen = column(&rows, "sensors.angle");
    for ((t, q), seen) in column(&rows, "t").iter().zip(column(&rows, "arm.q")).zip(seen) {
        assert!((q - 0.2 * (10.0 * t).sin()).abs() < 1e-15 && q == seen, "{t}: {q} {seen}");
    }
}

#[test]
fn commands_that_are_not_finite_are_refused_by_name_and_time() {
    // Infinite speed at the start; no speed there, but infinite acceleration; infinite speed later.
    for (law, time) in
        [("sqrt(t/1_s)", "0.000000"), ("sqrt(t/1_s)*t/1_s", "0.000000"), ("sqrt(0.01 - t/1_s)", "0.01")]
    {
        let text = format!(
            "format = 2\n[parts.arm]\nmechanism = \"pendulum\"\ncommand = {{ q = \"{law}\" }}\n[run]\nseconds = 0.02\n"
        );
        let said = fails(&["run", &scene("infinite", &text), "--csv", "-"]);
        assert!(said.contains(&format!("t = {time}")), "{law}: {said}");
        assert!(said.contains("`arm` has an energy or a power that is not finite"), "{law}: {said}");
    }
}
