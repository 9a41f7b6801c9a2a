//! A drawing as PNG: painted and encoded by `tiny-skia`, letters as outlines of the embedded font.

use super::drawing::{Anchor, Color, Drawing, INK, Item};
use super::font;
use tiny_skia::{FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, Stroke, Transform};
use ttf_parser::{Face, OutlineBuilder};

/// Pixels of the file per pixel of the drawing, for screens of high resolution.
pub const SCALE: u32 = 2;

/// The contents of the file.
///
/// # Errors
/// A message if there is not enough memory for the pixels.
pub fn bytes(drawing: &Drawing) -> Result<Vec<u8>, String> {
    let size = |n: usize| u32::try_from(n).unwrap_or(u32::MAX).saturating_mul(SCALE);
    let (width, height) = (size(drawing.width), size(drawing.height));
    let mut pixels = Pixmap::new(width, height)
        .ok_or_else(|| format!("a picture of {width} x {height} pixels is too large"))?;
    pixels.fill(tiny_skia::Color::WHITE);
    let face = font::face();
    let scale = Transform::from_scale(SCALE as f32, SCALE as f32);
    for item in &drawing.items {
        match item {
            Item::Line { points, color, width } => {
                let stroke = Stroke {
                    width: *width as f32,
                    line_cap: LineCap::Butt,
                    line_join: LineJoin::Round,
                    ..Stroke::default()
                };
                if let Some(path) = polygon(points, false) {
                    pixels.stroke_path(&path, &paint(*color), &stroke, scale, None);
                }
            }
            Item::Area { points, color } => {
                if let Some(path) = polygon(points, true) {
                    pixels.fill_path(&path, &paint(*color), FillRule::Winding, scale, None);
                }
            }
            Item::Text { at, text, size, anchor, upwards } => {
                let place = placed(*at, font::width(text, *size), *size, *anchor, *upwards);
                if let Some(path) = face.as_ref().and_then(|face| letters(face, text, *size)) {
                    let place = place.post_concat(scale);
                    pixels.fill_path(&path, &paint(INK), FillRule::Winding, place, None);
                }
            }
        }
    }
    pixels.encode_png().map_err(|e| e.to_string())
}

fn paint(color: Color) -> Paint<'static> {
    let [r, g, b] = color;
    let mut paint = Paint { anti_alias: true, ..Paint::default() };
    paint.set_color_rgba8(r, g, b, 255);
    paint
}

fn polygon(points: &[(f64, f64)], closed: bool) -> Option<Path> {
    let mut path = PathBuilder::new();
    for (n, (x, y)) in points.iter().enumerate() {
        match n {
            0 => path.move_to(*x as f32, *y as f32),
            _ => path.line_to(*x as f32, *y as f32),
        }
    }
    if closed {
        path.close();
    }
    path.finish()
}

/// Transformation from the start of the text's base line to its position in the drawing.
fn placed((x, y): (f64, f64), width: f64, size: f64, anchor: Anchor, upwards: bool) -> Transform {
    let back = match anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => -0.5 * width,
        Anchor::End => -width,
    };
    // Capitals are 0.71 em high: their middle lies 0.35 em above the base line.
    let base = Transform::from_translate(back as f32, (0.35 * size) as f32);
    let turn = if upwards { Transform::from_rotate(-90.0) } else { Transform::identity() };
    base.post_concat(turn).post_translate(x as f32, y as f32)
}

/// Outlines of a text that starts at 0 on the base line.
fn letters(face: &Face<'_>, text: &str, size: f64) -> Option<Path> {
    let scale = size as f32 / f32::from(face.units_per_em());
    let mut outline = Outline { path: PathBuilder::new(), x: 0.0, scale };
    for c in text.chars() {
        let glyph = face.glyph_index(c).unwrap_or_default();
        // A space has no outline.
        let _ = face.outline_glyph(glyph, &mut outline);
        outline.x += scale * f32::from(face.glyph_hor_advance(glyph).unwrap_or_default());
    }
    outline.path.finish()
}

/// Collects outlines with y downwards; a font's y is upwards.
struct Outline {
    path: PathBuilder,
    x: f32,
    scale: f32,
}

impl Outline {
    fn at(&self, x: f32, y: f32) -> (f32, f32) {
        (self.x + self.scale * x, -self.scale * y)
    }
}

impl OutlineBuilder for Outline {
    fn move_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.path.move_to(x, y);
    }
    fn line_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.path.line_to(x, y);
    }
    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let ((x1, y1), (x, y)) = (self.at(x1, y1), self.at(x, y));
        self.path.quad_to(x1, y1, x, y);
    }
    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let ((x1, y1), (x2, y2), (x, y)) = (self.at(x1, y1), self.at(x2, y2), self.at(x, y));
        self.path.cubic_to(x1, y1, x2, y2, x, y);
    }
    fn close(&mut self) {
        self.path.close();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Darkest value of a picture's pixels in a box of the drawing.
    fn darkest(png: &[u8], (left, top, right, bottom): (u32, u32, u32, u32)) -> u8 {
        let pixels = Pixmap::decode_png(png).expect("a picture");
        let inside = (top * SCALE..bottom * SCALE)
            .flat_map(|y| (left * SCALE..right * SCALE).map(move |x| (x, y)))
            .filter_map(|(x, y)| pixels.pixel(x, y));
        inside.map(|p| p.red()).min().unwrap_or(255)
    }

    #[test]
    fn words_stand_where_they_belong() {
        let text =
            |at, anchor, upwards| Item::Text { at, text: "Hm".to_owned(), size: 20.0, anchor, upwards };
        let draw = |item| bytes(&Drawing { width: 100, height: 100, items: vec![item] }).expect("a picture");
        let start = draw(text((50.0, 50.0), Anchor::Start, false));
        assert!(darkest(&start, (51, 42, 90, 58)) < 60 && darkest(&start, (0, 0, 50, 100)) == 255);
        assert!(darkest(&start, (0, 0, 100, 42)) == 255 && darkest(&start, (0, 58, 100, 100)) == 255);
        let end = draw(text((50.0, 50.0), Anchor::End, false));
        assert!(darkest(&end, (10, 42, 50, 58)) < 60 && darkest(&end, (51, 0, 100, 100)) == 255);
        // Read from bottom to top, from (50, 50) upwards.
        let up = draw(text((50.0, 50.0), Anchor::Start, true));
        assert!(darkest(&up, (42, 10, 58, 50)) < 60 && darkest(&up, (0, 51, 100, 100)) == 255);
    }

    #[test]
    fn a_line_is_drawn_where_it_belongs() {
        let points = vec![(0.0, 5.5), (10.0, 5.5)];
        let line = Item::Line { points, color: [0, 0, 0], width: 1.0 };
        let png = bytes(&Drawing { width: 10, height: 10, items: vec![line] }).expect("a picture");
        assert_eq!(
            (darkest(&png, (5, 5, 6, 6)), darkest(&png, (5, 0, 6, 5)), darkest(&png, (5, 6, 6, 10))),
            (0, 255, 255)
        );
    }
}
