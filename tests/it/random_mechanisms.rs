//! Random mechanisms of every kind, as texts, against Newton-Euler: accelerations, energies, speeds, outputs, residual,
//! correction. `SMARTBED_MECHANISMS=1000000` asks for a million, `SMARTBED_FIRST` for seeds from there on.

use smartbed_codegen::{Effort, Optimise, Settings};
use smartbed_tests::random::Random;
use smartbed_tests::trial::draw::{self, KINDS};
use smartbed_tests::trial::{text, verdict};

/// Mechanisms in all.
const MECHANISMS: u64 = 10_000;
/// States of each.
const STATES: usize = 3;
/// At most this share of the states may be singular to the oracle or out of reach.
const SINGULAR: f64 = 0.05;
/// At most this share of the models may be refused: the oracle, too, meets a singular state in their ranges.
const REFUSED: f64 = 0.01;

/// A number from the environment.
fn asked(name: &str, default: u64) -> u64 {
    std::env::var(name).map_or(default, |text| text.parse().unwrap_or_else(|_| panic!("{name}: a number")))
}

/// Most are derived as users do, some for accuracy, with no effort or with all.
fn settings(seed: u64) -> Settings {
    match seed % 500 {
        3 => Effort::All.into(),
        n if n % 10 == 5 => Effort::None.into(),
        n if n % 10 == 7 => Settings { optimise: Optimise::Accuracy, ..Settings::default() },
        _ => Settings::default(),
    }
}

/// What was found of some mechanisms.
#[derive(Default)]
struct Tally {
    compared: usize,
    redundant: usize,
    singular: usize,
    refused: usize,
    unexplained: usize,
    worst: f64,
}

impl Tally {
    /// The mechanisms of every kind with one seed.
    fn add(&mut self, seed: u64) {
        for kind in KINDS {
            let d = draw::mechanism(kind, seed);
            let found = verdict::of(&d, settings(seed), STATES, &mut Random::new(seed));
            let show = || format!("{kind:?}, seed {seed}\n{}", text::model(&d));
            assert!(found.worst <= verdict::AGREEMENT, "{:e}: {}\n{}", found.worst, found.place, show());
            self.unexplained += found.refused.len();
            if let Some(message) = &found.refusal {
                let agreed = verdict::is_singular_somewhere(&d, &mut Random::new(seed));
                *(if agreed { &mut self.refused } else { &mut self.unexplained }) += 1;
                println!("{kind:?}, seed {seed}, {agreed}: {}", message.lines().next().unwrap_or_default());
            }
            self.compared += found.compared;
            self.redundant += found.redundant;
            self.singular += found.singular;
            self.worst = self.worst.max(found.worst);
        }
    }

    fn plus(self, other: Self) -> Self {
        Self {
            compared: self.compared + other.compared,
            redundant: self.redundant + other.redundant,
            singular: self.singular + other.singular,
            refused: self.refused + other.refused,
            unexplained: self.unexplained + other.unexplained,
            worst: self.worst.max(other.worst),
        }
    }
}

#[test]
fn random_mechanisms_move_as_newton_and_euler_say() {
    let count = asked("SMARTBED_MECHANISMS", MECHANISMS);
    let first = asked("SMARTBED_FIRST", 0);
    let seeds = first..first + count.div_ceil(KINDS.len() as u64);
    // Each thread takes every n-th seed: by the end of this program other cores may be idle.
    let n = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let Tally { compared, redundant, singular, refused, unexplained, worst } = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..n)
            .map(|k| {
                let seeds = seeds.clone().skip(k).step_by(n);
                scope.spawn(move || {
                    let mut tally = Tally::default();
                    seeds.for_each(|seed| tally.add(seed));
                    tally
                })
            })
            .collect();
        let tallies = threads.into_iter().map(|thread| {
            // The message of a thread that panics is that of the test.
            thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
        });
        tallies.fold(Tally::default(), Tally::plus)
    });
    println!(
        "{count} mechanisms: {compared} states compared, {redundant} of them with all speeds as state, worst {worst:.1e}; {singular} singular, {refused} refused, \
         {unexplained} without reason"
    );
    assert!((singular as f64) < SINGULAR * compared as f64, "{singular} of {compared} states singular");
    assert!((refused as f64) <= REFUSED * count as f64, "{refused} of {count} models refused");
    assert_eq!(unexplained, 0, "refused though the oracle finds them regular");
}
