//! Rules about programs without an end: most often the rest was lost in transfer.

use super::*;

/// The program up to a move to `n`, without its end.
fn open(column: &Column, n: i32) -> String {
    let [seven, nine] = column.moves();
    let lines = column.head.iter().map(|line| (*line).to_owned()).chain([seven, nine, (column.to)(n)]);
    lines.map(|line| line + "\n").collect()
}

fn compiled(column: &Column, text: &str, more: &str) -> Compiled {
    compile_bytes(column.file, text.as_bytes().to_vec(), column.dialect, &column.settings(more), &NoFiles)
}

const ALLOWED: &str = "[control]\nopen_end = \"allow\"\n";

#[test]
fn a_main_program_without_an_end_is_refused() {
    row(|column| {
        let text = open(column, 99);
        let refused = compiled(column, &text, "");
        let code = if column.dialect == "klartext" { "P1006" } else { "P0007" };
        refuses(&refused, code, "no end")?;
        hold(refused.output.is_empty(), || refused.output.clone())?;
        // Where the control needs none, the end is added; a head that names the end of the program still wants it.
        let allowed = compiled(column, &text, ALLOWED);
        hold(allowed.has_errors() == (code == "P1006"), || format!("allowed: {:?}", allowed.rendered))?;
        let whole = column.run(&[&column.moves()[0], &column.moves()[1], &(column.to)(99)]);
        hold(!whole.has_errors(), || format!("whole: {:?}", whole.rendered))
    });
}

#[test]
fn a_program_that_stops_in_its_last_line_is_never_taken() {
    row(|column| {
        let text = open(column, 99);
        // Inside of the number, behind it, with padding, and in front of the line end alone.
        let cut = &text[..text.len() - 2];
        for text in [cut.to_owned(), format!("{cut} "), format!("{cut}\0\0"), text.trim_end().to_owned()] {
            for more in ["", ALLOWED] {
                let refused = compiled(column, &text, more);
                let code = if column.dialect == "klartext" { "P1006" } else { "P0008" };
                refuses(&refused, code, &format!("{text:?} with {more:?}"))?;
            }
        }
        // The end itself needs no line end.
        let whole = column.text(&[&column.moves()[0]]);
        hold(!compiled(column, whole.trim_end(), "").has_errors(), || format!("{whole:?} without its last line end"))
    });
}

#[test]
fn a_called_program_that_stops_in_its_last_line_is_never_taken() {
    row(|column| {
        let Some(call) = column.call else { return Ok(()) };
        struct Cut<'c>(&'c Column);
        impl Files for Cut<'_> {
            fn open(&self, _: &Request<'_>) -> Result<Opened, FileError> {
                let text = (self.0.to)(12);
                let name = (self.0.called)(1);
                let size = text.len() as u64;
                Ok(Opened { identity: name.clone(), name, text: Box::new(Sized(text.into_bytes(), size)) })
            }
        }
        let text = column.text(&[&call(1), &(column.to)(9)]).into_bytes();
        let called = compile_bytes(column.file, text, column.dialect, &column.settings(ALLOWED), &Cut(column));
        hold(called.has_errors(), || format!("a called program that was cut off is taken:\n{}", called.output))
    });
}

#[test]
fn an_end_that_may_be_the_beginning_of_a_longer_word_is_not_taken() {
    row(|column| {
        // There M2 belongs to the machine.
        if column.dialect == "heidenhain-turning" {
            return Ok(());
        }
        // `M2` of `M20` or `M2=3`: the rest of the file may be missing.
        for cut in ["M2", "m2", "M2\0\0"] {
            let text = open(column, 99) + cut;
            refuses(&compiled(column, &text, ALLOWED), "P0008", &format!("{text:?}"))?;
        }
        // M30 is a whole word, and so is M2 with anything behind it.
        for whole in ["M30", "M02", "M2\n", "M2 "] {
            let text = open(column, 99) + whole;
            hold(!compiled(column, &text, "").has_errors(), || format!("{text:?}"))?;
        }
        Ok(())
    });
}
