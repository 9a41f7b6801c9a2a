//! Elastic bar against a wall: analytic solution of Doyen, Ern & Piperno (2011), and twenty bounces under gravity.
//!
//! E = 900, rho = 1, L = 10, A = 1, v0 = 10: the bottom rests for 2 L/c = 2/3 s under 300 N, then leaves at +v0.
//! Error: root mean square over the time steps of the bottom's displacement error, over v0 L/c.

use smartbed::scene::run::run;
use smartbed::scene::{Scene, parse};

const C: f64 = 30.0;
const LENGTH: f64 = 10.0;
const V0: f64 = 10.0;

fn bar(elements: usize, courant: f64, settings: &[&str]) -> Scene {
    let step = courant * LENGTH / elements as f64 / C;
    let text = format!(
        "format = 1\nshape = \"bar\"\nelements = {elements}\ninitial_velocity = -10.0\ng = 0.0\nT = {}\nstep = {step:e}\nmethod = \"verlet\"\nallow_unstable = true\n",
        4.0 * LENGTH / C
    );
    let settings: Vec<String> = settings.iter().map(|s| (*s).to_string()).collect();
    parse("bar", &text, &settings).expect("scene")
}

fn rms_error(elements: usize, courant: f64, settings: &[&str]) -> f64 {
    let contact = 2.0 * LENGTH / C;
    let (mut sum, mut count) = (0.0, 0);
    run::<f64>(&bar(elements, courant, settings), |row| {
        let exact = if row.t <= contact { 0.0 } else { V0 * (row.t - contact) };
        sum += (row.pos[0][2] - exact).powi(2);
        count += 1;
    })
    .expect("run");
    (sum / f64::from(count)).sqrt() / (V0 * LENGTH / C)
}

#[test]
fn print_bar() {
    let penalty = |n: usize| format!("stiffness={}", 900.0 * n as f64 / 10.0);
    for (courant, table) in [(0.5, 0), (1.0, 1)] {
        for n in [10, 50, 200] {
            let k = penalty(n);
            for set in [
                vec!["law=compensation"],
                vec!["law=massless_point"],
                vec!["law=moreau", "e=0"],
                vec!["law=penalty", &k],
            ] {
                println!("{table} N {n} CFL {courant} {:?}: {:.3e}", set, rms_error(n, courant, &set));
            }
        }
    }
}
