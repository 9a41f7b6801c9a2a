//! Gas in a volume: closed forms of compression, blow-down and filling; the energy balance to the method's order.

use smartbed_runtime::gas::{
    Account, Chamber, Gas, GasFault, GasState, LINEAR_RANGE, Line, Nozzle, REFERENCE_DENSITY,
    REFERENCE_TEMPERATURE, Regulated, Source,
};

const AMBIENT: f64 = 101_325.0;
const ROOM: f64 = 293.15;
const MMHG: f64 = 133.322;
/// A tile's bladder, 100 mm high (m^3).
const BLADDER: f64 = 0.0643 * 0.1;

fn chamber(exponent: f64) -> Chamber<f64> {
    Chamber { gas: Gas::air(), exponent, reference_volume: BLADDER, ambient: AMBIENT }
}

fn at(pressure: f64) -> Source<f64> {
    Source { pressure, temperature: ROOM }
}

fn line(nozzle: Nozzle<f64>, pressure: f64) -> Line<f64> {
    Line { nozzle, opening: 1.0, reservoir: at(pressure) }
}

/// A chamber on its way: (state, accounts) by Runge and Kutta's method while the volume is a given function of time.
struct Run {
    state: GasState<f64>,
    account: Account<f64>,
    time: f64,
}

impl Run {
    fn step(
        &mut self,
        chamber: &Chamber<f64>,
        volume: impl Fn(f64) -> [f64; 2],
        lines: &[Line<f64>],
        h: f64,
    ) {
        let rates = |c: f64, of: &GasState<f64>| {
            let [v, rate] = volume(self.time + c * h);
            chamber.rates(of, v, rate, lines).expect("gas")
        };
        let moved = |by: f64, k: &smartbed_runtime::gas::Rates<f64>| GasState {
            reference_pressure: self.state.reference_pressure + by * k.reference_pressure,
            mass: self.state.mass + by * k.mass,
        };
        let a = rates(0.0, &self.state);
        let b = rates(0.5, &moved(0.5 * h, &a));
        let c = rates(0.5, &moved(0.5 * h, &b));
        let d = rates(1.0, &moved(h, &c));
        for (k, weight) in [(a, 1.0), (b, 2.0), (c, 2.0), (d, 1.0)] {
            self.state.reference_pressure += h * weight / 6.0 * k.reference_pressure;
            self.state.mass += h * weight / 6.0 * k.mass;
            self.account = self.account.plus(h * weight / 6.0, &k.power);
        }
        self.time += h;
    }

    fn new(state: GasState<f64>) -> Run {
        Run { state, account: Account::empty(), time: 0.0 }
    }
}

fn close(a: f64, b: f64, relative: f64) {
    assert!((a - b).abs() <= relative * b.abs(), "{a} is not {b}, off by {:e}", (a - b).abs() / b.abs());
}

#[test]
fn a_sealed_gas_is_compressed_by_the_closed_forms() {
    for n in [1.0, 1.2, 1.4] {
        let chamber = chamber(n);
        let start = chamber.filled(at(AMBIENT + 4000.0), BLADDER);
        for share in [0.5, 0.9, 1.0, 1.7] {
            let volume = share * BLADDER;
            let inside = chamber.inside(&start, volume).expect("gas");
            close(inside.pressure, (AMBIENT + 4000.0) * share.powf(-n), 1e-14);
            close(inside.temperature, ROOM * share.powf(1.0 - n), 1e-14);
            // The potential's slope is minus the gauge pressure; the stiffness is that of the pressure.
            let d = 1e-5 * BLADDER;
            let slope = |f: &dyn Fn(f64) -> f64| (f(volume + d) - f(volume - d)) / (2.0 * d);
            let force = -slope(&|v| chamber.potential(&start, v).expect("gas"));
            let gauge = chamber.gauge_pressure(&start, volume).expect("gas");
            assert!((force - gauge).abs() <= 1e-8 * inside.pressure, "{force} {gauge}");
            let stiffness = -slope(&|v| chamber.pressure(&start, v).expect("gas"));
            close(chamber.stiffness(&start, volume).expect("gas"), stiffness, 1e-8);
        }
        // Work and heat of a compression to half the volume; n = 1: all work leaves as heat.
        let mut run = Run::new(start);
        let volume = |t: f64| [BLADDER * (1.0 - 0.5 * t), -0.5 * BLADDER];
        (0..1000).for_each(|_| run.step(&chamber, volume, &[], 1e-3));
        let (p, r) = (AMBIENT + 4000.0, 0.5_f64);
        let work =
            if n == 1.0 { p * BLADDER * r.ln() } else { p * BLADDER * (1.0 - r.powf(1.0 - n)) / (n - 1.0) };
        close(run.account.work, work, 1e-12);
        assert_eq!(run.state, start, "nothing flows: the state stays to the last bit");
        let heat = (1.4 - n) / 0.4 * work;
        assert!((run.account.heat - heat).abs() <= 1e-12 * work.abs(), "{} {heat}", run.account.heat);
    }
}

