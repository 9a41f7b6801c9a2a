//! A drawing as PNG: lines covered by distance, letters from an 8 x 8 font, deflated.
//!
//! The font stands at twice its size (16 pixels), which all texts of a chart have room for.

use super::drawing::{Anchor, Color, Drawing, INK, Item};
use font8x8::UnicodeFonts;

/// Pixels per pixel of the font, across: 8 x 10 letters of even strokes.
const GLYPH: f64 = 8.0;

/// The picture's pixels.
struct Raster {
    width: usize,
    height: usize,
    pixels: Vec<u8>,
}

impl Raster {
    /// Blends a colour into a pixel.
    fn blend(&mut self, x: i64, y: i64, color: Color, share: f64) {
        let inside = (0..self.width as i64).contains(&x) && (0..self.height as i64).contains(&y);
        if !inside || share <= 0.0 {
            return;
        }
        let first = 3 * (y as usize * self.width + x as usize);
        for (pixel, c) in self.pixels[first..first + 3].iter_mut().zip(color) {
            let mixed = f64::from(*pixel) + share.min(1.0) * (f64::from(c) - f64::from(*pixel));
            *pixel = mixed.round() as u8;
        }
    }

    /// A polyline; pixels are covered by their distance to it, each once.
    fn line(&mut self, points: &[(f64, f64)], color: Color, width: f64) {
        let reach = 0.5 * width + 0.5;
        let mut covered: std::collections::BTreeMap<(i64, i64), f64> = std::collections::BTreeMap::new();
        for ends in points.windows(2) {
            let ((ax, ay), (bx, by)) = (ends[0], ends[1]);
            let (x0, x1) = ((ax.min(bx) - reach).floor() as i64, (ax.max(bx) + reach).ceil() as i64);
            let (y0, y1) = ((ay.min(by) - reach).floor() as i64, (ay.max(by) + reach).ceil() as i64);
            let (x0, x1) = (x0.max(0), x1.min(self.width as i64));
            let (y0, y1) = (y0.max(0), y1.min(self.height as i64));
            for y in y0..=y1 {
                for x in x0..=x1 {
                    let share = reach - distance((x as f64 + 0.5, y as f64 + 0.5), (ax, ay), (bx, by));
                    if share > 0.0 {
                        let most = covered.entry((y, x)).or_insert(0.0);
                        *most = most.max(share);
                    }
                }
            }
        }
        for ((y, x), share) in covered {
            self.blend(x, y, color, share);
        }
    }

    fn text(&mut self, (x, y): (f64, f64), text: &str, size: f64, anchor: Anchor, upwards: bool) {
        // Height of a letter is `size`; its width a little less than the font's square.
        let (tall, wide) = (size / GLYPH, 0.62 * size / GLYPH * 1.15);
        let length = wide * GLYPH * text.chars().count() as f64;
        let start = match anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => -0.5 * length,
            Anchor::End => -length,
        };
        for (n, c) in text.chars().enumerate() {
            let glyph =
                font8x8::BASIC_FONTS.get(c).or_else(|| font8x8::BASIC_FONTS.get('?')).unwrap_or([0; 8]);
            let left = start + n as f64 * wide * GLYPH;
            for (row, bits) in glyph.iter().enumerate() {
                for column in (0..8).filter(|c| bits >> c & 1 == 1) {
                    let (u, v) = (left + column as f64 * wide, (row as f64 - 0.5 * GLYPH) * tall);
                    let corner = if upwards { (x + v, y - u - wide) } else { (x + u, y + v) };
                    let extent = if upwards { (tall, wide) } else { (wide, tall) };
                    self.rectangle(corner, extent);
                }
            }
        }
    }

    /// A filled rectangle; pixels at its edges are covered in part.
    fn rectangle(&mut self, (x, y): (f64, f64), (w, h): (f64, f64)) {
        let overlap =
            |pixel: i64, from: f64, to: f64| (to.min(pixel as f64 + 1.0) - from.max(pixel as f64)).max(0.0);
        for py in y.floor() as i64..=(y + h).floor() as i64 {
            for px in x.floor() as i64..=(x + w).floor() as i64 {
                self.blend(px, py, INK, overlap(px, x, x + w) * overlap(py, y, y + h));
            }
        }
    }
}

/// Distance of a point from the line between two others.
fn distance((px, py): (f64, f64), (ax, ay): (f64, f64), (bx, by): (f64, f64)) -> f64 {
    let (dx, dy) = (bx - ax, by - ay);
    let square = dx * dx + dy * dy;
    let along = if square > 0.0 { ((px - ax) * dx + (py - ay) * dy) / square } else { 0.0 };
    let along = along.clamp(0.0, 1.0);
    (px - ax - along * dx).hypot(py - ay - along * dy)
}

/// The file's bytes.
#[must_use]
pub fn bytes(drawing: &Drawing) -> Vec<u8> {
    let (width, height) = (drawing.width, drawing.height);
    let mut raster = Raster { width, height, pixels: vec![255; 3 * width * height] };
    for item in &drawing.items {
        match item {
            Item::Line { points, color, width } => raster.line(points, *color, *width),
            Item::Text { at, text, size, anchor, upwards } => {
                raster.text(*at, text, *size, *anchor, *upwards)
            }
        }
    }
    encoded(&raster)
}

/// PNG: signature, header, one chunk of deflated rows, end.
fn encoded(raster: &Raster) -> Vec<u8> {
    /// Row filter 0: bytes as they are.
    const AS_IT_IS: u8 = 0;
    /// Bits per channel, colour type (red, green, blue), deflate, filters of the standard, no interlacing.
    const KIND: [u8; 5] = [8, 2, 0, 0, 0];
    let mut header = Vec::new();
    header.extend((raster.width as u32).to_be_bytes());
    header.extend((raster.height as u32).to_be_bytes());
    header.extend(KIND);
    let rows = raster.pixels.chunks(3 * raster.width);
    let raw: Vec<u8> = rows.flat_map(|row| std::iter::once(AS_IT_IS).chain(row.iter().copied())).collect();
    let data = miniz_oxide::deflate::compress_to_vec_zlib(&raw, 6);
    let mut file = vec![0x89, b'P', b'N', b'G', b'\r', b'\n', 0x1a, b'\n'];
    for (kind, content) in [(b"IHDR", header), (b"IDAT", data), (b"IEND", Vec::new())] {
        file.extend((content.len() as u32).to_be_bytes());
        let start = file.len();
        file.extend(kind);
        file.extend(content);
        let sum = checksum(&file[start..]);
        file.extend(sum.to_be_bytes());
    }
    file
}

/// CRC-32 of the PNG standard (polynomial 0xEDB88320, bits reversed).
fn checksum(bytes: &[u8]) -> u32 {
    let mut crc = u32::MAX;
    for byte in bytes {
        crc ^= u32::from(*byte);
        for _ in 0..8 {
            crc = (crc >> 1) ^ (0xEDB8_8320 & (crc & 1).wrapping_neg());
        }
    }
    !crc
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_checksum_is_the_standard_one() {
        assert_eq!(checksum(b"123456789"), 0xCBF4_3926);
    }

    #[test]
    fn a_line_is_drawn_where_it_belongs() {
        let mut raster = Raster { width: 10, height: 10, pixels: vec![255; 300] };
        raster.line(&[(0.0, 5.5), (10.0, 5.5)], [0, 0, 0], 1.0);
        let at = |x: usize, y: usize| raster.pixels[3 * (10 * y + x)];
        assert_eq!((at(5, 5), at(5, 3), at(5, 8)), (0, 255, 255));
    }
}
