//! Rules about what a program does: comments, findings, budgets, calls, names of files.

use super::*;

// Comments.

#[test]
fn comments_never_act() {
    row(|column| {
        let [seven, nine] = column.moves();
        let whole = column.run(&[&seven, &nine]);
        for (open, close) in column.comments {
            for text in [
                "G0 X99 Z99",
                "L X+99 R0 FMAX",
                "M30",
                "END PGM PART MM",
                "RET",
                "/ N5 X99",
                "N5 G1 X99",
                "(",
                ")",
                "((",
                "))",
                ")(",
                "[",
                "]",
                "][",
                "; ;",
                "%",
                "%_N_A_MPF",
                "\"",
                "'",
                "\"a",
                "~",
                "&",
                "*",
                "!",
                "#1=5",
                "R1=5",
                "Q1=+5",
                "@1=5",
                "LBL 1",
                ".A",
                "$PATH",
                "\\",
            ] {
                for comment in [format!("{open}{text}{close}"), format!("{open} a {text} b {close}")] {
                    for body in [
                        vec![format!("{seven} {comment}"), nine.clone()],
                        vec![seven.clone(), comment.clone(), nine.clone()],
                    ] {
                        let body: Vec<&str> = body.iter().map(String::as_str).collect();
                        let compiled = column.run(&body);
                        // A comment in brackets ends at the first one that closes, and a block of Klartext goes on
                        // behind `~`: then an error is right.
                        let ended = !close.is_empty() && text.contains(close) || text == "~";
                        if !(ended && compiled.has_errors()) {
                            same(&compiled, &whole, &comment)?;
                        }
                        let bare = |line: &&str| {
                            line.starts_with('(')
                                && (line.matches('(').count() != 1
                                    || !line.ends_with(')')
                                    || line.matches(')').count() != 1)
                        };
                        let wrong = compiled.output.lines().find(bare);
                        hold(wrong.is_none(), || format!("{comment} is printed as {wrong:?}"))?;
                    }
                }
            }
        }
        Ok(())
    });
}

// Order.

#[test]
fn the_end_of_the_program_is_the_last_thing_of_its_block() {
    row(|column| {
        let ended = |block: String| {
            let lines: Vec<&str> = column.head.iter().copied().chain(["M8", &block]).collect();
            column.bytes((lines.join("\n") + "\n").into_bytes())
        };
        for end in ["M2", "M30"] {
            // There M2 belongs to the machine.
            if end == "M2" && column.dialect == "heidenhain-turning" {
                continue;
            }
            let (behind, in_front) = (ended(format!("M9 {end}")), ended(format!("{end} M9")));
            same(&behind, &in_front, end)?;
            let last: Vec<&str> = path(&in_front).into_iter().rev().filter(|line| *line != "%").take(2).collect();
            hold(last == ["M30", "M9"] || last == ["M2", "M9"], || format!("{end} M9 is printed as {last:?}"))?;
        }
        Ok(())
    });
}

// What is not known.

#[test]
fn a_refused_block_is_one_finding() {
    row(|column| {
        let (to, by) = (column.to, column.by);
        for body in [
            vec![column.refused.to_owned(), by(3)],
            vec![column.refused.to_owned(), by(3), by(2), to(7), by(2), to(9)],
            vec![to(7), column.refused.to_owned(), to(9), by(-1)],
        ] {
            let body: Vec<&str> = body.iter().map(String::as_str).collect();
            let compiled = column.run(&body);
            hold(errors(&compiled).len() == 1, || format!("{body:?}: {:?}", compiled.rendered))?;
        }
        // A second mistake is a second finding.
        let twice = column.run(&[column.refused, &to(7), column.refused]);
        hold(errors(&twice).len() == 2, || format!("two mistakes: {:?}", twice.rendered))
    });
}

#[test]
fn a_value_that_is_lost_is_one_finding() {
    row(|column| {
        let Some(lost) = column.lost else { return Ok(()) };
        let compiled = column.run(&[&lost[..], &[&*(column.by)(3), &(column.to)(7)]].concat());
        hold(errors(&compiled).len() == 1, || format!("{lost:?}: {:?}", compiled.rendered))
    });
}

// Budgets.

#[test]
fn budgets_of_steps_and_of_output_stop_a_run() {
    row(|column| {
        let Some(forever) = column.forever else { return Ok(()) };
        let body = format!("{}\n{}", (column.to)(7), (column.to)(9));
        let text = column.text(&[&forever(&body)]).into_bytes();
        for (limit, code) in [("steps = 5000", "P4001"), ("output_blocks = 500", "P4002")] {
            let settings = column.settings(&format!("[limits]\n{limit}\n"));
            let compiled = compile_bytes(column.file, text.clone(), column.dialect, &settings, &NoFiles);
            refuses(&compiled, code, limit)?;
        }
        Ok(())
    });
}

// Calls.

