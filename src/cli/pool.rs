//! Many programs on several threads, their results in the order of the programs.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::thread;

/// What the main thread of a process has, too.
const STACK: usize = 8 << 20;

/// Does `work` for each item, on `jobs` threads where there are several items, and hands the results to `take` in the order
/// of the items.
///
/// # Panics
/// Where `work` does.
pub(super) fn in_order<T: Sync, R: Send>(
    jobs: Option<u16>,
    items: &[T],
    work: impl Fn(&T) -> R + Sync,
    mut take: impl FnMut(usize, R),
) {
    let jobs = jobs.map_or_else(|| thread::available_parallelism().map_or(1, usize::from), usize::from);
    if jobs.min(items.len()) < 2 {
        for (index, item) in items.iter().enumerate() {
            take(index, work(item));
        }
        return;
    }
    let next = AtomicUsize::new(0);
    thread::scope(|scope| {
        let (send, results) = mpsc::channel();
        for _ in 0..jobs.min(items.len()) {
            let (send, next, work) = (send.clone(), &next, &work);
            let run = move || {
                while let Some((index, item)) = {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    items.get(index).map(|item| (index, item))
                } {
                    // Nobody listens any more: another thread has panicked.
                    if send.send((index, work(item))).is_err() {
                        return;
                    }
                }
            };
            // Without a thread the others do its work; without any, this one.
            let _ = thread::Builder::new().stack_size(STACK).spawn_scoped(scope, run);
        }
        drop(send);
        let mut waiting = BTreeMap::new();
        let mut due = 0;
        for (index, result) in results {
            waiting.insert(index, result);
            while let Some(result) = waiting.remove(&due) {
                take(due, result);
                due += 1;
            }
        }
    });
    // No thread could be made.
    for (index, item) in items.iter().enumerate().skip(next.into_inner()) {
        take(index, work(item));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_come_in_the_order_of_the_items() {
        let items: Vec<u64> = (0..500).collect();
        for jobs in [1, 2, 7] {
            let mut seen = Vec::new();
            let work = |item: &u64| {
                thread::sleep(std::time::Duration::from_micros(item * 37 % 100));
                item * 2
            };
            in_order(Some(jobs), &items, work, |index, result| seen.push((index as u64, result)));
            assert_eq!(seen, items.iter().map(|item| (*item, item * 2)).collect::<Vec<_>>());
        }
    }

    #[test]
    #[should_panic(expected = "scoped thread panicked")]
    fn a_panic_is_not_lost() {
        in_order(Some(2), &[1, 2, 3], |item| assert_ne!(*item, 2), |_, ()| {});
    }
}
