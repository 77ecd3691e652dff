//! Arrow IPC files.
//!
//! The dictionaries stand behind the batches, where all their words are known: many readers take no dictionary that grows. The
//! format allows it, since its last part lists where they are.

use std::io::{self, Write};

use arrow_array::RecordBatch;
use arrow_ipc::convert::IpcSchemaEncoder;
use arrow_ipc::writer::{
    DictionaryTracker, EncodedData, IpcDataGenerator, IpcWriteContext, IpcWriteOptions, write_message,
};
use arrow_ipc::{Block, FooterBuilder};
use arrow_schema::ArrowError;
use flatbuffers::FlatBufferBuilder;

use super::schema::schema;

/// How the file begins and ends.
const MAGIC: &[u8] = b"ARROW1";
/// Bytes in front of the first message.
const HEAD: usize = 64;
/// No message follows.
const END: &[u8] = &[0xff, 0xff, 0xff, 0xff, 0, 0, 0, 0];

/// A file that is being written.
pub struct ArrowFile<W> {
    out: W,
    options: IpcWriteOptions,
    tracker: DictionaryTracker,
    context: IpcWriteContext,
    /// Bytes so far.
    at: usize,
    batches: Vec<Block>,
    /// The last batch, which has all words.
    last: RecordBatch,
}

impl<W> std::fmt::Debug for ArrowFile<W> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("ArrowFile").field("at", &self.at).finish_non_exhaustive()
    }
}

impl<W: Write> ArrowFile<W> {
    pub fn open(mut out: W) -> io::Result<ArrowFile<W>> {
        let (options, mut tracker) = (IpcWriteOptions::default(), DictionaryTracker::new(false));
        out.write_all(MAGIC)?;
        out.write_all(&[0; HEAD - MAGIC.len()])?;
        let described =
            IpcDataGenerator::default().schema_to_bytes_with_dictionary_tracker(&schema(), &mut tracker, &options);
        let last = RecordBatch::new_empty(schema());
        let context = IpcWriteContext::default();
        let mut file = ArrowFile { out, options, tracker, context, at: HEAD, batches: Vec::new(), last };
        file.message(described)?;
        Ok(file)
    }

    /// Writes a message; its place.
    fn message(&mut self, message: EncodedData) -> io::Result<Block> {
        let (head, body) = write_message(&mut self.out, message, &self.options).map_err(of_arrow)?;
        let too_long = |_| io::Error::other("the file gets too long");
        let place = Block::new(
            i64::try_from(self.at).map_err(too_long)?,
            i32::try_from(head).map_err(too_long)?,
            i64::try_from(body).map_err(too_long)?,
        );
        self.at += head + body;
        Ok(place)
    }

    fn encoded(&mut self, batch: &RecordBatch) -> Result<(Vec<EncodedData>, EncodedData), ArrowError> {
        IpcDataGenerator::default().encode(batch, &mut self.tracker, &self.options, &mut self.context)
    }

    pub fn write(&mut self, batch: &RecordBatch) -> io::Result<()> {
        // Its dictionaries come at the end.
        let (_, message) = self.encoded(batch).map_err(of_arrow)?;
        let place = self.message(message)?;
        self.batches.push(place);
        self.last = batch.slice(0, 0);
        Ok(())
    }

    pub fn finish(mut self) -> io::Result<W> {
        self.tracker = DictionaryTracker::new(false);
        let mut numbers = DictionaryTracker::new(false);
        let described = IpcDataGenerator::default().schema_to_bytes_with_dictionary_tracker(
            &schema(),
            &mut self.tracker,
            &self.options,
        );
        drop(described);
        let last = self.last.clone();
        let (words, _) = self.encoded(&last).map_err(of_arrow)?;
        let mut dictionaries = Vec::new();
        for message in words {
            dictionaries.push(self.message(message)?);
        }
        self.out.write_all(END)?;
        let mut footer = FlatBufferBuilder::new();
        let dictionaries = footer.create_vector(&dictionaries);
        let batches = footer.create_vector(&self.batches);
        let described =
            IpcSchemaEncoder::new().with_dictionary_tracker(&mut numbers).schema_to_fb_offset(&mut footer, &schema());
        let mut builder = FooterBuilder::new(&mut footer);
        builder.add_version(arrow_ipc::MetadataVersion::V5);
        builder.add_schema(described);
        builder.add_dictionaries(dictionaries);
        builder.add_recordBatches(batches);
        let root = builder.finish();
        footer.finish(root, None);
        let bytes = footer.finished_data();
        let length = i32::try_from(bytes.len()).map_err(|_| io::Error::other("the file gets too long"))?;
        self.out.write_all(bytes)?;
        self.out.write_all(&length.to_le_bytes())?;
        self.out.write_all(MAGIC)?;
        Ok(self.out)
    }
}

pub(super) fn of_arrow(error: ArrowError) -> io::Error {
    match error {
        ArrowError::IoError(_, error) => error,
        other => io::Error::other(other.to_string()),
    }
}
