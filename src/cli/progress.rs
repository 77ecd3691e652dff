//! Long work on one program says on a terminal that it goes on.
//!
//! A thread of its own says so: a loop may read nothing and print nothing for long.

use std::io::{self, IsTerminal, Write};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use crate::text::ReadAt;

/// Work shorter than this shows no progress.
pub(super) const QUIET: Duration = Duration::from_secs(1);
/// Progress changes so often.
pub(super) const AGAIN: Duration = Duration::from_millis(250);
/// Back to the begin of the line, which is emptied.
pub(super) const CLEARED: &str = "\r\x1b[K";

/// How far a program has been read.
#[derive(Debug, Clone, Default)]
pub(super) struct Place(Arc<Bytes>);

#[derive(Debug, Default)]
struct Bytes {
    at: AtomicU64,
    all: AtomicU64,
}

impl Place {
    /// The same text, whose reading moves the place.
    pub(super) fn follow(&self, text: Box<dyn ReadAt>) -> Box<dyn ReadAt> {
        self.0.all.store(text.len(), Ordering::Relaxed);
        Box::new(Followed { text, place: self.clone() })
    }

    fn per_cent(&self) -> u64 {
        let [at, all] = [&self.0.at, &self.0.all].map(|bytes| bytes.load(Ordering::Relaxed));
        (at.min(all) * 100).checked_div(all).unwrap_or(0)
    }
}

struct Followed {
    text: Box<dyn ReadAt>,
    place: Place,
}

impl ReadAt for Followed {
    fn len(&self) -> u64 {
        self.text.len()
    }

    fn read_at(&mut self, at: u64, buf: &mut [u8]) -> io::Result<usize> {
        let n = self.text.read_at(at, buf)?;
        self.place.0.at.store(at + n as u64, Ordering::Relaxed);
        Ok(n)
    }
}

/// Shows the place until it is dropped.
#[derive(Debug)]
pub(super) struct Ticker {
    running: Option<(Sender<()>, JoinHandle<()>)>,
}

impl Ticker {
    /// Silent unless somebody looks at a terminal and the program is `alone`.
    pub(super) fn start(alone: bool, place: &Place) -> Ticker {
        if !alone || !io::stderr().is_terminal() {
            return Ticker { running: None };
        }
        let (send, ended) = mpsc::channel();
        let place = place.clone();
        let show = move || {
            let (start, mut pause) = (Instant::now(), QUIET);
            while let Err(RecvTimeoutError::Timeout) = ended.recv_timeout(pause) {
                let (read, seconds) = (place.per_cent(), start.elapsed().as_secs());
                let _ = write!(io::stderr(), "{CLEARED}{read} % of the program read, {seconds} s");
                pause = AGAIN;
            }
            if pause == AGAIN {
                let _ = write!(io::stderr(), "{CLEARED}");
            }
        };
        // Without a thread the work goes on in silence.
        let running = thread::Builder::new().spawn(show).ok().map(|thread| (send, thread));
        Ticker { running }
    }
}

impl Drop for Ticker {
    fn drop(&mut self) {
        if let Some((send, thread)) = self.running.take() {
            drop(send);
            let _ = thread.join();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::Memory;

    #[test]
    fn a_place_is_where_the_program_is_read() {
        let place = Place::default();
        assert_eq!(place.per_cent(), 0);
        let mut text = place.follow(Box::new(Memory::new(vec![b' '; 400])));
        for (at, per_cent) in [(0, 25), (100, 50), (300, 100), (0, 25)] {
            assert_eq!((text.read_at(at, &mut [0; 100]).unwrap(), place.per_cent()), (100, per_cent));
        }
        place.follow(Box::new(Memory::new(Vec::new())));
        assert_eq!(place.per_cent(), 0);
    }
}
