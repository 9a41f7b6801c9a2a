//! A drawing as SVG.

use super::drawing::{Anchor, Color, Drawing, INK, Item};
use super::font;
use std::fmt::Write as _;

/// The file's text.
#[must_use]
pub fn text(drawing: &Drawing) -> String {
    let Drawing { width, height, .. } = drawing;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" font-family=\"{}\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
        font::FAMILY
    );
    svg += &items(&drawing.items);
    svg + "</svg>\n"
}

/// Items of a drawing as elements.
#[must_use]
pub fn items(items: &[Item]) -> String {
    let mut svg = String::new();
    let list = |points: &[(f64, f64)]| {
        points.iter().map(|(x, y)| format!("{x:.2},{y:.2}")).collect::<Vec<_>>().join(" ")
    };
    for item in items {
        match item {
            Item::Line { points, color, width } => {
                let _ = writeln!(
                    svg,
                    "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{width}\" \
                     stroke-linejoin=\"round\"/>",
                    list(points),
                    hex(*color)
                );
            }
            Item::Area { points, color } => {
                let _ = writeln!(svg, "<polygon points=\"{}\" fill=\"{}\"/>", list(points), hex(*color));
            }
            Item::Text { at: (x, y), text, size, anchor, upwards } => {
                let anchor = match anchor {
                    Anchor::Start => "start",
                    Anchor::Middle => "middle",
                    Anchor::End => "end",
                };
                let turn = if *upwards {
                    format!(" transform=\"rotate(-90 {x:.2} {y:.2})\"")
                } else {
                    String::new()
                };
                // Vertical centring is computed here: renderers disagree about `dominant-baseline`.
                let base = y + 0.35 * size;
                // If another font is wider, letters move closer together, but words keep their place where there is
                // room.
                let length = font::width(text, *size);
                let _ = writeln!(
                    svg,
                    "<text x=\"{x:.2}\" y=\"{base:.2}\" font-size=\"{size}\" text-anchor=\"{anchor}\" \
                     textLength=\"{length:.1}\" lengthAdjust=\"spacingAndGlyphs\" fill=\"{}\"{turn}>{}</text>",
                    hex(INK),
                    escaped(text)
                );
            }
        }
    }
    svg
}

fn hex([r, g, b]: Color) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// Text with the characters escaped that XML and HTML read as markup, also inside quotes.
#[must_use]
pub fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            // XML has neither control characters nor these two.
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => out.push(' '),
            c => out.push(c),
        }
    }
    out
}