#[test]
fn a_program_that_is_called_twice_moves_twice() {
    row(|column| {
        let Some(call) = column.call.map(|call| call(5)) else { return Ok(()) };
        let body = [call.as_str(), &(column.to)(3), &call];
        let good = column.run_with(&body, &|_| format!("{}\n{}", (column.to)(7), (column.to)(9)), 0);
        let places = path(&good).iter().filter(|line| line.contains(&(column.shown)(7))).count();
        hold(!good.has_errors() && places == 2, || format!("{:?}\n{}", good.rendered, good.output))?;
        let bad = column.run_with(&body, &|_| format!("{}\n{}", column.refused, (column.to)(9)), 0);
        hold(errors(&bad).len() == 1, || format!("a mistake in it: {:?}", bad.rendered))
    });
}

#[test]
fn calls_end() {
    row(|column| {
        let Some(call) = column.call else { return Ok(()) };
        let one = call(1);
        let itself = column.run_with(&[&one], &|n| call(n), 0);
        hold(errors(&itself).len() == 1, || format!("a program that calls itself: {:?}", itself.rendered))?;
        let ring = column.run_with(&[&one], &|n| call(3 - n), 0);
        hold(errors(&ring).len() == 1, || format!("two that call each other: {:?}", ring.rendered))?;
        let chain = column.run_with(&[&one], &|n| call(n + 1), 0);
        hold(errors(&chain).len() == 1, || format!("a chain without end: {:?}", chain.rendered))?;
        // The next block is not what the depth is to blame for.
        let two = column.run_with(&[&one], &|n| if n < 3 { call(n + 1) } else { (column.to)(7) }, 0);
        hold(!two.has_errors(), || format!("three levels: {:?}", two.rendered))
    });
}

#[test]
fn called_files_have_limits() {
    row(|column| {
        let Some(call) = column.call else { return Ok(()) };
        let calls: Vec<String> = (1..=1000).map(call).collect();
        let calls: Vec<&str> = calls.iter().map(String::as_str).collect();
        let move_ = |_| (column.to)(7);
        // The main program is one file, too.
        let fits = column.run_with(&calls[..999], &move_, 0);
        hold(!fits.has_errors(), || format!("1000 files: {:?}", &fits.rendered[..fits.rendered.len().min(3)]))?;
        refuses(&column.run_with(&calls, &move_, 0), "P0106", "1001 files")?;
        refuses(&column.run_with(&calls[..1], &move_, (256 << 20) + 1), "P0120", "a file over 256 MiB")
    });
}

#[test]
fn a_program_that_is_not_there_is_one_finding() {
    row(|column| {
        let Some(call) = column.call else { return Ok(()) };
        let body = [&*call(5), &(column.by)(3), &(column.to)(7)];
        refuses(&column.run(&body), column.missing, "a program that is not there")
    });
}

#[test]
fn hostile_names_open_nothing() {
    row(|column| {
        let Some(call) = column.call_by_name else { return Ok(()) };
        let folder = Folder::new(&format!("matrix_{}/inside", column.dialect));
        let secret = (column.program)(5, &(column.to)(7));
        for name in ["SECRET.H", "SECRET.SPF", "SECRET.MPF", "SECRET.ncs", "SECRET.nc", "SECRET"] {
            folder.write(&format!("../{name}"), &secret);
        }
        folder.write("partc.toml", column.settings);
        let absolute = folder.0.parent().expect("a folder").join("SECRET");
        let long = "A".repeat(5000);
        for name in [
            "../SECRET",
            "..\\SECRET",
            "../SECRET.H",
            "./../SECRET",
            "inside/../../SECRET",
            "/../SECRET",
            absolute.to_str().expect("UTF-8"),
            "/etc/passwd",
            "//server/share/SECRET",
            "\\\\server\\share\\SECRET",
            "C:\\SECRET",
            "C:SECRET",
            "file:SECRET",
            "SECRET:stream",
            "NUL",
            "CON.H",
            "COM1",
            "lpt9.spf",
            "..",
            ".",
            "/",
            "a*",
            "?",
            "~/SECRET",
            "$HOME/SECRET",
            "a\x01b",
            &long,
        ] {
            folder.write(column.file, &column.text(&[&call(name)]));
            let ran =
                folder.run(&["compile", column.file, "--format", "concise", "--dialect", column.dialect]).exits(1);
            let shown: String = name.chars().take(40).collect();
            hold(ran.err.contains("error[") && !ran.err.contains("panicked"), || format!("{shown}: {}", ran.err))?;
            let made: Vec<String> = folder.names().into_iter().filter(|name| name.ends_with("ngc")).collect();
            hold(made.is_empty(), || format!("{shown} makes {made:?}"))?;
        }
        Ok(())
    });
}

/// A NUL in a name is a hole in the program before it is a name.
#[test]
fn a_name_with_a_nul_is_refused() {
    row(|column| {
        let Some(call) = column.call_by_name else { return Ok(()) };
        let text = column.text(&[&call("A\0B")]).into_bytes();
        let files = Programs { column, size: 0, body: &|_| (column.to)(7) };
        let compiled = compile_bytes(column.file, text, column.dialect, &column.settings(""), &files);
        hold(compiled.has_errors(), || compiled.output.clone())
    });
}
