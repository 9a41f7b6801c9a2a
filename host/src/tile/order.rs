//! Parses orders.

use crate::failure::Failure;
use smartbed_codegen::model::unit;
use smartbed_firmware::defect::NAMED;
use smartbed_firmware::link::message::{Command, Target};

/// An order.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Order {
    /// Send a command, and continue when its motion, if any, has ended.
    Send(Command),
    /// Send a command, and continue at once: written with `&` after it.
    Begin(Command),
    /// Run for this time (ms).
    Wait(u32),
    /// Send the following commands to this tile.
    Tile(u8),
    /// Cause this defect of the tile.
    Break(u8),
}

/// Parses orders separated by `;`.
///
/// # Errors
/// The invalid order, and what was expected.
pub fn read(text: &str) -> Result<Vec<Order>, Failure> {
    text.split(';').map(str::trim).filter(|words| !words.is_empty()).map(one).collect()
}

/// The word that orders a command.
#[must_use]
pub fn word(command: &Command) -> &'static str {
    match command {
        Command::Stop => "stop",
        Command::Status => "status",
        Command::Log(_) => "log",
        Command::Identify => "identify",
        Command::Beat(_) => "beat",
        Command::Enable => "enable",
        Command::Clear(_) => "clear",
        Command::Home => "home",
        Command::Move(_) => "move",
        Command::Pressure(_) => "inflate",
        Command::Flatten => "flatten",
        Command::Calibrate(_) => "calibrate",
    }
}

fn one(text: &str) -> Result<Order, Failure> {
    if let Some(order) = text.strip_suffix('&') {
        return match one(order)? {
            Order::Send(command) => Ok(Order::Begin(command)),
            _ => {
                Err(Failure::Wrong(format!("`{text}`: expected a command before `&`, for example `home &`")))
            }
        };
    }
    let words: Vec<&str> = text.split_whitespace().collect();
    let wrong = |expected: &str| Failure::Wrong(format!("`{text}`: expected {expected}"));
    let command = |command: Command| Ok(Order::Send(command));
    match words[..] {
        ["enable"] => command(Command::Enable),
        ["home"] => command(Command::Home),
        ["flatten"] => command(Command::Flatten),
        ["stop"] => command(Command::Stop),
        ["clear"] => command(Command::Clear(u32::MAX)),
        ["status"] => command(Command::Status),
        ["log"] => command(Command::Log(0)),
        ["identify"] => command(Command::Identify),
        ["move", heave] => Ok(Order::Send(Command::Move(target(heave, "0_deg", "0_deg")?))),
        ["move", heave, x, y] => Ok(Order::Send(Command::Move(target(heave, x, y)?))),
        ["move", ..] => {
            Err(wrong("`move HEAVE` or `move HEAVE TILT_X TILT_Y`, for example `move 5_mm 2_deg 0_deg`"))
        }
        ["inflate", pressure] => {
            command(Command::Pressure(quantity(pressure, &["kPa", "Pa", "mmHg"])? as f32))
        }
        ["inflate", ..] => Err(wrong("`inflate PRESSURE`, for example `inflate 4_kPa`")),
        ["wait", time] => {
            let seconds = quantity(time, &["s", "ms"])?;
            if !(0.0..=86_400.0).contains(&seconds) {
                return Err(wrong("a time up to a day"));
            }
            Ok(Order::Wait((seconds * 1e3).round() as u32))
        }
        ["tile", number] => number.parse().map(Order::Tile).map_err(|_| wrong("`tile N`, a number from 0")),
        ["break", name] => {
            let place = NAMED.iter().position(|(defect, _)| *defect == name);
            let number = place
                .ok_or_else(|| wrong(&format!("`break` and one of {}", NAMED.map(|(n, _)| n).join(", "))))?;
            Ok(Order::Break(number as u8))
        }
        _ => Err(wrong(
            "enable, home, move, inflate, flatten, stop, clear, status, log, identify, wait, tile or break; see --help",
        )),
    }
}

/// Tilts have slopes below this (rad).
const STEEPEST: f64 = std::f64::consts::FRAC_PI_2;

fn target(heave: &str, x: &str, y: &str) -> Result<Target, Failure> {
    let slope = |text: &str| match quantity(text, &["deg", "rad"])? {
        angle if angle.abs() < STEEPEST => Ok(angle.tan() as f32),
        _ => Err(Failure::Wrong(format!("`{text}`: expected a tilt below 90 degrees; a tile allows 15"))),
    };
    Ok(Target { heave: quantity(heave, &["mm", "m"])? as f32, slope_x: slope(x)?, slope_y: slope(y)? })
}

/// A number with one of these units, `5_mm` or `5mm`, in SI units.
fn quantity(text: &str, units: &[&str]) -> Result<f64, Failure> {
    let number = text.trim_end_matches(|c: char| c.is_ascii_alphabetic());
    let (number, unit) = (number.trim_end_matches('_'), &text[number.len()..]);
    let factor = unit::named(unit).filter(|_| units.contains(&unit)).map(|scale| scale.factor);
    match (number.parse::<f64>(), factor) {
        (Ok(number), Some(factor)) => Ok(number * factor),
        _ => Err(Failure::Wrong(format!(
            "`{text}`: expected a number with a unit of {}, for example 5_{}",
            units.join(", "),
            units[0]
        ))),
    }
}

#[cfg(test)]
mod tests {
    use super::{Order, read};
    use smartbed_firmware::link::message::{Command, Target};

    #[test]
    fn orders_are_read() {
        let orders = read(
            "enable; home &; move 5_mm 45_deg 0deg;; wait 1.5_s; inflate 30_mmHg; tile 2; break lvdt-stuck",
        )
        .unwrap();
        let target = Target { heave: 0.005, slope_x: 1.0, slope_y: 0.0 };
        assert_eq!(
            orders,
            [
                Order::Send(Command::Enable),
                Order::Begin(Command::Home),
                Order::Send(Command::Move(target)),
                Order::Wait(1500),
                Order::Send(Command::Pressure(3999.66)),
                Order::Tile(2),
                Order::Break(10),
            ]
        );
    }

    #[test]
    fn what_is_none_says_what_was_expected() {
        for (text, expected) in [
            ("fly", "see --help"),
            ("move 5", "5_mm"),
            ("move 5_deg", "unit of mm, m"),
            ("wait -1_s", "up to a day"),
            ("break wind", "motor-on"),
            ("move 0_mm 185_deg 0_deg", "a tilt below 90 degrees"),
            ("move 0_mm 0_deg -3.2_rad", "a tilt below 90 degrees"),
            ("wait 1_s &", "a command before `&`"),
            ("tile x", "a number from 0"),
        ] {
            let message = read(text).unwrap_err().to_string();
            assert!(message.contains(expected), "{text}: {message}");
        }
    }
}
