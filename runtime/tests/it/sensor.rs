//! Sensors: statistics of the noise, steps of the quantisation, holding, delay, and the same bytes from the same seed.

use smartbed_runtime::sensor::kinds::{Lvdt, Membrane, Switch, encoder_resolution};
use smartbed_runtime::sensor::noise::Noise;
use smartbed_runtime::sensor::{Channel, ChannelFault, Sensor, quantised};

const EXACT: Channel<f64> =
    Channel { period: 1, delay: 0, noise: 0.0, bias: 0.0, drift: 0.0, resolution: 0.0, range: [-1e9, 1e9] };

#[test]
fn noise_has_the_moments_of_the_normal_distribution_and_no_memory() {
    const COUNT: u64 = 400_000;
    let source = Noise::new(42);
    let (mut sums, mut beyond, mut neighbours, mut before) = ([0.0; 4], [0; 3], 0.0, 0.0);
    for number in 0..COUNT {
        let x: f64 = source.normal(number);
        let mut power = 1.0;
        for sum in &mut sums {
            power *= x;
            *sum += power;
        }
        (0..3).for_each(|k| beyond[k] += usize::from(x.abs() > (k + 1) as f64));
        neighbours += x * before;
        before = x;
    }
    let mean = |x: f64| x / COUNT as f64;
    // Four deviations of each mean: sqrt(var/COUNT), var of x, x^2, x^3, x^4 being 1, 2, 15, 96.
    for (k, (moment, variance)) in [(0.0, 1.0), (1.0, 2.0), (0.0, 15.0), (3.0, 96.0)].into_iter().enumerate()
    {
        let deviation = f64::sqrt(variance / COUNT as f64);
        assert!((mean(sums[k]) - moment).abs() <= 4.0 * deviation, "moment {}: {}", k + 1, mean(sums[k]));
    }
    assert!(mean(neighbours).abs() <= 4.0 / (COUNT as f64).sqrt(), "{neighbours}");
    for (count, share) in beyond.into_iter().zip([0.317_310_5, 0.045_500_3, 0.002_699_8]) {
        let deviation = (share * (1.0 - share) / COUNT as f64).sqrt();
        assert!((mean(count as f64) - share).abs() <= 4.0 * deviation, "{share}: {count}");
    }
    // Of another seed another stream; in f32 the same to rounding.
    assert!((0..1000).filter(|n| Noise::new(43).bits(*n) == source.bits(*n)).count() == 0);
    for number in 0..1000 {
        let (double, single): (f64, f32) = (source.normal(number), source.normal(number));
        assert!((double - f64::from(single)).abs() <= 1e-5 * (1.0 + double.abs()));
    }
}

#[test]
fn readings_have_the_stated_noise_bias_and_drift() {
    let channel = Channel { noise: 0.2, drift: 1e-5, ..EXACT };
    let mut sensor: Sensor<f64, 1> = Sensor::new(channel, 7, 0.0).expect("a channel");
    let (mut sum, mut square, count) = (0.0, 0.0, 100_000_u64);
    for tick in 0..count {
        sensor.observe(tick, 3.0);
        let off = sensor.reading(tick) - 3.0 - 1e-5 * tick as f64;
        (sum, square) = (sum + off, square + off * off);
    }
    let (mean, deviation) = (sum / count as f64, (square / count as f64).sqrt());
    assert!(mean.abs() <= 4.0 * 0.2 / (count as f64).sqrt(), "{mean}");
    assert!((deviation - 0.2).abs() <= 4.0 * 0.2 / (2.0 * count as f64).sqrt(), "{deviation}");
    // The bias differs from sensor to sensor, and stays with each.
    let biased = Channel { bias: 0.5, ..EXACT };
    let bias = |seed: u64| {
        let mut sensor: Sensor<f64, 1> = Sensor::new(biased, seed, 0.0).expect("a channel");
        sensor.observe(0, 1.0);
        let first = sensor.reading(0) - 1.0;
        sensor.observe(50, 2.0);
        assert!((sensor.reading(50) - 2.0 - first).abs() <= 1e-15);
        first
    };
    let all: Vec<f64> = (0..4000).map(bias).collect();
    let spread = (all.iter().map(|b| b * b).sum::<f64>() / 4000.0).sqrt();
    assert!((spread - 0.5).abs() <= 4.0 * 0.5 / 8000_f64.sqrt(), "{spread}");
}

