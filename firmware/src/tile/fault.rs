//! Faults: meaning, response of the tile, and whether each can be cleared.
//!
//! In: the conditions found in this tick, one bit each. Out: the latched faults, and the strongest response to them.
//! A fault stays latched until it is cleared explicitly, and it cannot be cleared while its cause is present.

/// Response of the tile to a fault, weakest first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Response {
    /// Drives off, the self-locking screws hold the pose; the bladder is kept at its pressure.
    Hold,
    /// Back by 5 mm along the motion, then [`Response::Hold`].
    Retreat,
    /// Drives off and valves closed within this tick.
    Off,
}

/// Defines the list of faults, so that number, name and response are in one place.
macro_rules! faults {
    ($($(#[doc = $doc:literal])+ $name:ident: $response:ident, $clear:literal;)+) => {
        /// What can be wrong with a tile. Its number is its bit.
        #[derive(Clone, Copy, PartialEq, Eq, Debug)]
        #[repr(u8)]
        pub enum Fault { $($(#[doc = $doc])+ $name,)+ }

        impl Fault {
            /// All, by number.
            pub const ALL: [Self; [$($clear),+].len()] = [$(Self::$name),+];

            /// Its name.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self { $(Self::$name => stringify!($name),)+ }
            }
        }

        impl Faults {
            /// All that need a new start.
            const LASTING: Self = Self(0 $(| (!$clear as u32) << Fault::$name as u8)+);

            /// All with this response.
            const fn answered_by(response: Response) -> Self {
                Self(0 $(| ((Response::$response as u8 == response as u8) as u32) << Fault::$name as u8)+)
            }
        }
    };
}

faults! {
    /// Encoder and displacement sensor of a leg disagree.
    Height: Off, true;
    /// A displacement sensor is at a rail: broken wire or short.
    DisplacementRange: Off, true;
    /// A leg ran into an end switch.
    Switch: Off, true;
    /// An end switch is pressed, or is not, where the height says otherwise; a broken wire counts as pressed.
    SwitchPlace: Off, true;
    /// A leg stays behind its command, or pushes harder than its load explains.
    Obstruction: Retreat, true;
    /// A leg moves without or ahead of its command.
    Runaway: Off, true;
    /// A drive reports a fault.
    Drive: Off, true;
    /// A current is out of range, or flows although drives are disabled.
    Current: Off, true;
    /// ENABLE did not cut the power at start.
    EnableTest: Off, false;
    /// The supply is too low or too high.
    Supply: Off, true;
    /// The platform is steeper, or turns faster, than any command allows.
    Tilt: Off, true;
    /// The two pressures disagree.
    Pressure: Off, true;
    /// A pressure is at a rail.
    PressureRange: Off, true;
    /// More pressure than the bladder may have: it is vented too.
    Overpressure: Off, true;
    /// The pressure changes although both valves are closed.
    ValveOpen: Off, true;
    /// The pressure does not follow its valve.
    ValveShut: Hold, true;
    /// The bladder carries more than the working load.
    Overload: Hold, true;
    /// Nobody who may move the tile has spoken for too long during a motion.
    Silence: Hold, true;
    /// The tile's clock and the supervisor's run apart.
    Clock: Hold, true;
    /// The legs did not come to rest at their command.
    Settling: Hold, true;
    /// A tick took too long, or a task did not report.
    Overrun: Off, true;
    /// A value that safety rests on differs from its copy.
    Memory: Off, false;
    /// Calibration or boot counter could not be read or stored.
    Storage: Off, false;
    /// A computed value is not finite.
    NonFinite: Off, true;
    /// The program differs from the checksum that it was built with.
    Program: Off, false;
}

/// A set of faults.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Faults(u32);

impl Faults {
    /// The set of these bits; bits that are no fault are dropped.
    #[must_use]
    pub const fn from_bits(bits: u32) -> Self {
        Self(bits & ((1 << Fault::ALL.len()) - 1))
    }

    /// Names of its faults, in the order of [`Fault::ALL`].
    pub fn names(self) -> impl Iterator<Item = &'static str> {
        Fault::ALL.into_iter().filter(move |fault| self.has(*fault)).map(Fault::name)
    }

    /// Its bits.
    #[must_use]
    pub const fn bits(self) -> u32 {
        self.0
    }

    /// Adds a fault if `is_there` holds.
    pub fn set(&mut self, fault: Fault, is_there: bool) {
        self.0 |= u32::from(is_there) << fault as u8;
    }

    /// Whether the fault is in the set.
    #[must_use]
    pub const fn has(self, fault: Fault) -> bool {
        self.0 >> fault as u8 & 1 == 1
    }

    /// Whether the set is empty.
    #[must_use]
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// Union of both sets.
    #[must_use]
    pub const fn with(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Faults of this set that are not in the other.
    #[must_use]
    pub const fn without(self, other: Self) -> Self {
        Self(self.0 & !other.0)
    }

    /// Faults of this set that stop a tile on its way down for resuscitation. A bladder that carries much, or whose
    /// vent does not open, is no reason to leave it half-way.
    #[must_use]
    pub fn against_lowering(self) -> Self {
        const BEARABLE: Faults = Faults(1 << Fault::ValveShut as u8 | 1 << Fault::Overload as u8);
        self.without(BEARABLE)
    }

    /// The strongest response to any fault of the set.
    #[must_use]
    pub fn response(self) -> Option<Response> {
        const SETS: [(Response, Faults); 3] = [
            (Response::Off, Faults::answered_by(Response::Off)),
            (Response::Retreat, Faults::answered_by(Response::Retreat)),
            (Response::Hold, Faults::answered_by(Response::Hold)),
        ];
        let found = SETS.iter().find(|(_, faults)| self.0 & faults.0 != 0);
        found.map(|(response, _)| *response)
    }
}

/// Latched faults.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Latch {
    latched: Faults,
    active: Faults,
}

impl Latch {
    /// Takes the faults of this tick; returns the new ones. While something moves a latched fault whose cause comes
    /// back is new, too: resuscitation is allowed despite faults, and must end at the next obstacle all the same.
    pub fn take(&mut self, active: Faults, is_moving: bool) -> Faults {
        let new = active.without(if is_moving { self.active } else { self.latched });
        self.active = active;
        self.latched = self.latched.with(active);
        new
    }

    /// Clears those of these that are latched; returns false and clears nothing if the cause of one is present or one
    /// cannot be cleared.
    pub fn clear(&mut self, faults: Faults) -> bool {
        if faults.0 & self.latched.0 & self.active.with(Faults::LASTING).0 != 0 {
            return false;
        }
        self.latched = self.latched.without(faults);
        true
    }

    /// The latched faults.
    #[must_use]
    pub fn latched(&self) -> Faults {
        self.latched
    }
}

#[cfg(test)]
mod tests {
    use super::{Fault, Faults, Latch, Response};

    fn set(faults: &[Fault]) -> Faults {
        let mut set = Faults::default();
        faults.iter().for_each(|f| set.set(*f, true));
        set
    }

    #[test]
    fn the_strongest_response_counts() {
        assert_eq!(set(&[]).response(), None);
        assert_eq!(set(&[Fault::Silence]).response(), Some(Response::Hold));
        assert_eq!(set(&[Fault::Silence, Fault::Obstruction]).response(), Some(Response::Retreat));
        assert_eq!(set(&[Fault::Runaway, Fault::Obstruction]).response(), Some(Response::Off));
    }

    #[test]
    fn a_fault_stays_until_its_cause_is_gone_and_it_is_cleared() {
        let mut latch = Latch::default();
        assert_eq!(latch.take(set(&[Fault::Supply]), false), set(&[Fault::Supply]));
        assert!(!latch.clear(set(&[Fault::Supply])), "its cause is there");
        assert_eq!(latch.take(Faults::default(), false), Faults::default());
        assert!(latch.latched().has(Fault::Supply), "it is latched");
        assert!(latch.clear(set(&[Fault::Supply])));
        assert!(latch.latched().is_empty());
    }

    #[test]
    fn a_cause_that_comes_back_during_a_motion_is_new() {
        let (mut latch, silence) = (Latch::default(), set(&[Fault::Silence]));
        let mut take = |active, is_moving| latch.take(active, is_moving);
        assert_eq!([take(silence, true), take(silence, true)], [silence, Faults::default()]);
        // At rest it is told once; a motion that begins with it goes on, and ends when it comes anew.
        assert_eq!([take(Faults::default(), false), take(silence, false)], [Faults::default(); 2]);
        assert_eq!(take(silence, true), Faults::default());
        assert_eq!([take(Faults::default(), true), take(silence, true)], [Faults::default(), silence]);
    }

    #[test]
    fn some_faults_need_a_new_start() {
        let mut latch = Latch::default();
        latch.take(set(&[Fault::Memory, Fault::Supply]), false);
        latch.take(Faults::default(), false);
        assert!(!latch.clear(set(&[Fault::Memory, Fault::Supply])));
        assert_eq!(latch.latched(), set(&[Fault::Memory, Fault::Supply]), "nothing is cleared by half");
        // Of all faults only those that are latched are meant.
        let mut latch = Latch::default();
        latch.take(set(&[Fault::Silence]), false);
        latch.take(Faults::default(), false);
        assert!(latch.clear(Faults::from_bits(u32::MAX)) && latch.latched().is_empty());
    }

    #[test]
    fn every_fault_has_a_bit_and_a_name_of_its_own() {
        for (number, fault) in Fault::ALL.into_iter().enumerate() {
            assert_eq!(set(&[fault]).bits(), 1 << number, "{}", fault.name());
        }
        assert_eq!(Faults::from_bits(u32::MAX).bits().count_ones() as usize, Fault::ALL.len());
    }
}
