//! A picture as PNG, the same bytes on every system: circles become chords and letters strokes before anything is drawn, so
//! that no function of the platform and no font has a say.

use std::io;

use tiny_skia::{Color, FillRule, LineCap, LineJoin, Paint, PathBuilder, Pixmap, Stroke, StrokeDash, Transform};

use crate::geo::{Point2, Vec2, distance, turned};

use super::canvas::{Anchor, COLOURS, Canvas, Class, Ink, LOUD, Look, PALE, Part, Widths, Words};
use super::glyphs;
use super::layout::Layout;

/// What stands in the file that tells who drew it.
pub const MARK: &[u8] = b"tEXtSoftware\0partc plot";
/// How every PNG begins.
const SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";
/// Pixels between an arc and its chords.
const SAG: f64 = 0.05;
/// How hard to look for repetitions.
const COMPRESSION: u8 = 6;

/// Draws a picture.
#[derive(Debug)]
pub(super) struct Png {
    pixmap: Pixmap,
    widths: Widths,
    /// Left upper corner of the picture, y upwards.
    corner: Point2,
    pixel: f64,
    pale: bool,
}

impl Png {
    /// # Errors
    /// A picture without a size.
    pub(super) fn new(layout: &Layout, widths: Widths) -> io::Result<Png> {
        let (x, y, w, h) = layout.frame();
        let side = |length: f64| libm::ceil(length / layout.pixel).clamp(1.0, 2.0 * super::layout::PIXELS) as u32;
        let mut pixmap = Pixmap::new(side(w), side(h)).ok_or_else(|| io::Error::other("the picture has no size"))?;
        pixmap.fill(Color::WHITE);
        Ok(Png { pixmap, widths, corner: Point2::new(x, -y), pixel: layout.pixel, pale: false })
    }

    fn at(&self, p: Point2) -> (f32, f32) {
        let p = (p - self.corner) / self.pixel;
        // What lies far outside is not seen wherever it is.
        let near = |v: f64| v.clamp(-1e5, 1e5) as f32;
        (near(p.x), near(-p.y))
    }

    fn build(&self, parts: &[Part]) -> PathBuilder {
        let mut path = PathBuilder::new();
        let mut last = Point2::origin();
        for part in parts {
            match *part {
                Part::Move(p) => {
                    let (x, y) = self.at(p);
                    path.move_to(x, y);
                    last = p;
                }
                Part::Line(p) => {
                    let (x, y) = self.at(p);
                    // What has no length would not be drawn.
                    path.line_to(if p == last { x + 0.01 } else { x }, y);
                    last = p;
                }
                Part::Arc { center, sweep, to } => {
                    let radius = distance(last, center) / self.pixel;
                    let step = 2.0 * libm::acos((1.0 - SAG / radius.max(SAG)).clamp(0.0, 1.0));
                    let count = libm::ceil(sweep.abs() / step.max(0.01)).clamp(1.0, 1000.0) as u32;
                    for i in 1..count {
                        let angle = sweep * f64::from(i) / f64::from(count);
                        let (x, y) = self.at(center + turned(last - center, angle));
                        path.line_to(x, y);
                    }
                    let (x, y) = self.at(to);
                    path.line_to(x, y);
                    last = to;
                }
                Part::Close => path.close(),
            }
        }
        path
    }

    fn draw(&mut self, path: PathBuilder, look: &Look) {
        let Some(path) = path.finish() else { return };
        let mut paint = Paint { anti_alias: true, ..Paint::default() };
        let rgb = match look.ink {
            Ink::Tool(i) => COLOURS.get(i).copied().unwrap_or_default(),
            Ink::Fixed(light, _) => light,
        };
        let [_, r, g, b] = rgb.to_be_bytes();
        let opacity = if self.pale { PALE * look.opacity } else { look.opacity };
        paint.set_color_rgba8(r, g, b, (opacity.clamp(0.0, 1.0) * 255.0) as u8);
        if look.filled {
            self.pixmap.fill_path(&path, &paint, FillRule::Winding, Transform::identity(), None);
            return;
        }
        let dash: Vec<f32> = look.dash.iter().map(|length| *length as f32).collect();
        let stroke = Stroke {
            width: look.width as f32,
            line_cap: if look.round { LineCap::Round } else { LineCap::Butt },
            line_join: if look.round { LineJoin::Round } else { LineJoin::Miter },
            dash: StrokeDash::new(dash, 0.0),
            ..Stroke::default()
        };
        self.pixmap.stroke_path(&path, &paint, &stroke, Transform::identity(), None);
    }