#[test]
fn a_choked_vessel_blows_down_by_the_closed_form() {
    let nozzle = Nozzle { conductance: 2e-8, critical_ratio: 0.4 };
    for n in [1.0, 1.25, 1.4] {
        let chamber = chamber(n);
        let start = 10.0 * AMBIENT;
        let mut run = Run::new(chamber.filled(at(start), BLADDER));
        let rate = 287.05 * ROOM * 2e-8 * REFERENCE_DENSITY * (REFERENCE_TEMPERATURE / ROOM).sqrt() / BLADDER;
        // y^-k is linear in time with k = (n - 1)/(2 n); n = 1: an exponential.
        let exact = |t: f64| {
            let z = 0.5 * (n - 1.0) * rate * t;
            if n == 1.0 { (-rate * t).exp() } else { (1.0 + z).powf(-2.0 * n / (n - 1.0)) }
        };
        while exact(run.time) > 0.35 {
            run.step(&chamber, |_| [BLADDER, 0.0], &[line(nozzle, AMBIENT)], 5e-3 / rate);
            let inside = chamber.inside(&run.state, BLADDER).expect("gas");
            close(inside.pressure / start, exact(run.time), 1e-10);
            close(inside.temperature, ROOM * exact(run.time).powf((n - 1.0) / n), 1e-10);
        }
        assert!(run.time * rate > 0.5);
    }
}

#[test]
fn a_chamber_fills_to_equilibrium_with_the_enthalpy_of_what_came_in() {
    let gas: Gas<f64> = Gas::air();
    let nozzle = Nozzle::orifice(&gas, 3e-3, 0.8);
    let (chamber, supply) = (chamber(1.4), 5.0 * AMBIENT);
    let start = chamber.filled(at(1e-3 * AMBIENT), BLADDER);
    let mut run = Run::new(start);
    (0..100_000).for_each(|_| run.step(&chamber, |_| [BLADDER, 0.0], &[line(nozzle, supply)], 1e-4));
    let inside = chamber.inside(&run.state, BLADDER).expect("gas");
    close(inside.pressure, supply, 1e-9);
    // First law: c_v (m T - m_0 T_0) = c_p T_s (m - m_0); into a vacuum T would be gamma T_s.
    let brought = gas.heat_capacity() * ROOM * (run.state.mass - start.mass);
    let energy = |s: &GasState<f64>| chamber.internal_energy(s, BLADDER).expect("gas");
    close(energy(&run.state) - energy(&start), brought, 1e-9);
    assert!((inside.temperature / ROOM - 1.4).abs() < 1e-3, "{}", inside.temperature / ROOM);
}

#[test]
fn near_equal_pressures_the_flow_is_linear_and_odd() {
    let nozzle = Nozzle { conductance: 3e-8, critical_ratio: 0.3 };
    let flow = |left: f64| nozzle.mass_flow(at(AMBIENT), AMBIENT * (1.0 - left));
    let whole = flow(LINEAR_RANGE);
    for share in [1.0 / 1024.0, 0.25, 0.5] {
        close(flow(share * LINEAR_RANGE), share * whole, 1e-9);
    }
    close(flow(LINEAR_RANGE * (1.0 + 1e-9)), whole, 1e-8);
    assert_eq!(flow(0.0), 0.0);
    assert_eq!(flow(-0.1), 0.0);
    // Inside the range a chamber relaxes by an exponential: p_1 is constant within the range.
    let chamber = chamber(1.0);
    let supply = AMBIENT;
    let gap = 1e-6;
    let mut run = Run::new(chamber.filled(at(supply * (1.0 - gap)), BLADDER));
    let rate = 287.05 * ROOM * whole / (LINEAR_RANGE * supply * BLADDER);
    for _ in 0..100 {
        run.step(&chamber, |_| [BLADDER, 0.0], &[line(nozzle, supply)], 0.03 / rate);
        let left = 1.0 - chamber.pressure(&run.state, BLADDER).expect("gas") / supply;
        assert!((left - gap * (-rate * run.time).exp()).abs() <= 1e-8 * gap, "{left}");
    }
}

