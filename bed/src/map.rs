//! Maps of pressure and shear over time.
//!
//! In: readings at sites, frame by frame. Out: a [`Recording`], checked once. Sites are the sensels of a sensor, which
//! are fixed, or points of the skin, which move over the bed; a [`Grid`] gives the positions of sensels.

use std::fmt;

/// Pascal per millimetre of mercury.
pub const MMHG: f64 = 133.322;

/// Sensels in rows (along y) and columns (along x), row by row, starting at the corner of least x and y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// Rows.
    pub rows: usize,
    /// Columns.
    pub columns: usize,
    /// Distance of rows (m).
    pub row_pitch: f64,
    /// Distance of columns (m).
    pub column_pitch: f64,
}

impl Grid {
    /// Number of sensels.
    #[must_use]
    pub fn sites(&self) -> usize {
        self.rows.saturating_mul(self.columns)
    }

    /// Area of a sensel (m^2).
    #[must_use]
    pub fn cell(&self) -> f64 {
        self.row_pitch * self.column_pitch
    }

    /// Centre of a sensel (m).
    #[must_use]
    pub fn middle(&self, site: usize) -> [f64; 2] {
        let (row, column) = (site / self.columns, site % self.columns);
        [(column as f64 + 0.5) * self.column_pitch, (row as f64 + 0.5) * self.row_pitch]
    }

    /// All sensels as sites, each with the area of a sensel and no region.
    #[must_use]
    pub fn all(&self) -> Vec<Site> {
        vec![Site { area: self.cell(), region: None }; self.sites()]
    }
}

/// Parts of the body where pressure ulcers begin.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Region {
    /// Back of the head.
    Occiput,
    /// Shoulder blades.
    Scapulae,
    /// Elbows.
    Elbows,
    /// Sacrum.
    Sacrum,
    /// Ischial tuberosities, the "seat bones".
    Ischia,
    /// Greater trochanters, at the sides of the hips.
    Trochanters,
    /// Heels.
    Heels,
}

impl Region {
    /// All regions, from head to foot.
    pub const ALL: [Region; 7] = [
        Region::Occiput,
        Region::Scapulae,
        Region::Elbows,
        Region::Sacrum,
        Region::Ischia,
        Region::Trochanters,
        Region::Heels,
    ];

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Region::Occiput => "occiput",
            Region::Scapulae => "scapulae",
            Region::Elbows => "elbows",
            Region::Sacrum => "sacrum",
            Region::Ischia => "ischia",
            Region::Trochanters => "trochanters",
            Region::Heels => "heels",
        }
    }
}

/// A sensel or a point of the skin at which pressure is recorded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Site {
    /// Its area (m^2).
    pub area: f64,
    /// The part of the body that lies there, if it is one of those watched.
    pub region: Option<Region>,
}

/// Readings of all sites at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Time of the readings (s).
    pub time: f64,
    /// Duration that the frame represents (s); may be 0 for the last frame.
    pub seconds: f64,
    /// Pressure at each site (Pa).
    pub pressure: Vec<f64>,
    /// Shear at each site (Pa), in two directions along the surface; empty if unknown.
    pub shear: Vec<[f64; 2]>,
}

/// Readings over time that have been checked.
#[derive(Clone, Debug, PartialEq)]
pub struct Recording {
    sites: Vec<Site>,
    frames: Vec<Frame>,
}

/// The reason why readings cannot be a recording.
#[derive(Clone, Debug, PartialEq)]
pub enum MapError {
    /// A site's area is not positive.
    Area {
        /// The site, from 0.
        site: usize,
        /// Its area (m^2).
        area: f64,
    },
    /// A frame does not have one value per site.
    Length {
        /// The frame, from 0.
        frame: usize,
        /// Values it has.
        found: usize,
        /// Sites there are.
        expected: usize,
    },
    /// A value is not a finite number, or a pressure is negative.
    Value {
        /// The frame, from 0.
        frame: usize,
        /// The site, from 0.
        site: usize,
    },
    /// A frame's time is not after the one before, or its duration is 0 although it is not the last.
    Time {
        /// The frame, from 0.
        frame: usize,
    },
}

impl fmt::Display for MapError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            MapError::Area { site, area } => write!(f, "site {site}: its area is {area} m^2, expected > 0"),
            MapError::Length { frame, found, expected } => {
                write!(f, "frame {frame}: {found} values, expected {expected}, one for each site")
            }
            MapError::Value { frame, site } => {
                write!(f, "frame {frame}, site {site}: expected finite numbers and a pressure >= 0")
            }
            MapError::Time { frame } => {
                write!(
                    f,
                    "frame {frame}: expected a time later than that of the frame before, and a duration > 0 (of the \
                     last frame >= 0)"
                )
            }
        }
    }
}

impl std::error::Error for MapError {}

impl Recording {
    /// Checks readings and makes a recording of them.
    ///
    /// # Errors
    /// [`MapError`], the first fault found.
    pub fn new(sites: Vec<Site>, frames: Vec<Frame>) -> Result<Recording, MapError> {
        let wrong = |area: f64| !(area > 0.0 && area.is_finite());
        if let Some((site, found)) = sites.iter().enumerate().find(|(_, s)| wrong(s.area)) {
            return Err(MapError::Area { site, area: found.area });
        }
        let mut before = f64::NEG_INFINITY;
        for (index, frame) in frames.iter().enumerate() {
            check(index, frame, sites.len())?;
            let follows = frame.time > before && frame.time.is_finite();
            let lasts = frame.seconds > 0.0 || frame.seconds == 0.0 && index + 1 == frames.len();
            if !(follows && lasts && frame.seconds.is_finite()) {
                return Err(MapError::Time { frame: index });
            }
            before = frame.time;
        }
        Ok(Recording { sites, frames })
    }

    /// The sites of the readings.
    #[must_use]
    pub fn sites(&self) -> &[Site] {
        &self.sites
    }

    /// The frames, in the order of time.
    #[must_use]
    pub fn frames(&self) -> &[Frame] {
        &self.frames
    }

    /// The recording restricted to some of the sites.
    #[must_use]
    pub fn select(&self, kept: &[usize]) -> Recording {
        let frame = |f: &Frame| Frame {
            time: f.time,
            seconds: f.seconds,
            pressure: kept.iter().map(|i| f.pressure[*i]).collect(),
            shear: if f.shear.is_empty() { Vec::new() } else { kept.iter().map(|i| f.shear[*i]).collect() },
        };
        let sites = kept.iter().map(|i| self.sites[*i]).collect();
        Recording { sites, frames: self.frames.iter().map(frame).collect() }
    }

    /// Sum of the durations of all frames (s).
    #[must_use]
    pub fn seconds(&self) -> f64 {
        self.frames.iter().map(|f| f.seconds).sum()
    }
}

/// Checks that a frame has one valid value per site.
fn check(index: usize, frame: &Frame, sites: usize) -> Result<(), MapError> {
    let short = |found: usize| MapError::Length { frame: index, found, expected: sites };
    if frame.pressure.len() != sites {
        return Err(short(frame.pressure.len()));
    }
    if !(frame.shear.is_empty() || frame.shear.len() == sites) {
        return Err(short(frame.shear.len()));
    }
    let sound = |p: &f64| p.is_finite() && *p >= 0.0;
    if let Some(site) = frame.pressure.iter().position(|p| !sound(p)) {
        return Err(MapError::Value { frame: index, site });
    }
    match frame.shear.iter().position(|s| !(s[0].is_finite() && s[1].is_finite())) {
        Some(site) => Err(MapError::Value { frame: index, site }),
        None => Ok(()),
    }
}
