//! BLK FORM: the blank, of which the path needs nothing but the tool axis; pictures show it.
//!
//! Source: K 1.4 (docs/sources.md).

use crate::diag::codes;
use crate::ir::{self, Frame, Function, Remark};
use crate::lexer::klartext::Value;
use crate::parser::klartext::ast::{Addr, Block};
use crate::sema::run::Where;

use super::{Core, Outcome, Run};

/// What a blank looks like.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Shape {
    Cuboid,
    Cylinder,
    Rotation,
    File,
    Unknown,
}

impl Shape {
    fn named(word: &[u8]) -> Shape {
        match word.to_ascii_uppercase().as_slice() {
            b"CYLINDER" => Shape::Cylinder,
            b"ROTATION" => Shape::Rotation,
            b"FILE" => Shape::File,
            _ => Shape::Unknown,
        }
    }
}

impl Run<'_> {
    /// BLK FORM: no move follows from it; kept for the working plane of fragments and for checks.
    pub(super) fn blank_form(&mut self, block: &Block, text: &[u8]) -> Outcome {
        if self.st.moved {
            self.core.note(Where::Block, codes::K2508::blank_is_defined_behind_first_move());
        }
        let shape = match block.words.first() {
            Some(word) if word.addr == Addr::Name => Shape::named(word.span.of(text)),
            _ => Shape::Cuboid,
        };
        match shape {
            Shape::Cuboid => self.cuboid(block, text),
            Shape::Cylinder | Shape::Rotation | Shape::File => other_blank(&self.core, shape, block, text),
            Shape::Unknown => self.core.not_admitted(block.words[0], "BLK FORM"),
        }
    }

    /// `BLK FORM 0.1 Z X+0 Y+0 Z-20`, `BLK FORM 0.2 X+100 Y+100 Z+0`.
    fn cuboid(&mut self, block: &Block, text: &[u8]) -> Outcome {
        let mm = self.core.mm();
        let mut corner = None;
        let mut values = [None; 3];
        let mut letter = false;
        for (at, &word) in block.words.iter().enumerate() {
            match word.addr {
                Addr::Value if at == 0 => corner = Some(word.span.of(text).to_vec()),
                Addr::Axis { axis, incremental: false } if word.value == Value::None && corner.is_some() => {
                    if std::mem::replace(&mut letter, true) {
                        return self.core.not_admitted(word, "BLK FORM");
                    }
                    self.st.blank.axis = Some(axis);
                }
                Addr::Axis { axis, incremental } if axis.is_main() && corner.is_some() => {
                    if values[axis.index()].is_some() {
                        return self.core.twice(word, block);
                    }
                    let value = self.reading().number(word.value, word.span)? * mm;
                    let base = if incremental { self.st.blank.min.map_or(0.0, |min| min[axis.index()]) } else { 0.0 };
                    values[axis.index()] = Some(base + value);
                }
                _ => return self.core.not_admitted(word, "BLK FORM"),
            }
        }
        if block.words.is_empty() {
            self.core.say_here(codes::K2508::blk_form_names_no_corner_or_shape());
        }
        if let Some(other) = corner.as_deref().filter(|corner| !matches!(*corner, b"0.1" | b"0,1" | b"0.2" | b"0,2")) {
            let corner = crate::text::decode::readable(other).into_owned();
            self.core.say_here(codes::K2508::blk_form_is_no_corner(&corner));
            return Ok(());
        }
        let [Some(x), Some(y), Some(z)] = values else {
            if let Some(corner) = corner {
                let corner = crate::text::decode::readable(&corner).into_owned();
                self.core.say_here(codes::K2508::blk_form_does_not_name_all_axes(&corner));
            }
            return Ok(());
        };
        match corner.as_deref() {
            Some(b"0.1" | b"0,1") => self.st.blank.min = Some([x, y, z]),
            Some(b"0.2" | b"0,2") => {
                if let Some(min) = self.st.blank.min
                    && [x, y, z].iter().zip(&min).any(|(max, min)| max <= min)
                {
                    self.core.say_here(codes::K2508::max_does_not_lie_above_min());
                } else if let Some(low) = self.st.blank.min
                    && self.st.ctx.frame == Frame::default()
                {
                    // What a frame in front of BLK FORM does to the blank no manual says.
                    self.function(Function::Remark(Remark::Blank(ir::Blank::Cuboid { low, high: [x, y, z] })));
                }
            }
            _ => {}
        }
        Ok(())
    }
}

/// Cylinders, bodies of revolution and files: no influence on the path, but no stray word either.
fn other_blank(core: &Core<'_>, shape: Shape, block: &Block, text: &[u8]) -> Outcome {
    let mut named = false;
    for (at, &word) in block.words.iter().enumerate() {
        let name = word.span.of(text).to_ascii_uppercase();
        let takes = match (shape, word.addr) {
            _ if at == 0 => true,
            (Shape::File, Addr::Text) => true,
            (Shape::File, Addr::Name) => name == b"TARGET",
            (Shape::Cylinder | Shape::Rotation, Addr::Axis { incremental: false, .. }) => {
                at == 1 && word.value == Value::None
            }
            (Shape::Cylinder, Addr::Radius { .. } | Addr::Length) => true,
            (Shape::Cylinder, Addr::Name) => {
                matches!(name.as_slice(), b"D" | b"DI" | b"RI" | b"DIST" | b"L" | b"R")
            }
            (Shape::Rotation, Addr::Name) => {
                matches!(name.as_slice(), b"DIM_R" | b"DIM_D" | b"LBL" | b"LBLIN")
            }
            (Shape::Cylinder | Shape::Rotation, Addr::Value) => named,
            (Shape::Rotation, Addr::Text) => named,
            _ => false,
        };
        if !takes {
            return core.not_admitted(word, "BLK FORM");
        }
        named = at > 0 && word.addr == Addr::Name;
    }
    Ok(())
}
