//! Rules about the text of a program: encodings, marks, padding.

use super::*;

#[test]
fn umlauts_in_comments_are_read_in_any_encoding() {
    row(|column| {
        let [seven, nine] = column.moves();
        let whole = column.run(&[&seven, &nine]);
        for (open, close) in column.comments {
            let text = column.text(&[&format!("{seven} {open}Spr\u{fc}h\u{e4}{close}"), &nine]);
            let narrow: Vec<u8> = text.chars().map(|c| c as u8).collect();
            let utf8 = column.bytes(text.clone().into_bytes());
            let latin = column.bytes(narrow);
            same(&utf8, &whole, "UTF-8")?;
            same(&latin, &whole, "Windows-1252")?;
            for compiled in [&utf8, &latin] {
                let said = compiled.output.contains("Spruehae") || compiled.output.contains("SPRUEHAE");
                hold(said && compiled.output.is_ascii(), || compiled.output.clone())?;
            }
            for byte in [0x80, 0x81, 0x9f, 0xff, 0x7f, 0x1b, 1] {
                let text = column.text(&[&format!("{seven} {open}a?b{close}"), &nine]);
                let bytes = text.bytes().map(|b| if b == b'?' { byte } else { b }).collect();
                same(&column.bytes(bytes), &whole, &format!("byte {byte:#x} in a comment"))?;
            }
        }
        Ok(())
    });
}

#[test]
fn two_bytes_a_character_are_refused() {
    row(|column| {
        let [seven, nine] = column.moves();
        let text = column.text(&[&seven, &nine]);
        for mark in ["\u{feff}", ""] {
            let units: Vec<u16> = format!("{mark}{text}").encode_utf16().collect();
            for bytes in [
                units.iter().flat_map(|unit| unit.to_le_bytes()).collect::<Vec<u8>>(),
                units.iter().flat_map(|unit| unit.to_be_bytes()).collect(),
            ] {
                refuses(&column.bytes(bytes), "P0001", "UTF-16")?;
            }
        }
        Ok(())
    });
}

#[test]
fn a_byte_order_mark_stands_at_the_start_only() {
    row(|column| {
        let [seven, nine] = column.moves();
        let text = column.text(&[&seven, &nine]);
        let whole = column.bytes(text.clone().into_bytes());
        same(&column.bytes(format!("\u{feff}{text}").into_bytes()), &whole, "a mark at the start")?;
        for wrong in [format!("\u{feff}\u{feff}{text}"), column.text(&[&seven, &format!("\u{feff}{nine}")])] {
            let compiled = column.bytes(wrong.into_bytes());
            hold(compiled.has_errors(), || format!("a mark elsewhere is taken: {}", compiled.output))?;
        }
        Ok(())
    });
}

#[test]
fn nul_and_ctrl_z_are_padding_outside_the_program_only() {
    row(|column| {
        let [seven, nine] = column.moves();
        let whole = column.run(&[&seven, &nine]);
        for hole in ["\0", "\x1a", "\0\0\0\0\0\0"] {
            let mut inside = vec![seven.replace(' ', &format!(" {hole}"))];
            for (open, close) in column.comments {
                inside.push(format!("{seven} {open}text{hole}more{close}"));
                inside.push(format!("{seven} {hole} {open}text{close}"));
            }
            for block in inside.iter().filter(|block| block.contains(hole)) {
                let found = column.run(&[block, &nine]);
                hold(errors(&found).contains(&"P0005"), || format!("{block:?}: {:?}", found.rendered))?;
            }
            for body in [
                [format!("{seven}{hole}"), nine.clone()],
                [format!("{hole}{seven}"), nine.clone()],
                [format!("{seven}\n{hole}\r"), nine.clone()],
            ] {
                let compiled = column.run(&[&body[0], &body[1]]);
                let warned = compiled.codes().contains(&"P0006");
                hold(warned, || format!("no warning of {body:?}: {:?}", compiled.rendered))?;
                same(&compiled, &whole, &format!("{body:?}"))?;
            }
            let text = column.text(&[&seven, &nine]);
            for padded in [
                format!("{text}{hole}"),
                format!("{text}{hole}\n"),
                format!("{}{hole}", text.trim_end()),
                format!("{text}\r\n{hole}\r\n {hole}"),
                format!("{hole}{text}"),
                format!("{hole}\n{text}"),
            ] {
                let compiled = column.bytes(padded.clone().into_bytes());
                same(&compiled, &whole, &format!("padding of {hole:?} in {padded:?}"))?;
            }
        }
        Ok(())
    });
}

#[test]
fn an_empty_file_is_refused() {
    row(|column| {
        for text in ["", "\n", " \t\r\n\r\n", "\0\0\0", "\x1a", "\u{feff}", "\u{feff}\r\n"] {
            refuses(&column.bytes(text.as_bytes().to_vec()), "P0004", &format!("{text:?}"))?;
        }
        Ok(())
    });
}

#[test]
fn what_follows_a_line_that_is_too_long_is_silent_until_the_place_is_known() {
    row(|column| {
        let (open, close) = column.comments[0];
        let long = format!("{} {open}{}{close}", (column.to)(7), "-".repeat((1 << 20) + 1));
        refuses(&column.run(&[&long, &(column.by)(3), &(column.to)(9), &(column.by)(1)]), "P0003", "a long line")?;
        // A line that is nearly too long is a block like others.
        let whole = column.run(&[&(column.to)(7), &(column.to)(9)]);
        let nearly = format!("{} {open}{}{close}", (column.to)(7), "-".repeat((1 << 20) - 100));
        same(&column.run(&[&nearly, &(column.to)(9)]), &whole, "a line of nearly 1 MiB")
    });
}

#[test]
fn a_letter_beyond_ascii_is_named_as_a_whole() {
    row(|column| {
        let [seven, nine] = column.moves();
        for word in ["S\u{c4}", "M\u{c4}", "\u{c4}", "\u{20ac}5"] {
            let compiled = column.bytes(column.text(&[&format!("{seven} {word}"), &nine]).into_bytes());
            let letter = word.trim_matches(|c: char| c.is_ascii());
            let named = compiled.findings.iter().any(|found| found.message.contains(letter));
            hold(named && compiled.has_errors(), || format!("{word}: {:?}", compiled.rendered))?;
        }
        Ok(())
    });
}
