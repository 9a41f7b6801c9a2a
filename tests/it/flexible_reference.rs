//! Drop scenes against trajectories computed in 80-bit arithmetic (`tests/reference`).
use smartbed::scene::{parse, run::run};

#[test]
fn print_errors() {
    for name in ["single_spring", "single_spring_damped", "double_spring", "truss_damped"] {
        let path = format!("{}/reference/{name}.json", env!("CARGO_MANIFEST_DIR"));
        let text = std::fs::read_to_string(&path).unwrap();
        let reference: serde_json::Value = serde_json::from_str(&text).unwrap();
        let last = reference["states"].as_array().unwrap().last().unwrap().clone();
        for method in ["verlet", "nystrom4", "rk4", "implicit_midpoint", "energy_momentum", "symplectic_euler", "dop853", "dormand_prince"] {
            for h in ["1e-3", "1e-4"] {
                let set = [format!("method={method}"), format!("step={h}"), "tolerance=1e-12".to_string()];
                let scene = parse("x.json", &text, &set).unwrap();
                let mut end = None;
                let mut worst = (0.0_f64, 0.0_f64, 0.0_f64, 0.0_f64);
                let events = run::<f64>(&scene, |row| {
                    if let Some(prev) = &end {
                        let prev: &smartbed::scene::run::Row = prev;
                        worst.0 = worst.0.max(row.energy.total - prev.energy.total);
                    }
                    worst.1 = worst.1.max((row.energy.total - reference["total_energy_initial"].as_f64().unwrap()).abs());
                    worst.2 = worst.2.max(row.energy.imbalance.abs());
                    end = Some(row.clone())
                }).unwrap_or_else(|e| { println!("{e}"); vec![] });
                let end = end.unwrap();
                let err = end.pos.iter().flatten().enumerate().map(|(k, x)| (x - last[k].as_f64().unwrap()).abs()).fold(0.0, f64::max);
                println!("{name} {method} {h}: t {} err {err:.2e} events {} ref {} rise {:.1e} change {:.1e} imb {:.1e}", end.t, events.len(), reference["events"].as_array().unwrap().len(), worst.0, worst.1, worst.2);
            }
        }
    }
}