#[test]
fn the_ellipse_of_an_orifice_is_near_saint_venants_law() {
    let gas: Gas<f64> = Gas::air();
    let (diameter, discharge) = (2e-3, 0.65);
    let nozzle = Nozzle::orifice(&gas, diameter, discharge);
    let area = std::f64::consts::FRAC_PI_4 * diameter * diameter;
    close(nozzle.critical_ratio, 0.528_281_787_717_174_3, 1e-12);
    for ratio in [0.1, 0.5, 0.6, 0.7, 0.8, 0.9, 0.99, 0.998] {
        let r: f64 = f64::max(ratio, nozzle.critical_ratio);
        let exact = discharge * area * 3e5 / (287.05 * ROOM).sqrt()
            * (2.0 * 1.4 / 0.4 * (r.powf(2.0 / 1.4) - r.powf(2.4 / 1.4))).sqrt();
        close(nozzle.mass_flow(at(3e5), 3e5 * ratio), exact, 1e-2);
    }
}

#[test]
fn energy_balances_to_the_order_of_the_method() {
    let gas: Gas<f64> = Gas::air();
    let off = |n: f64, steps: u32| {
        let chamber = chamber(n);
        let lines = [
            line(Nozzle { conductance: 4e-9, critical_ratio: 0.3 }, 1.5 * AMBIENT),
            line(Nozzle::orifice(&gas, 2e-3, 0.65), AMBIENT),
        ];
        let volume = |t: f64| [BLADDER * (1.0 - 0.2 * (3.0 * t).sin()), -0.6 * BLADDER * (3.0 * t).cos()];
        let mut run = Run::new(chamber.filled(at(1.2 * AMBIENT), BLADDER));
        let energy = |run: &Run| chamber.internal_energy(&run.state, volume(run.time)[0]).expect("gas");
        let before = energy(&run);
        (0..steps).for_each(|_| run.step(&chamber, volume, &lines, 1.0 / f64::from(steps)));
        let throughput = run.account.enthalpy_in + run.account.enthalpy_out;
        assert!(run.account.enthalpy_in > 10.0 && run.account.enthalpy_out > 10.0);
        ((energy(&run) - before - run.account.gain()) / throughput).abs()
    };
    for n in [1.0, 1.15, 1.4] {
        let [a, b] = [off(n, 50), off(n, 100)];
        // n = 1: the energy is linear in the state, which every method integrates to rounding.
        assert!(a < 1e-6 && (a < 1e-14 || (a / b).log2() > 3.6), "n = {n}: {a:e} {b:e}");
    }
}

#[test]
fn a_tile_vents_as_the_orifice_formula_says() {
    let gas: Gas<f64> = Gas::air();
    // 50 to 10 mmHg at fixed volume: t = V/(R T) times the integral of dp/m' with Bernoulli's m' = Cd A sqrt(2 rho dp).
    let time_of = |diameter: f64| {
        let chamber = chamber(1.0);
        let mut run = Run::new(chamber.filled(at(AMBIENT + 50.0 * MMHG), BLADDER));
        let vent = line(Nozzle::orifice(&gas, diameter, 0.65), AMBIENT);
        while chamber.gauge_pressure(&run.state, BLADDER).expect("gas") > 10.0 * MMHG {
            run.step(&chamber, |_| [BLADDER, 0.0], &[vent], 1e-4);
        }
        run.time
    };
    let area = |d: f64| std::f64::consts::FRAC_PI_4 * d * d;
    for (diameter, rounded) in [(2e-3, 2.1), (4e-3, 0.5)] {
        let density = (AMBIENT + 30.0 * MMHG) / (287.05 * ROOM);
        let root = |mmhg: f64| (mmhg * MMHG).sqrt();
        let bernoulli = BLADDER / (287.05 * ROOM) * 2.0 * (root(50.0) - root(10.0))
            / (0.65 * area(diameter) * (2.0 * density).sqrt());
        let time = time_of(diameter);
        // The ellipse and Bernoulli's incompressible law differ by 2.4 % here.
        close(time, bernoulli, 0.03);
        assert!((time - rounded).abs() < 0.1, "{time}");
    }
    // Emptied by a load that keeps 30 mmHg: through 4 mm in less than 30 s, the demand on a bed that must lie flat.
    let vent = Nozzle::orifice(&gas, 4e-3, 0.65);
    let flow = vent.mass_flow(at(AMBIENT + 30.0 * MMHG), AMBIENT) * 287.05 * ROOM / (AMBIENT + 30.0 * MMHG);
    close(BLADDER / flow, 9.6, 0.06);
}

