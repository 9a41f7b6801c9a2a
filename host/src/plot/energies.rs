//! Colours of energies and of the ledger's accounts, the same for a name in every drawing.

use super::drawing::Color;

/// The thesis' colours (chapter 5) in the palette of Okabe & Ito; darker ones for quantities that it does not draw.
const COLORS: [(&str, Color); 13] = [
    ("kinetic", [230, 159, 0]),
    ("gravity", [204, 121, 167]),
    ("spring", [213, 94, 0]),
    ("potential", [0, 158, 115]),
    ("total", [0, 114, 178]),
    ("pressure", [86, 180, 233]),
    ("actuator", [120, 94, 240]),
    ("damping", [110, 110, 110]),
    ("drive", [120, 60, 20]),
    ("external", [0, 0, 0]),
    ("impact", [0, 0, 0]),
    ("friction", [0, 92, 66]),
    ("drag", [51, 34, 136]),
];

/// The colour of an energy or account; nothing for other curves.
#[must_use]
pub fn color(name: &str) -> Option<Color> {
    COLORS.iter().find(|(known, _)| *known == name).map(|(_, color)| *color)
}
