//! Colours of pictures by name.
//!
//! In: a word of a model or scene. Out: red, green, blue.

/// Colours by name: Okabe and Ito's, told apart by colour-blind eyes.
pub const COLOURS: [(&str, [u8; 3]); 10] = [
    ("black", [0, 0, 0]),
    ("orange", [230, 159, 0]),
    ("sky", [86, 180, 233]),
    ("green", [0, 158, 115]),
    ("yellow", [240, 228, 66]),
    ("blue", [0, 114, 178]),
    ("vermilion", [213, 94, 0]),
    ("purple", [204, 121, 167]),
    ("grey", [130, 130, 130]),
    ("white", [255, 255, 255]),
];

/// A colour by its name, or as `#rrggbb`.
#[must_use]
pub fn parse(text: &str) -> Option<[u8; 3]> {
    if let Some((_, rgb)) = COLOURS.iter().find(|(name, _)| *name == text) {
        return Some(*rgb);
    }
    let digits =
        text.strip_prefix('#').filter(|d| d.len() == 6 && d.bytes().all(|b| b.is_ascii_hexdigit()))?;
    let [_, r, g, b] = u32::from_str_radix(digits, 16).ok()?.to_be_bytes();
    Some([r, g, b])
}
