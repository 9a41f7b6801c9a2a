//! Energy accounts of each part and of each seam, as rows show them.
//!
//! In: what an engine has booked. Out: columns and their values; each part and each seam closes by itself:
//! ```text
//! part   total - start + damping + drag + impact - actuator - seams = imbalance
//! seam   spring - start + to one + to the other + impact + friction        = imbalance
//! ```
//! A seam is an attachment, `bladder@tile.platform`, or a pair of contacts, `ball-bladder`. Sums over all parts and
//! seams are the accounts of the world.

/// Energies and accounts of a part (J).
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Part {
    /// Its name.
    pub name: String,
    /// Kinetic, of weight, of springs, of gas.
    pub stored: [f64; 4],
    /// Dissipated by its dampers.
    pub damping: f64,
    /// Dissipated by the drag of the air.
    pub drag: f64,
    /// Lost inside it in impacts; negative where energy compensation gives energy back along its springs.
    pub impact: f64,
    /// Work of its drives and actuators, and of flow of gas.
    pub actuator: f64,
    /// Work of its seams on it.
    pub seams: f64,
}

/// What has passed through a seam (J).
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Passed {
    /// Work on each side.
    pub to: [f64; 2],
    /// Lost in impacts, and what force laws take.
    pub impact: f64,
    /// Dissipated by friction.
    pub friction: f64,
    /// Stored in overlaps by force laws.
    pub spring: f64,
}

/// A seam of two parts.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Seam {
    /// Its name.
    pub name: String,
    /// The parts on both sides.
    pub parts: [String; 2],
    /// What has passed through it.
    pub passed: Passed,
}

/// Accounts of all parts that move and of all seams.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Accounts {
    /// Parts in the scene's order.
    pub parts: Vec<Part>,
    /// Attachments, then pairs of contacts.
    pub seams: Vec<Seam>,
}

impl Part {
    /// Stored energy.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.stored.iter().sum()
    }

    /// What no account explains since the start, when the stored energy was `start`.
    #[must_use]
    pub fn imbalance(&self, start: f64) -> f64 {
        self.total() - start + self.damping + self.drag + self.impact - self.actuator - self.seams
    }
}

impl Passed {
    /// What no account explains since the start, when `start` was stored.
    #[must_use]
    pub fn imbalance(&self, start: f64) -> f64 {
        self.spring - start + self.to[0] + self.to[1] + self.impact + self.friction
    }
}

impl Seam {
    /// Of a pair of contacts.
    #[must_use]
    pub fn of_pair(parts: [String; 2], passed: Passed) -> Seam {
        Seam { name: parts.join("-"), parts, passed }
    }
}

/// The message for accounts that were not asked for in time.
#[must_use]
pub fn not_kept() -> String {
    "the accounts of parts and seams were not kept from the start".to_owned()
}

impl Accounts {
    /// Stored energy of each part, then of each seam.
    #[must_use]
    pub fn totals(&self) -> Vec<f64> {
        self.parts.iter().map(Part::total).chain(self.seams.iter().map(|seam| seam.passed.spring)).collect()
    }

    /// Names and values of all columns, given the stored energy of each part and seam at the start.
    #[must_use]
    pub fn columns(&self, start: &[f64]) -> Vec<(String, f64)> {
        let mut columns = Vec::new();
        for (part, start) in self.parts.iter().zip(start) {
            let [kinetic, gravity, spring, pressure] = part.stored;
            let own = [
                ("kinetic", kinetic),
                ("gravity", gravity),
                ("spring", spring),
                ("pressure", pressure),
                ("damping", part.damping),
                ("drag", part.drag),
                ("impact", part.impact),
                ("actuator", part.actuator),
                ("seams", part.seams),
                ("total", part.total()),
                ("imbalance", part.imbalance(*start)),
            ];
            columns.extend(own.map(|(account, value)| (format!("{}.{account}", part.name), value)));
        }
        for (seam, start) in self.seams.iter().zip(&start[self.parts.len()..]) {
            let Seam { parts: [one, other], passed, .. } = seam;
            let own = [
                (format!("to_{one}"), passed.to[0]),
                (format!("to_{other}"), passed.to[1]),
                ("impact".to_owned(), passed.impact),
                ("friction".to_owned(), passed.friction),
                ("spring".to_owned(), passed.spring),
                ("imbalance".to_owned(), passed.imbalance(*start)),
            ];
            columns.extend(own.map(|(account, value)| (format!("{}.{account}", seam.name), value)));
        }
        columns
    }

    /// The part or seam with the largest imbalance, and that imbalance.
    #[must_use]
    pub fn worst(&self, start: &[f64]) -> Option<(&str, f64)> {
        let parts =
            self.parts.iter().zip(start).map(|(part, start)| (part.name.as_str(), part.imbalance(*start)));
        let seams = self.seams.iter().zip(&start[self.parts.len()..]);
        let seams = seams.map(|(seam, start)| (seam.name.as_str(), seam.passed.imbalance(*start)));
        parts.chain(seams).max_by(|(_, a), (_, b)| a.abs().total_cmp(&b.abs()))
    }
}
