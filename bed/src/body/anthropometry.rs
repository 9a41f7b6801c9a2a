//! Masses, mass centres and lengths of the segments of a body, from published tables.
//!
//! In: a table, mass and stature. Out: kg, m and shares for each [`Part`]. Masses: de Leva, J Biomech 29 (1996)
//! 1223-1230, for men and women; Winter 2009 after Dempster. Both sum to 1 within 1e-4 and are then normalised. Lengths
//! are de Leva's, for a man of 1.741 m and a woman of 1.735 m. Widths and depths of segments are estimates of ours.

/// Parts of the body; paired limbs are listed once.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Part {
    /// Head and neck.
    Head,
    /// Down to the end of the breastbone.
    UpperTrunk,
    /// From there down to the navel.
    MiddleTrunk,
    /// From there down to the hips.
    LowerTrunk,
    /// Shoulder to elbow.
    UpperArm,
    /// Elbow to wrist.
    Forearm,
    /// Wrist to knuckles.
    Hand,
    /// Hip to knee.
    Thigh,
    /// Knee to ankle.
    Shank,
    /// Heel to toes.
    Foot,
}

impl Part {
    /// All parts.
    pub const ALL: [Part; 10] = [
        Part::Head,
        Part::UpperTrunk,
        Part::MiddleTrunk,
        Part::LowerTrunk,
        Part::UpperArm,
        Part::Forearm,
        Part::Hand,
        Part::Thigh,
        Part::Shank,
        Part::Foot,
    ];

    /// How many of this part a body has.
    #[must_use]
    pub fn count(self) -> f64 {
        if self >= Part::UpperArm { 2.0 } else { 1.0 }
    }
}

/// A published table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Table {
    /// de Leva 1996, men.
    DeLevaMale,
    /// de Leva 1996, women.
    DeLevaFemale,
    /// Winter 2009 after Dempster.
    Winter,
}

impl Table {
    /// Mass of a part divided by that of the body, as printed; distance of its mass centre from the end nearer to the
    /// head, divided by its length.
    ///
    /// Winter's head ends at the ear, six tenths down; its trunk is divided differently, so that de Leva's shares are
    /// used there.
    #[must_use]
    pub fn printed(self, part: Part) -> (f64, f64) {
        let row = match part {
            Part::Head => [(0.0694, 0.5976), (0.0668, 0.5894), (0.081, 0.6)],
            Part::UpperTrunk => [(0.1596, 0.2999), (0.1545, 0.2077), (0.216, 0.2999)],
            Part::MiddleTrunk => [(0.1633, 0.4502), (0.1465, 0.4512), (0.139, 0.4502)],
            Part::LowerTrunk => [(0.1117, 0.6115), (0.1247, 0.492), (0.142, 0.6115)],
            Part::UpperArm => [(0.0271, 0.5772), (0.0255, 0.5754), (0.028, 0.436)],
            Part::Forearm => [(0.0162, 0.4574), (0.0138, 0.4559), (0.016, 0.43)],
            Part::Hand => [(0.0061, 0.79), (0.0056, 0.7474), (0.006, 0.506)],
            Part::Thigh => [(0.1416, 0.4095), (0.1478, 0.3612), (0.1, 0.433)],
            Part::Shank => [(0.0433, 0.4395), (0.0481, 0.4352), (0.0465, 0.433)],
            Part::Foot => [(0.0137, 0.4415), (0.0129, 0.4014), (0.0145, 0.5)],
        };
        row[self as usize]
    }

    /// Sum of all printed masses.
    #[must_use]
    pub fn sum(self) -> f64 {
        Part::ALL.into_iter().map(|part| part.count() * self.printed(part).0).sum()
    }

    /// Share of the body's mass, normalised so that all sum to 1.
    #[must_use]
    pub fn share(self, part: Part) -> f64 {
        self.printed(part).0 / self.sum()
    }

    /// Stature (m) of the body for which the lengths were measured.
    fn stature(self) -> f64 {
        if self == Table::DeLevaFemale { 1.735 } else { 1.741 }
    }

    /// Length (m) of a part of a body of this stature (m).
    #[must_use]
    pub fn length(self, part: Part, stature: f64) -> f64 {
        let [male, female] = match part {
            Part::Head => [0.2429, 0.2437],
            Part::UpperTrunk => [0.2421, 0.2280],
            Part::MiddleTrunk => [0.2155, 0.2053],
            Part::LowerTrunk => [0.1457, 0.1815],
            Part::UpperArm => [0.2817, 0.2751],
            Part::Forearm => [0.2689, 0.2643],
            Part::Hand => [0.0862, 0.0780],
            Part::Thigh => [0.4222, 0.3685],
            Part::Shank => [0.4340, 0.4323],
            Part::Foot => [0.2581, 0.2283],
        };
        let length = if self == Table::DeLevaFemale { female } else { male };
        length * stature / self.stature()
    }
}
