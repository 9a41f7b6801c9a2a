//! What can break of a simulated tile, and the names and numbers by which a host asks for it.

/// What can break. Legs are numbered from 0.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Defect {
    /// A drive gives this duty whatever it is told; ENABLE still cuts it.
    Motor(u8, f32),
    /// A drive gives nothing.
    MotorDead(u8),
    /// ENABLE does not cut.
    Enable,
    /// A valve stands open: of the pump, or the vent.
    ValveOpen {
        /// The vent?
        vent: bool,
    },
    /// A valve stays shut.
    ValveShut {
        /// The vent?
        vent: bool,
    },
    /// An encoder counts no further.
    EncoderStuck(u8),
    /// An encoder counts so much too much each millisecond.
    EncoderDrift(u8, i32),
    /// A displacement sensor stays where it is.
    DisplacementStuck(u8),
    /// The wire of a displacement sensor is broken.
    DisplacementOpen(u8),
    /// A switch's circuit is open: the lower one, or the upper.
    SwitchOpen {
        /// Its leg.
        leg: u8,
        /// The upper one?
        high: bool,
    },
    /// A pressure sensor shows so many times the pressure.
    PressureBias(u8, f32),
    /// The supply falls to this (V).
    Supply(f32),
    /// Something stops this leg at this height (m), from above or, going down, from below.
    Block {
        /// Its leg.
        leg: u8,
        /// Where it begins (m).
        height: f32,
        /// Is it above?
        above: bool,
    },
}

/// Defects that a session may ask for: name and defect, by number; 0 mends all.
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
