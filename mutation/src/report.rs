//! The score: of the changes that compile, those that a test noticed.

use std::collections::BTreeMap;
use std::fs;
use std::io::Write;

use super::{Places, Result, list, tree, trial};

/// Prints the counts, and what nobody noticed with what was found about it.
pub fn report(places: &Places) -> Result<()> {
    let verdicts = trial::verdicts(places);
    let left_out = tree::left_out(places);
    let judged = judged(places)?;
    let sample = list::read(places)?;
    let count = |verdict: &str| verdicts.values().filter(|found| found.starts_with(verdict)).count();
    let (caught, timeouts) = (count("caught"), count("timeout"));
    let tried = verdicts.len();
    let unsaid = left_out.values().filter(|why| why.starts_with("not said")).count();
    let mut out = std::io::stdout().lock();
    let uncompiled = left_out.len() - unsaid;
    writeln!(out, "sample {}, do not compile {uncompiled}, not said {unsaid}, tried {tried}", sample.len())?;
    writeln!(out, "caught {caught}, timeouts {timeouts}, alive {}, unreached {}", count("alive"), count("unreached"))?;
    let score = 100.0 * (caught + timeouts) as f64 / tried.max(1) as f64;
    writeln!(out, "score {score:.1} %")?;
    let mut kinds: BTreeMap<&str, usize> = BTreeMap::new();
    let mut lines = Vec::new();
    for mutant in &sample {
        let verdict = verdicts.get(&mutant.number).map_or("", String::as_str);
        if verdict.starts_with("alive") || verdict.starts_with("unreached") {
            let (kind, why) = judged.get(&plain(&mutant.name)).map_or(("not judged", ""), |(kind, why)| (kind, why));
            *kinds.entry(kind).or_default() += 1;
            lines.push(format!("{}\t{kind}\t{}\t{why}", mutant.number, mutant.name));
        }
    }
    writeln!(out, "{kinds:?}\n{}", lines.join("\n"))?;
    Ok(())
}

/// What was found about changes that nobody noticed, by their names without the place: `mutation/judged.tsv`.
fn judged(places: &Places) -> Result<BTreeMap<String, (String, String)>> {
    let text = fs::read_to_string(places.project.join("mutation/judged.tsv"))?;
    let lines = text.lines().filter(|line| !line.starts_with('#')).map(|line| line.splitn(3, '\t').collect::<Vec<_>>());
    Ok(lines
        .filter_map(|fields| match fields[..] {
            [kind, name, why] => Some((name.to_owned(), (kind.to_owned(), why.to_owned()))),
            _ => None,
        })
        .collect())
}

/// `FILE:LINE:COLUMN: what` without line and column.
fn plain(name: &str) -> String {
    let (place, what) = name.split_once(": ").unwrap_or(("", name));
    format!("{}: {what}", place.split(':').next().unwrap_or_default())
}
