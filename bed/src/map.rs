//! Maps of pressure and shear over time.
//!
//! In: readings at sites, frame by frame. Out: a [`Recording`], checked once. Sites are the sensels of a sensor, which
//! stay where they are, or points of the skin, which move over the bed; a [`Grid`] says where sensels lie.

use std::fmt;

/// Pascal per millimetre of mercury.
pub const MMHG: f64 = 133.322;

/// Sensels in rows (along y) and columns (along x), row by row from the corner of least x and y.
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
    /// Sensels.
    #[must_use]
    pub fn sites(&self) -> usize {
        self.rows.saturating_mul(self.columns)
    }

    /// Area of a sensel (m^2).
    #[must_use]
    pub fn cell(&self) -> f64 {
        self.row_pitch * self.column_pitch
    }

    /// Middle of a sensel (m).
    #[must_use]
    pub fn middle(&self, site: usize) -> [f64; 2] {
        let (row, column) = (site / self.columns, site % self.columns);
        [(column as f64 + 0.5) * self.column_pitch, (row as f64 + 0.5) * self.row_pitch]
    }

    /// All sites with the area of a sensel, none in a region.
    #[must_use]
    pub fn all(&self) -> Vec<Site> {
        vec![Site { area: self.cell(), region: None }; self.sites()]
    }
}

/// Parts of the body at which ulcers begin.
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
    /// Seat bones.
    Ischia,
    /// Sides of the hips.
    Trochanters,
    /// Heels.
    Heels,
}

impl Region {
    /// All of them, from head to foot.
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

/// A place that is watched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Site {
    /// Its area (m^2).
    pub area: f64,
    /// What of the body lies there.
    pub region: Option<Region>,
}

/// What was read at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// When (s).
    pub time: f64,
    /// How long the frame stands for (s); 0 for the last, if it is an end.
    pub seconds: f64,
    /// Pressure at each site (Pa).
    pub pressure: Vec<f64>,
    /// Shear at each site (Pa), two directions in the surface; empty where it is not known.
    pub shear: Vec<[f64; 2]>,
}

/// Readings over time, checked.
#[derive(Clone, Debug, PartialEq)]
pub struct Recording {
    sites: Vec<Site>,
    frames: Vec<Frame>,
}

/// Why readings are no recording.
#[derive(Clone, Debug, PartialEq)]
pub enum MapError {
    /// A site's area is not positive.
    Area {
        /// The site, from 0.
        site: usize,
        /// Its area (m^2).
        area: f64,
    },
    /// A frame has not one value a site.
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
    /// A frame's time does not lie behind the one before, or it stands for no time and is not the last.
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
                write!(f, "frame {frame}: {found} values, expected {expected}, one a site")
            }
            MapError::Value { frame, site } => {
                write!(f, "frame {frame}, site {site}: expected finite numbers and a pressure >= 0")
            }
            MapError::Time { frame } => {
                write!(
                    f,
                    "frame {frame}: its time must lie behind that of the frame before, its duration be > 0, of the last >= 0"
                )
            }
        }
    }
}

impl std::error::Error for MapError {}

impl Recording {
    /// Checks readings.
    ///
    /// # Errors
    /// [`MapError`], the first that is wrong.
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

    /// Places that are watched.
    #[must_use]
    pub fn sites(&self) -> &[Site] {
        &self.sites
    }

    /// What was read, in the order of time.
    #[must_use]
    pub fn frames(&self) -> &[Frame] {
        &self.frames
    }

    /// The same of some sites only.
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

    /// Time that all frames stand for (s).
    #[must_use]
    pub fn seconds(&self) -> f64 {
        self.frames.iter().map(|f| f.seconds).sum()
    }
}

/// Has a frame one sound value a site?
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