    /// The file.
    ///
    /// # Errors
    /// None: memory takes everything.
    pub(super) fn finish(self) -> io::Result<Vec<u8>> {
        let (w, h) = (self.pixmap.width(), self.pixmap.height());
        let mut file = SIGNATURE.to_vec();
        // 8 bits each of red, green and blue.
        let head = [&w.to_be_bytes()[..], &h.to_be_bytes(), &[8, 2, 0, 0, 0]].concat();
        chunk(&mut file, b"IHDR", &head);
        let (name, text) = MARK.split_at(4);
        chunk(&mut file, name, text);
        let pixels = rows(self.pixmap.data(), w as usize);
        chunk(&mut file, b"IDAT", &miniz_oxide::deflate::compress_to_vec_zlib(&pixels, COMPRESSION));
        chunk(&mut file, b"IEND", &[]);
        Ok(file)
    }
}

impl Canvas for Png {
    fn path(&mut self, class: Class, _: Option<&str>, parts: &[Part]) {
        let path = self.build(parts);
        self.draw(path, &class.look(self.widths));
    }

    fn pale(&mut self, is: bool) {
        self.pale = is;
    }

    fn words(&mut self, words: &Words<'_>) {
        let count = words.text.chars().count() as f64;
        let long = count * glyphs::ADVANCE * words.font;
        let back = match words.anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => long / 2.0,
            Anchor::End => long,
        };
        let way = |v: Vec2| if words.upright { Vec2::new(-v.y, v.x) } else { v };
        let mut parts: Vec<Part> = Vec::new();
        for (i, letter) in words.text.chars().enumerate() {
            let left = i as f64 * glyphs::ADVANCE * words.font - back;
            for chain in glyphs::strokes(letter) {
                for (k, p) in chain.into_iter().enumerate() {
                    let at = words.at + way(Vec2::new(left, 0.0) + p * words.font);
                    parts.push(if k == 0 { Part::Move(at) } else { Part::Line(at) });
                }
            }
        }
        let width = if words.loud { 0.11 } else { 0.075 } * words.font / self.pixel;
        let ink = Ink::Fixed(if words.loud { LOUD.0 } else { 0x333333 }, 0);
        let look = Look { width, dash: &[], ink, opacity: 1.0, round: true, filled: false };
        let path = self.build(&parts);
        self.draw(path, &look);
    }
}

/// Rows of red, green and blue, each as the difference from the one above.
fn rows(rgba: &[u8], width: usize) -> Vec<u8> {
    const UP: u8 = 2;
    let mut out = Vec::with_capacity(rgba.len());
    let mut above = vec![0u8; 3 * width];
    for row in rgba.chunks_exact(4 * width) {
        out.push(UP);
        let now = row.chunks_exact(4).flat_map(|pixel| pixel.iter().take(3).copied());
        for (value, above) in now.zip(above.iter_mut()) {
            out.push(value.wrapping_sub(*above));
            *above = value;
        }
    }
    out
}

fn chunk(file: &mut Vec<u8>, name: &[u8], content: &[u8]) {
    let length = u32::try_from(content.len()).unwrap_or(u32::MAX);
    file.extend_from_slice(&length.to_be_bytes());
    let start = file.len();
    file.extend_from_slice(name);
    file.extend_from_slice(content);
    let check = checksum(file.get(start..).unwrap_or_default());
    file.extend_from_slice(&check.to_be_bytes());
}

/// CRC-32 of ISO 3309, as PNG wants it.
fn checksum(bytes: &[u8]) -> u32 {
    let mut crc = u32::MAX;
    for byte in bytes {
        crc ^= u32::from(*byte);
        for _ in 0..8 {
            crc = if crc & 1 == 1 { (crc >> 1) ^ 0xedb8_8320 } else { crc >> 1 };
        }
    }
    !crc
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_checksum_is_that_of_the_standard() {
        assert_eq!(checksum(b"123456789"), 0xcbf4_3926);
        assert_eq!(checksum(b"IEND"), 0xae42_6082);
    }
}
