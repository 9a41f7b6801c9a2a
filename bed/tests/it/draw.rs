//! Numbers for random states, the same every time.

use smartbed_runtime::vec3::Vec3;

/// Numbers between -1 and 1 (a linear congruence).
pub struct Draw(pub u64);

impl Draw {
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    pub fn vector(&mut self) -> Vec3<f64> {
        [self.next(), self.next(), self.next()]
    }
}
