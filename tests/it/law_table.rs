//! Every entry of the table law x method: an order is observed, a refusal is met when the scene is read.
//!
//! The orders are those that `cargo smartbed report` prints, measured against another method with the same law. The
//! laws themselves are tested against closed forms (`contact_laws.rs`) and an independent program (`independent.rs`).

use smartbed::report::laws::{observe, scene};
use smartbed::scene::method::{METHODS, TABLE};
use smartbed::scene::run::run;

/// How far an observed order may lie below the stated one: kinks lie at random places within steps.
const SLACK: f64 = 0.25;

#[test]
fn every_entry_keeps_its_order_or_is_refused() {
    let mut wrong = Vec::new();
    for seen in observe().expect("what the table allows runs") {
        let (law, method) = (seen.row.law, seen.method);
        match (seen.entry, seen.observed) {
            (Ok(order), Some((observed, points))) => {
                println!(
                    "{law} damped {} {method}: {observed:.2} of {order} ({points} points)",
                    seen.row.damped
                );
                if points < 3 || observed.is_nan() || observed < f64::from(order) - SLACK {
                    wrong.push(format!("{law} {} {method}: {observed:.2} of {order}", seen.row.damped));
                }
            }
            (Ok(_), None) => wrong.push(format!("{law} {method}: not observed")),
            (Err(reason), _) => match scene(&seen.row, 0.1, &[format!("method={method}")]) {
                Ok(_) => wrong.push(format!("{law} {} {method}: not refused", seen.row.damped)),
                // A key that the law does not read is refused before the table is asked.
                Err(message) if law == "moreau" => assert!(message.contains("nothing reads it"), "{message}"),
                Err(message) => assert!(message.contains(reason), "{message}"),
            },
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// A scene that names no method gets one of its row, and says why.
#[test]
fn a_default_method_says_why() {
    for row in &TABLE {
        let scene = scene(row, 0.1, &[]).expect("a scene");
        let column = METHODS.iter().position(|(name, ..)| *name == scene.chosen.name).expect("a method");
        assert_eq!(Ok(scene.chosen.order), row.entries[column], "{}", row.law);
        assert!(!scene.chosen.why.is_empty());
        let mut rows = 0;
        run::<f64>(&scene, |_| rows += 1).expect("a run");
        assert!(rows > 300);
    }
}
