//! The score: of the changes that compile, those that a test noticed.

use super::{Places, Result, list, tree, trial};

/// Prints the counts and each change that nobody noticed.
pub fn report(places: &Places) -> Result<()> {
    let verdicts = trial::verdicts(places);
    let left_out = tree::left_out(places);
    let sample = list::read(places)?;
    let count = |verdict: &str| verdicts.values().filter(|found| found.starts_with(verdict)).count();
    let (caught, timeouts) = (count("caught"), count("timeout"));
    let tried = verdicts.len();
    let score = 100.0 * (caught + timeouts) as f64 / tried.max(1) as f64;
    println!("sample {}, left out of the build {}, tried {tried}", sample.len(), left_out.len());
    println!("caught {caught}, timeouts {timeouts}, alive {}, unreached {}", count("alive"), count("unreached"));
    println!("score {score:.1} %");
    for mutant in &sample {
        let verdict = verdicts.get(&mutant.number).map_or("", String::as_str);
        if verdict.starts_with("alive") || verdict.starts_with("unreached") {
            println!("{}\t{}\t{}", mutant.number, verdict.split('\t').next().unwrap_or_default(), mutant.name);
        }
    }
    Ok(())
}
