//! Receivers whose programs our own front ends read: what is printed for them is compiled again, and has to move as the output
//! for LinuxCNC does.

use std::collections::BTreeMap;

use partc::internals::machine::MachineKind;
use partc::internals::machine::settings::Settings;
use partc::internals::target;

use super::common::{Compiled, settings};
use super::meant::{Does, Found, Way};
use super::reader;
use super::rewritten::{compiled, programs, same};

/// Around a tap each control starts and stops the spindle in its own words: there its state is what counts, at each move.
fn spindle_at_moves(found: Vec<Found>) -> Vec<Found> {
    if !found.iter().any(|one| matches!(one, Found::Does(Does::Tap { .. }))) {
        return found;
    }
    let (mut speed, mut turns) = (0.0, 0);
    let mut list = Vec::new();
    for one in found {
        match one {
            Found::Does(Does::Speed(0, now)) => speed = now,
            Found::Does(Does::Turns(0, now)) => turns = now,
            Found::Does(Does::Orient(0, _)) => {}
            Found::Move(way, how) => {
                list.push(Found::Does(Does::Turns(0, turns)));
                if !matches!(way, Way::Rapid(_)) {
                    list.push(Found::Does(Does::Speed(0, speed)));
                }
                list.push(Found::Move(way, how));
            }
            Found::Does(other) => list.push(Found::Does(other)),
        }
    }
    list
}

/// A speed that holds already says nothing.
fn without_the_same_speed(mut found: Vec<Found>) -> Vec<Found> {
    let mut last = None;
    found.retain(|one| !matches!(one, Found::Does(Does::Speed(0, speed)) if last.replace(*speed) == Some(*speed)));
    found
}

/// A receiver whose programs our own front end reads.
struct Own {
    target: &'static str,
    dialect: &'static str,
    file: &'static str,
    /// What its programs need said on a mill and on a lathe.
    mill: &'static str,
    lathe: &'static str,
    /// Golden programs that are printed at least.
    least: usize,
}

#[test]
fn plain_programs_for_a_sinumerik_mean_the_same_to_our_own_front_end() {
    read_by_its_own_front_end(&Own {
        target: "sinumerik",
        dialect: "sinumerik",
        file: "AGAIN.MPF",
        mill: "[control]\ntool_change = \"m6\"",
        lathe: "[machine]\nkind = \"lathe\"\ndiameter_axis = \"X\"\n[control]\ntool_change = \"m6\"",
        least: 700,
    });
}

#[test]
fn plain_klartext_means_the_same_to_our_own_front_end() {
    read_by_its_own_front_end(&Own {
        target: "heidenhain",
        dialect: "klartext",
        file: "AGAIN.H",
        mill: "",
        lathe: "",
        least: 700,
    });
}

/// What is printed for a control, read by our own front end, moves as the output for LinuxCNC does.
fn read_by_its_own_front_end(own: &Own) {
    let (mut wrong, mut printed, mut refused) = (Vec::new(), 0, BTreeMap::<&str, usize>::new());
    for case in programs() {
        let mut base = case.settings();
        let lathe = base.machine.kind == MachineKind::Lathe;
        base.output.tool_length = Some(false);
        base.output.compensation = Default::default();
        base.output.diameter = None;
        base.output.comments = false;
        // Feeds of as many places as any of them reads.
        base.output.decimals.feed = base.output.decimals.feed.or(Some(3));
        // Its thinnest arcs have another radius.
        let print = |name: &str, file: &str, dialect: &str, program: Vec<u8>, base: &Settings| {
            let mut settings = base.clone();
            settings.output.target = target::find(name).expect("a target");
            compiled(file, program, dialect, &settings, case)
        };
        let plain = print("linuxcnc", &case.file, &case.dialect, case.program.clone(), &base);
        if plain.has_errors() {
            continue;
        }
        let other = print(own.target, &case.file, &case.dialect, case.program.clone(), &base);
        // That an offset is a preset changes no move.
        let codes = |compiled: &Compiled| -> Vec<&'static str> {
            let own = |code: &&str| code.starts_with('O') && *code != "O4003";
            compiled.findings.iter().map(|found| found.code.id).filter(own).collect()
        };
        if other.has_errors() {
            let codes = codes(&other);
            match codes.iter().find(|code| code.starts_with("O93") || **code == "O9003") {
                Some(code) => *refused.entry(*code).or_default() += 1,
                None => wrong.push(format!("{}: fails with {:?}", case.name, other.rendered)),
            }
            continue;
        }
        if codes(&other) != codes(&plain) {
            *refused.entry("as lines").or_default() += 1;
            continue;
        }
        let mut again = settings(if lathe { own.lathe } else { own.mill });
        again.output.decimals = base.output.decimals;
        again.output.pass_m = (0..1000).collect();
        let text = other.output.clone().into_bytes();
        let read_again = print("linuxcnc", own.file, own.dialect, text, &again);
        if read_again.has_errors() {
            wrong.push(format!("{}: {:?}", case.name, read_again.rendered));
            continue;
        }
        printed += 1;
        let decimals = base.output.places(partc::internals::machine::settings::Quantity::Length);
        let read = |text: &str| reader::read(text, decimals).map(without_the_same_speed).map(spindle_at_moves);
        // A SINUMERIK says of its corners what LinuxCNC says, but for a bound that both print rounded.
        let corners = |found: &[Found]| -> Vec<i64> {
            let bounds = found.iter().filter_map(|one| match one {
                Found::Move(_, how) => how.corners,
                Found::Does(_) => None,
            });
            bounds.map(|bound| (bound.min(1e3) * 1e5).round() as i64).collect::<Vec<_>>()
        };
        if own.target == "sinumerik" {
            let both = [&plain.output, &read_again.output].map(|text| {
                read(text).map(|found| {
                    let mut bounds = corners(&found);
                    bounds.dedup();
                    bounds
                })
            });
            if both[0] != both[1] {
                wrong.push(format!("{}: other corners: {both:?}", case.name));
            }
        }
        let found = read(&plain.output).and_then(|plain| same(&plain, &read(&read_again.output)?, f64::INFINITY));
        if let Err(why) = found {
            wrong.push(format!("{}: {why}", case.name));
        }
    }
    println!("{}: printed {printed}, refused {refused:?}", own.target);
    wrong.iter().for_each(|why| println!("{}", why.chars().take(300).collect::<String>()));
    assert!(wrong.is_empty(), "{} of {printed} wrong", wrong.len());
    assert!(printed > own.least, "{printed} printed, {refused:?} refused");
}
