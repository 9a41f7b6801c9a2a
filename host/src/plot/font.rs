//! The font of pictures: Noto Sans (SIL Open Font License, `font/LICENSE-OFL.txt`), its Latin and Greek letters and the
//! signs of mathematics. Made from release 2.015 by `pyftsubset NotoSans-Regular.ttf
//! --unicodes=20-7E,A0-17F,370-3FF,2010-2026,2070-2094,2190-2193,2200-2265 --no-hinting`.

use ttf_parser::Face;

/// Its name in SVG, with others of the same width.
pub const FAMILY: &str = "Noto Sans, Open Sans, Arial, sans-serif";

static FILE: &[u8] = include_bytes!("font/noto_sans.ttf");

/// The font; `None` if its file is invalid, which a test excludes.
pub(super) fn face() -> Option<Face<'static>> {
    Face::parse(FILE, 0).ok()
}

/// Width of a text whose letters are `size` high (pixels); a letter that the font lacks is a box.
#[must_use]
pub fn width(text: &str, size: f64) -> f64 {
    let Some(face) = face() else { return 0.6 * size * text.chars().count() as f64 };
    let advance = |c| face.glyph_hor_advance(face.glyph_index(c).unwrap_or_default()).unwrap_or_default();
    let units: f64 = text.chars().map(|c| f64::from(advance(c))).sum();
    units * size / f64::from(face.units_per_em())
}

/// The text in lines of at most `most` pixels, wrapped at spaces, and inside a word that is too long by itself.
#[must_use]
pub fn wrapped(text: &str, size: f64, most: f64) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split_inclusive(' ') {
        let fits = |line: &str, more: &str| width(&format!("{line}{}", more.trim_end()), size) <= most;
        for piece in pieces(word, size, most) {
            match lines.last_mut() {
                Some(line) if line.is_empty() || fits(line, &piece) => line.push_str(&piece),
                _ => lines.push(piece),
            }
        }
    }
    lines.iter_mut().for_each(|line| line.truncate(line.trim_end().len()));
    lines
}

/// A word in pieces that fit; names are broken between their parts.
fn pieces(word: &str, size: f64, most: f64) -> Vec<String> {
    let (mut pieces, mut piece) = (Vec::new(), String::new());
    for c in word.chars() {
        let is_too_long = |part: &str| width(&format!("{part}{c}"), size) > most;
        if !piece.is_empty() && is_too_long(&piece) {
            let joint = piece.rfind(['_', '.']).map(|at| at + 1).filter(|at| !is_too_long(&piece[*at..]));
            let rest = piece.split_off(joint.unwrap_or(piece.len()));
            pieces.push(std::mem::replace(&mut piece, rest));
        }
        piece.push(c);
    }
    pieces.push(piece);
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_are_as_wide_as_the_font_says() {
        // Advances of Noto Sans in thousandths of an em: space 260, i 258, m 935.
        assert!((width("im ", 100.0) - 145.3).abs() < 0.2, "{}", width("im ", 100.0));
    }

    #[test]
    fn no_line_is_too_long_and_no_letter_is_lost() {
        let text = "A tile of three legs with anunreasonablylongwordthatfitsnowhere in it";
        for most in [60.0, 120.0, 500.0] {
            let lines = wrapped(text, 14.0, most);
            assert!(lines.iter().all(|l| width(l, 14.0) <= most), "{lines:?}");
            let letters = |s: &str| s.chars().filter(|c| *c != ' ').collect::<String>();
            assert_eq!(letters(&lines.concat()), letters(text));
        }
    }

    #[test]
    fn long_names_are_broken_at_their_joints() {
        let lines = wrapped("angle_of_the_upper_pendulum bladder[0,0].volume_of_gas", 14.0, 110.0);
        assert_eq!(lines, ["angle_of_the_", "upper_", "pendulum", "bladder[0,0].", "volume_of_gas"]);
    }
}
