//! The answer `law`: inputs as the model's law commands them.

use super::part::Part;
use super::stages::{Stages, Target};
use crate::diagnostic::Diagnostic;
use crate::kinematics;

/// One value per input; an input without a law is returned as given.
pub(super) fn law(stages: &mut Stages, _: &Target) -> Result<Vec<Part>, Diagnostic> {
    let mut values = stages.k.inputs.clone();
    for (input, law) in &stages.model.laws {
        values[*input] = kinematics::lower_scalar(stages.alg, stages.k, law);
    }
    let values: Vec<_> = values.iter().copied().collect();
    let values = stages.solved(&values);
    let names = stages.model.inputs.iter().map(|input| input.name.clone()).collect();
    Ok(vec![Part::list(
        "inputs",
        "as the law commands them; one without a law as it is given",
        names,
        values,
    )])
}
