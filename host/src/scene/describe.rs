//! Messages for errors of the runtime.

use smartbed_codegen::words::count;
use smartbed_runtime::flexible::BodyError;
use smartbed_runtime::real::Scalar;

/// The message for an error of the runtime.
#[must_use]
pub fn describe<S: Scalar>(error: &BodyError<S>) -> String {
    match error {
        BodyError::Empty => "the body has no points".to_string(),
        BodyError::Length { expected, found } => {
            format!("a list has {}, expected {expected}", count(found, "entry"))
        }
        BodyError::UnknownPoint { point, points } => {
            format!("point {point} does not exist: the points are 0 to {}", points - 1)
        }
        BodyError::OutOfRange(quantity) => {
            let expected = quantity.expected();
            format!("a constant of the body or its ground is out of range: expected {expected}")
        }
        BodyError::Negative { index } => format!("entry {index} of the masses or springs is negative"),
        BodyError::Scratch { needed, given } => {
            format!("scratch memory: {given} vectors given, {needed} needed")
        }
        BodyError::NotFinite { point } => {
            format!(
                "the position or velocity of point {point} is not finite; take a smaller step or a smaller load"
            )
        }
        BodyError::BelowGround { point, depth } => format!(
            "point {point} starts {:.6e} m below the ground; raise the body (drop_height), lower the floor, or take \
             a law of compliant ground: penalty, hunt_crossley",
            depth.to_f64()
        ),
        BodyError::ThroughGround { point } => format!(
            "point {point} has mass and went through the ground, which holds massless points only; name it in \
             `massless`, or take another law"
        ),
        BodyError::PressureTooHigh { pressure, spring } => format!(
            "a gauge pressure of {:.6} Pa is too {}: spring {spring} was stretched beyond {} rest lengths, as by a balloon that \
             grows without end; {} the pressure or let the gas follow p V^n, or let springs start less drawn",
            pressure.to_f64(),
            if *pressure < S::ZERO { "low" } else { "much" },
            smartbed_runtime::flexible::spring::STRETCH_LIMIT,
            if *pressure < S::ZERO { "raise" } else { "lower" }
        ),
        BodyError::Collapsed { volume } => {
            format!("the enclosed volume is {:.6e} m^3: the gas law has no pressure there", volume.to_f64())
        }
        BodyError::NotConverged { step } => {
            format!("the implicit step of {:.6e} s did not converge; take a smaller step", step.to_f64())
        }
    }
}
