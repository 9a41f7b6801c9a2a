//! Defects of a simulated tile, with the names and numbers by which a host requests them.

/// A defect of the simulated tile. Legs are numbered from 0.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Defect {
    /// A drive gives this duty whatever its command; ENABLE still cuts it.
    Motor(u8, f32),
    /// A drive gives nothing.
    MotorDead(u8),
    /// ENABLE does not cut the power.
    Enable,
    /// A valve is stuck open: that of the pump, or the vent.
    ValveOpen {
        /// Whether it is the vent.
        vent: bool,
    },
    /// A valve is stuck shut.
    ValveShut {
        /// Whether it is the vent.
        vent: bool,
    },
    /// An encoder has stopped counting.
    EncoderStuck(u8),
    /// An encoder counts this much too much each millisecond.
    EncoderDrift(u8, i32),
    /// A displacement sensor keeps its last reading.
    DisplacementStuck(u8),
    /// The wire of a displacement sensor is broken.
    DisplacementOpen(u8),
    /// The circuit of an end switch is open: the lower one, or the upper.
    SwitchOpen {
        /// Its leg.
        leg: u8,
        /// Whether it is the upper one.
        high: bool,
    },
    /// A pressure sensor shows the pressure times this factor.
    PressureBias(u8, f32),
    /// The supply falls to this voltage (V).
    Supply(f32),
    /// An obstacle stops this leg at this height (m): above a rising leg, or below a falling one.
    Block {
        /// Its leg.
        leg: u8,
        /// Height of the obstacle (m).
        height: f32,
        /// Whether it is above the leg.
        above: bool,
    },
}

/// Defects that a session may request, by number: name and defect; 0 repairs all.
pub const NAMED: [(&str, Option<Defect>); 15] = [
    ("none", None),
    ("motor-on", Some(Defect::Motor(0, 1.0))),
    ("motor-dead", Some(Defect::MotorDead(1))),
    ("enable", Some(Defect::Enable)),
    ("supply-open", Some(Defect::ValveOpen { vent: false })),
    ("vent-open", Some(Defect::ValveOpen { vent: true })),
    ("supply-shut", Some(Defect::ValveShut { vent: false })),
    ("vent-shut", Some(Defect::ValveShut { vent: true })),
    ("encoder-stuck", Some(Defect::EncoderStuck(1))),
    ("encoder-drift", Some(Defect::EncoderDrift(2, 5))),
    ("lvdt-stuck", Some(Defect::DisplacementStuck(0))),
    ("lvdt-open", Some(Defect::DisplacementOpen(0))),
    ("switch-open", Some(Defect::SwitchOpen { leg: 2, high: true })),
    ("pressure-bias", Some(Defect::PressureBias(0, 1.2))),
    ("block", Some(Defect::Block { leg: 1, height: 0.0, above: true })),
];
