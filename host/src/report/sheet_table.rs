//! One table of the cost sheets of all subjects.

use super::chip::Chip;
use super::markdown::duration;
use super::point::{ChipCost, Table};
use super::sheet::Variant;
use super::subject::Subject;

/// One table of all sheets. `chip` says why a cost on the chip is missing.
///
/// # Errors
/// Why a subject could not be run, in words.
pub fn table(subjects: &[Box<dyn Subject>], chip: &mut Chip, command: &str) -> Result<Table, String> {
    let columns = [
        "subject",
        "asked for",
        "left out",
        "operations per step",
        "time per step",
        "instructions per step on the chip",
        "flash there (bytes)",
        "RAM there",
        "stack there",
    ];
    let mut rows = Vec::new();
    for subject in subjects {
        let sheet = subject.sheet().map_err(|e| format!("{}: {e}", subject.name()))?;
        let Some(sheet) = sheet else { continue };
        let [asked, all] = sheet.costs;
        let mut row = vec![
            subject.name().to_owned(),
            sheet.asked.clone(),
            sheet.left_out.clone(),
            against(asked.operations, all.operations, |x| format!("{x:.0}")),
            against(asked.nanoseconds, all.nanoseconds, duration),
        ];
        let images = [Variant::default(), sheet.everything]
            .map(|variant| chip.measure(subject.name(), "as asked", &variant).ok());
        let costs: [fn(&ChipCost) -> u64; 4] = [|c| c.instructions, |c| c.flash, |c| c.ram, |c| c.stack];
        row.extend(costs.map(|cost| both(&images, cost)));
        rows.push(row);
    }
    let title = "Cost sheets: as asked, with everything on, and what that multiplies".to_owned();
    Ok(Table { title, columns: columns.map(str::to_owned).to_vec(), rows, command: command.to_owned() })
}

/// Two costs and their ratio; a cost of 0, as static memory often has, gives none.
fn against(asked: f64, all: f64, text: impl Fn(f64) -> String) -> String {
    let both = format!("{} / {}", text(asked), text(all));
    if asked == 0.0 { both } else { format!("{both} = {:.2} x", all / asked) }
}

/// A cost of both images, or of the one that could be built.
fn both(images: &[Option<ChipCost>; 2], cost: impl Fn(&ChipCost) -> u64) -> String {
    match images.each_ref().map(|image| image.as_ref().map(&cost)) {
        [Some(asked), Some(all)] if asked == all => format!("{asked} / {all}"),
        [Some(asked), Some(all)] => against(asked as f64, all as f64, |x| format!("{x:.0}")),
        [Some(asked), None] => format!("{asked} / -"),
        [None, Some(all)] => format!("- / {all}"),
        [None, None] => "-".to_owned(),
    }
}
