//! The text of a model (its file and those it extends) and places in it.

use std::sync::Arc;

/// A byte range of a [`Source`].
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, PartialOrd, Ord)]
pub struct Span {
    /// First byte.
    pub start: usize,
    /// One past the last byte.
    pub end: usize,
    /// Which file of the source (0: the model itself; others through `extends`).
    pub file: u32,
}

/// One file's name and text.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct File {
    /// Path as the user wrote it, never absolute unless given so.
    pub path: String,
    /// Its text.
    pub text: String,
    /// Places of its line breaks, ascending: every declaration of a model asks for its line.
    breaks: Vec<usize>,
}

/// The model file and the files it extends. Cheap to clone.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Source {
    /// Files; the first is the model itself.
    pub files: Arc<Vec<File>>,
}

impl File {
    /// A file by name and text.
    #[must_use]
    pub fn new(path: String, text: String) -> Self {
        let breaks = text.match_indices('\n').map(|(place, _)| place).collect();
        Self { path, text, breaks }
    }

    /// The last part of the model's path. Emitted text uses this alone, so that it does not depend on the folder.
    #[must_use]
    pub fn name(&self) -> &str {
        self.path.rsplit(['/', '\\']).next().unwrap_or(&self.path)
    }
}

impl Source {
    /// A source of one file.
    #[must_use]
    pub fn new(path: &str, text: &str) -> Self {
        Self { files: Arc::new(vec![File::new(path.to_owned(), text.to_owned())]) }
    }

    /// Line and column (both from 1, columns in characters) of the start of `span`.
    #[must_use]
    pub fn line_column(&self, span: Span) -> (usize, usize) {
        let Some(file) = self.files.get(span.file as usize) else { return (1, 1) };
        let mut end = span.start.min(file.text.len());
        while !file.text.is_char_boundary(end) {
            end -= 1;
        }
        let line = file.breaks.partition_point(|&place| place < end);
        let start = line.checked_sub(1).map_or(0, |before| file.breaks[before] + 1);
        (line + 1, file.text[start..end].chars().count() + 1)
    }

    /// File and line of the start of `span`, such as `tile.toml:11`.
    #[must_use]
    pub fn place(&self, span: Span) -> String {
        let file = self.files.get(span.file as usize).map_or("", File::name);
        [file, ":", &self.line_column(span).0.to_string()].concat()
    }

    /// FNV-1a, 64 bits, of the text of all files.
    #[must_use]
    pub fn fingerprint(&self) -> u64 {
        fnv1a(self.files.iter().flat_map(|file| file.text.bytes()))
    }
}

/// Fowler, Noll and Vo's hash (FNV-1a, 64 bits): the same on every machine.
#[must_use]
pub fn fnv1a(bytes: impl Iterator<Item = u8>) -> u64 {
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}
