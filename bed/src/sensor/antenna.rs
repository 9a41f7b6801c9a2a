//! Resonances of a rectangular patch over a slotted ground plane, and of a loop near a reflector.
//!
//! In: dimensions, the cover of the patch, the overlap of a slot with it, the gap of the loop. Out: frequencies (Hz).
//! Patch: C. A. Balanis, Antenna Theory, sec. 14.2.1 (fringing: E. Hammerstad 1975). Slot: perturbation of a cavity's
//! wall, D. M. Pozar, Microwave Engineering, sec. 6.7. Loop: F. W. Grover 1946; coaxial loops: J. C. Maxwell, Treatise,
//! art. 701.

use std::f64::consts::PI;

/// Speed of light (m/s).
const LIGHT: f64 = 299_792_458.0;
/// Permeability of the vacuum (H/m).
const MU_0: f64 = 4e-7 * PI;

/// Direction of the current in a patch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// TM10: along its length, x.
    Along,
    /// TM01: along its width, y.
    Across,
}

/// A microstrip patch; its ground plane has two blind slots in the middle, one across each current.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Patch {
    /// Length and width (m).
    pub sides: [f64; 2],
    /// Thickness of the substrate (m).
    pub height: f64,
    /// Relative permittivity of the substrate.
    pub permittivity: f64,
    /// Width and depth of a slot (m).
    pub slot: [f64; 2],
}

impl Patch {
    /// The side along the current, and the other one.
    fn sides(&self, mode: Mode) -> [f64; 2] {
        let [length, width] = self.sides;
        if mode == Mode::Along { [length, width] } else { [width, length] }
    }

    /// Resonance (Hz) under a cover of this relative permittivity, with this length of a slot (m) below the patch: c/(2
    /// (L + 2 dL) sqrt(e)), lowered by the slot.
    #[must_use]
    pub fn resonance(&self, mode: Mode, cover: f64, overlap: f64) -> f64 {
        let [length, width] = self.sides(mode);
        let h = self.height;
        // Share of the field in the substrate: for air above, q e_r + 1 - q is Hammerstad's effective permittivity.
        let filled = 0.5 * (1.0 + (1.0 + 12.0 * h / width).powf(-0.5));
        let e = filled * self.permittivity + (1.0 - filled) * cover;
        let fringe = 0.412 * h * (e + 0.3) * (width / h + 0.264) / ((e - 0.258) * (width / h + 0.8));
        LIGHT / (2.0 * (length + 2.0 * fringe) * e.sqrt()) * (1.0 - self.lowered(mode, overlap))
    }

    /// Relative decrease of the resonance by a slot in the middle: dw/w = integral of (mu H^2 - e E^2) over the volume
    /// that the cavity gains, divided by the integral of the sum over the whole cavity; with E ~ cos(pi x/L), H ~
    /// sin(pi x/L) it is t l sin(pi w/L)/(pi W h).
    fn lowered(&self, mode: Mode, overlap: f64) -> f64 {
        let ([length, width], [gap, depth]) = (self.sides(mode), self.slot);
        depth * overlap * (PI * gap / length).sin() / (PI * width * self.height)
    }

    /// The patch with its sides changed such that its modes resonate at these frequencies (Hz) under a cover and
    /// overlap.
    #[must_use]
    pub fn tuned(mut self, frequencies: [f64; 2], cover: f64, overlap: f64) -> Patch {
        // A side acts on its own mode almost as 1/f and hardly on the other, so that the iteration contracts.
        for _ in 0..60 {
            let found = [Mode::Along, Mode::Across].map(|mode| self.resonance(mode, cover, overlap));
            self.sides = [0, 1].map(|k| self.sides[k] * found[k] / frequencies[k]);
        }
        self
    }
}

/// A round loop with a capacitor, parallel to a reflector.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Loop {
    /// Radius (m).
    pub radius: f64,
    /// Radius of its wire (m).
    pub wire: f64,
    /// Capacitance (F).
    pub capacitance: f64,
}

impl Loop {
    /// Inductance (H) at a gap (m) from the reflector: mu_0 a (ln(8 a/b) - 2) minus the mutual one to its image, at
    /// twice the gap.
    #[must_use]
    pub fn inductance(&self, gap: f64) -> f64 {
        let (a, b) = (self.radius, self.wire);
        MU_0 * a * ((8.0 * a / b).ln() - 2.0) - mutual(a, 2.0 * gap)
    }

    /// Resonance (Hz): 1/(2 pi sqrt(L C)).
    #[must_use]
    pub fn resonance(&self, gap: f64) -> f64 {
        1.0 / (2.0 * PI * (self.inductance(gap) * self.capacitance).sqrt())
    }
}

/// Mutual inductance (H) of two coaxial loops of one radius (m) at a distance (m): mu_0 a ((2/k - k) K - 2/k E), with
/// k^2 = 4 a^2/(4 a^2 + d^2).
#[must_use]
pub fn mutual(radius: f64, distance: f64) -> f64 {
    let k = 2.0 * radius / (2.0 * radius).hypot(distance);
    let (first, second) = elliptic(k);
    MU_0 * radius * ((2.0 / k - k) * first - 2.0 / k * second)
}

/// Complete elliptic integrals K and E of modulus k, 0 <= k < 1, by the arithmetic-geometric mean (Gauss).
fn elliptic(k: f64) -> (f64, f64) {
    let (mut a, mut g, mut c) = (1.0, (1.0 - k * k).sqrt(), k);
    let (mut sum, mut power) = (0.5 * c * c, 0.5);
    // Quadratic convergence: each iteration doubles the digits.
    for _ in 0..8 {
        (a, g, c) = (0.5 * (a + g), (a * g).sqrt(), 0.5 * (a - g));
        power *= 2.0;
        sum += power * c * c;
    }
    let first = 0.5 * PI / a;
    (first, first * (1.0 - sum))
}
