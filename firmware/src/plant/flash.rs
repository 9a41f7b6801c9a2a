//! Two pages of flash in RAM that behave like the chip's: erasing sets bits, writing clears them, power may fail.

use crate::link::message::Trim;
use crate::tile::store::{RECORD, Record, Store};
use embedded_storage::nor_flash::{ErrorType, NorFlash, NorFlashError, NorFlashErrorKind, ReadNorFlash};

/// Bytes of a page.
const PAGE: usize = 4 * RECORD;

/// The flash.
#[derive(Clone, Debug)]
pub struct Flash {
    bytes: [u8; 2 * PAGE],
    /// Number of words and pages that can still be written or erased.
    life: u32,
}

/// The address is out of range, or power has failed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Unwritten;

impl NorFlashError for Unwritten {
    fn kind(&self) -> NorFlashErrorKind {
        NorFlashErrorKind::Other
    }
}

impl ErrorType for Flash {
    type Error = Unwritten;
}

impl Flash {
    /// Never written.
    #[must_use]
    pub fn new() -> Self {
        Self { bytes: [0xFF; 2 * PAGE], life: u32::MAX }
    }

    /// Lets power fail after this many words.
    pub fn set_life(&mut self, words: u32) {
        self.life = words;
    }

    fn place(&mut self, from: u32, length: usize) -> Result<&mut [u8], Unwritten> {
        let from = from as usize;
        let end = from.checked_add(length).ok_or(Unwritten)?;
        self.bytes.get_mut(from..end).ok_or(Unwritten)
    }

    fn live(&mut self) -> Result<(), Unwritten> {
        self.life = self.life.checked_sub(1).ok_or(Unwritten)?;
        Ok(())
    }
}

impl Default for Flash {
    fn default() -> Self {
        Self::new()
    }
}

impl ReadNorFlash for Flash {
    const READ_SIZE: usize = 1;
    fn read(&mut self, offset: u32, bytes: &mut [u8]) -> Result<(), Unwritten> {
        let place = self.place(offset, bytes.len())?;
        bytes.iter_mut().zip(place).for_each(|(to, from)| *to = *from);
        Ok(())
    }
    fn capacity(&self) -> usize {
        self.bytes.len()
    }
}

impl NorFlash for Flash {
    const WRITE_SIZE: usize = 4;
    const ERASE_SIZE: usize = PAGE;
    fn erase(&mut self, from: u32, to: u32) -> Result<(), Unwritten> {
        self.live()?;
        let length = to.checked_sub(from).ok_or(Unwritten)?;
        self.place(from, length as usize)?.fill(0xFF);
        Ok(())
    }
    fn write(&mut self, offset: u32, bytes: &[u8]) -> Result<(), Unwritten> {
        for (word, place) in bytes.chunks(Self::WRITE_SIZE).zip((offset..).step_by(Self::WRITE_SIZE)) {
            self.live()?;
            let to = self.place(place, word.len())?;
            to.iter_mut().zip(word).for_each(|(to, from)| *to &= from);
        }
        Ok(())
    }
}

/// A store with this key and no offsets, as delivered.
#[must_use]
pub fn provided(key: [u8; 16]) -> Store<Flash> {
    let mut store = Store::new(Flash::new(), [0, PAGE as u32], PAGE as u32);
    // A new flash takes a record; if it does not, the tile reports so at its start.
    let _ = store.save(&Record { generation: 0, boot: 0, key, trim: Trim::default() });
    store
}