#[test]
fn a_regulator_keeps_its_books_and_faults_are_values() {
    let regulated = Regulated { gas: Gas::<f64>::air(), gauge: 4000.0, ambient: AMBIENT };
    for rate in [1e-3, -1e-3] {
        let power = regulated.power(rate);
        let gained = regulated.internal_energy(1.0 + rate) - regulated.internal_energy(1.0);
        close(power.gain(), gained, 1e-9);
        assert!(power.enthalpy_in >= 0.0 && power.enthalpy_out >= 0.0);
        let slope = regulated.potential(1.0) - regulated.potential(1.0 + rate);
        close(slope, 4000.0 * rate, 1e-9);
    }
    let chamber = chamber(1.4);
    let state = chamber.filled(at(AMBIENT), BLADDER);
    assert_eq!(chamber.pressure(&state, -1.0), Err(GasFault::Collapsed(-1.0)));
    assert_eq!(chamber.rates(&state, 0.0, 0.0, &[]), Err(GasFault::Collapsed(0.0)));
    let empty = GasState { mass: 0.0, ..state };
    assert_eq!(chamber.rates(&empty, BLADDER, 0.0, &[]), Err(GasFault::Empty(0.0)));
    // A shut valve lets nothing through; in f32 the same formulas hold.
    let shut = Line { opening: 0.0, ..line(Nozzle::orifice(&Gas::air(), 2e-3, 0.65), 2.0 * AMBIENT) };
    let rates = chamber.rates(&state, BLADDER, 0.0, &[shut]).expect("gas");
    assert_eq!((rates.mass, rates.reference_pressure), (0.0, 0.0));
    let small: Nozzle<f32> = Nozzle::orifice(&Gas::air(), 2e-3, 0.65);
    let flow = small.mass_flow(Source { pressure: 105_325.0, temperature: 293.15 }, 101_325.0);
    let wide = Nozzle::orifice(&Gas::air(), 2e-3, 0.65).mass_flow(at(AMBIENT + 4000.0), AMBIENT);
    close(f64::from(flow), wide, 1e-5);
}

#[test]
fn an_exponent_near_1_keeps_the_digits_of_works() {
    // The series of (1 - e^-z)/z in f64, at the same exponent.
    let exact = |exponent: f32, ratio: f64| {
        let (log, z) = (ratio.ln(), (f64::from(exponent) - 1.0) * ratio.ln());
        let mut term = 1.0;
        log * (1..24).fold(1.0, |sum, k| {
            term *= -z / f64::from(k + 1);
            sum + term
        })
    };
    for exponent in [1.0, 1.000_000_1, 1.000_001, 1.000_01, 1.000_1, 1.001, 1.01, 1.05, 1.07, 1.4_f32] {
        let chamber = Chamber { gas: Gas::air(), exponent, reference_volume: 1.0, ambient: 0.0 };
        for ratio in [0.5, 0.75, 1.25, 2.0, 8.0] {
            let state = GasState { reference_pressure: 1.0, mass: 1.0 };
            let (work, exact) =
                (-chamber.potential(&state, ratio).unwrap(), exact(exponent, f64::from(ratio)));
            let error = (f64::from(work) - exact).abs() / exact.abs();
            // Four bits of 2^-24 at most, and the rounding of the logarithm.
            assert!(error <= 2e-6, "n = {exponent}, V/V_r = {ratio}: {work} instead of {exact}");
            let pushed = chamber.pushed(&state, 1.0, ratio);
            assert!((f64::from(pushed.work) - exact).abs() <= 2e-6 * exact.abs(), "{exponent} {ratio}");
        }
    }
}