#[test]
fn readings_are_sampled_held_delayed_and_quantised() {
    let channel = Channel { period: 10, delay: 25, resolution: 0.5, range: [0.0, 20.0], ..EXACT };
    let mut sensor: Sensor<f64, 4> = Sensor::new(channel, 1, -1.0).expect("a channel");
    for tick in 0..300 {
        sensor.observe(tick, 0.1 * tick as f64);
        // The sample at 10 k of 0.1 times it appears at 10 k + 25.
        let wanted = if tick < 25 { -1.0 } else { f64::min((tick - 25) as f64 / 10.0, 20.0).floor() };
        assert_eq!(sensor.reading(tick), wanted, "{tick}");
        let again = sensor.reading(tick);
        assert_eq!(again, wanted, "reading changes nothing");
    }
    // Values are the nearest steps, and every step occurs.
    let mut fine: Sensor<f64, 1> =
        Sensor::new(Channel { resolution: 0.25, ..EXACT }, 1, 0.0).expect("a channel");
    let mut seen = std::collections::BTreeSet::new();
    for tick in 0..2001 {
        let value = -1.0 + 1e-3 * tick as f64;
        fine.observe(tick, value);
        let reading = fine.reading(tick);
        assert!((reading - value).abs() <= 0.125 + 1e-12 && (reading * 4.0).fract() == 0.0);
        seen.insert((reading * 4.0) as i64);
    }
    assert_eq!(seen.into_iter().collect::<Vec<_>>(), (-4..=4).collect::<Vec<_>>());
    // Too large to have a fraction, no step, halves to even.
    assert_eq!([quantised(1e300, 1.0), quantised(0.3, 0.0)], [1e300, 0.3]);
    assert_eq!([0.75, 1.25, -0.3].map(|x| quantised::<f32>(x, 0.5)), [1.0, 1.0, -0.5]);
}

#[test]
fn the_same_seed_gives_the_same_bytes_however_often_it_is_asked() {
    let channel = Channel { period: 4, delay: 3, noise: 0.1, bias: 0.2, drift: 1e-3, ..EXACT };
    let run = |seed: u64, often: u64| {
        let mut sensor: Sensor<f64, 2> = Sensor::new(channel, seed, 0.0).expect("a channel");
        let mut bytes = Vec::new();
        for tick in 0..1000_u64 {
            // Values change only with the samples, so that calls between them see the same.
            if tick % often == 0 {
                sensor.observe(tick, (tick / 4) as f64);
            }
            if tick % 4 == 3 {
                bytes.extend(sensor.reading(tick).to_le_bytes());
            }
        }
        bytes
    };
    assert_eq!(run(5, 1), run(5, 1));
    assert_eq!(run(5, 1), run(5, 4), "steps of the caller do not matter");
    assert_ne!(run(5, 1), run(6, 1));
}

#[test]
fn channels_that_cannot_be_are_refused() {
    let refused = |channel: Channel<f64>| Sensor::<f64, 2>::new(channel, 1, 0.0).err();
    assert_eq!(refused(Channel { period: 0, ..EXACT }), Some(ChannelFault::NoPeriod));
    assert_eq!(refused(Channel { delay: 2, ..EXACT }), Some(ChannelFault::TooLate));
    assert_eq!(refused(Channel { delay: 1, ..EXACT }), None);
    assert_eq!(refused(Channel { noise: -1.0, ..EXACT }), Some(ChannelFault::OutOfRange));
    assert_eq!(refused(Channel { resolution: f64::NAN, ..EXACT }), Some(ChannelFault::OutOfRange));
    assert_eq!(refused(Channel { range: [1.0, 0.0], ..EXACT }), Some(ChannelFault::OutOfRange));
    for x in [f64::INFINITY, f64::NAN] {
        for channel in [
            Channel { noise: x, ..EXACT },
            Channel { bias: x, ..EXACT },
            Channel { drift: x, ..EXACT },
            Channel { resolution: x, ..EXACT },
        ] {
            assert_eq!(refused(channel), Some(ChannelFault::OutOfRange), "{channel:?}");
        }
    }
}

