//! The control law: one force per leg from its commanded and its measured height.
//!
//! F_i = W/3 + K (h_i,commanded - h_i) - D h_i', with W the weight of everything that the three
//! legs carry. In: heights (m) and their rates (m/s). Out: forces (N), positive upwards.

/// Stiffness K of the law (N/m).
pub const STIFFNESS: f32 = 900.0;
/// Damping D of the law (N s/m).
pub const DAMPING: f32 = 20.0;

/// Forces of the legs (N).
#[must_use]
pub fn forces(weight: f32, commanded: [f32; 3], heights: [f32; 3], rates: [f32; 3]) -> [f32; 3] {
    let share = weight / 3.0;
    let mut forces = [0.0; 3];
    for (((force, commanded), height), rate) in forces.iter_mut().zip(commanded).zip(heights).zip(rates) {
        *force = share + STIFFNESS * (commanded - height) - DAMPING * rate;
    }
    forces
}

#[cfg(test)]
mod tests {
    use super::forces;

    #[test]
    fn at_rest_it_carries_the_weight() {
        assert_eq!(forces(90.0, [0.12; 3], [0.12; 3], [0.0; 3]), [30.0; 3]);
    }

    #[test]
    fn it_pushes_up_what_is_low_and_brakes_what_moves() {
        let [low, moving, both] = forces(0.0, [0.1; 3], [0.0, 0.1, 0.0], [0.0, 1.0, 1.0]);
        assert_eq!([low, moving, both], [90.0, -20.0, 70.0]);
    }
}