#[test]
fn transducers_do_what_their_makers_say() {
    // 1024 lines, worm 30:1, lead 4 mm: 0.03 um.
    assert!((encoder_resolution(1024.0, 30.0, 4e-3) - 3.255e-8_f64).abs() < 1e-11);
    let lvdt = Lvdt { reach: 30e-3, linearity: 2.5e-3 };
    let off = |x: f64| (lvdt.report(x) - x).abs() / 30e-3;
    let most = (-3000..=3000).map(|k| off(f64::from(k) * 1e-5)).fold(0.0, f64::max);
    assert!((most - 2.5e-3).abs() <= 1e-7, "{most}");
    assert!(off(0.0) == 0.0 && off(30e-3) <= 1e-15 && off(-30e-3) <= 1e-15);
    assert!((0..3000).all(|k| lvdt.report(f64::from(k + 1) * 1e-5) > lvdt.report(f64::from(k) * 1e-5)));
    // A switch: hysteresis, chatter only right after a change.
    let mut switch = Switch::new(1.0, 0.1, 5, 3);
    let mut tick = 0;
    let mut at = |place: f64| {
        tick += 10;
        let settled = switch.observe(tick, place);
        let later: Vec<bool> = (0..9).map(|k| switch.observe(tick + k, place)).collect();
        (settled, later)
    };
    assert_eq!(at(0.99).1, [false; 9]);
    assert_eq!(at(1.0).1[5..], [true; 4]);
    assert_eq!(at(0.95).1, [true; 9], "no change, no chatter");
    assert_eq!(at(0.85).1[5..], [false; 4]);
    let mut chattered = false;
    for seed in 0..20 {
        let mut switch = Switch::new(1.0, 0.1, 5, seed);
        chattered |= (1..6).any(|k| !switch.observe(k, 2.0));
        let mut closed = Switch::new(1.0, 0.1, 5, seed);
        assert!((0..9).all(|k| closed.observe(k, 2.0)), "closed from the start: nothing changes");
    }
    assert!(chattered);
    // A membrane: the step response of first order.
    let mut membrane = Membrane::new(20.0);
    assert_eq!(membrane.observe(0, 100.0), 100.0);
    // The step takes one tick, from 0 to 1, in which the pressure is linear; 3 ticks at a time say the same.
    let decay = |ticks: f64| (-ticks / 20.0_f64).exp();
    let first = 300.0 - 200.0 * 20.0 * (1.0 - decay(1.0));
    let mut rarely = membrane;
    for tick in 1..200_u64 {
        let exact = 300.0 + (first - 300.0) * decay(tick as f64 - 1.0);
        assert!((membrane.observe(tick, 300.0) - exact).abs() <= 1e-10, "{tick}");
        if tick % 3 == 1 {
            assert!((rarely.observe(tick, 300.0) - exact).abs() <= 1e-10, "{tick}");
        }
    }
    // A pressure that rises at a constant rate is felt `lag` later, whatever the step.
    for step in [1, 4, 20] {
        let mut membrane = Membrane::new(8.0);
        let felt = (0..=50).map(|k| membrane.observe(step * k, 3.0 * (step * k) as f64)).last();
        let t = (50 * step) as f64;
        let exact = 3.0 * (t - 8.0 + 8.0 * (-t / 8.0_f64).exp());
        assert!((felt.expect("a pressure") - exact).abs() <= 1e-10 * t, "{step}: {felt:?} for {exact}");
    }
}

#[test]
fn a_first_sample_is_shown_at_once_where_asked_for() {
    let channel = Channel { period: 10, delay: 25, ..EXACT };
    let sensor: Sensor<f64, 4> = Sensor::new(channel, 1, -1.0).expect("a channel");
    let mut sensor = sensor.showing_first();
    assert_eq!(sensor.reading(0), -1.0);
    for tick in 0..60 {
        sensor.observe(tick, 3.0 + tick as f64);
        // Samples of ticks 0, 10, 20 appear at 25, 35, 45.
        let wanted = if tick < 35 { 3.0 } else { 3.0 + ((tick - 25) / 10 * 10) as f64 };
        assert_eq!(sensor.reading(tick), wanted, "{tick}");
    }
}
