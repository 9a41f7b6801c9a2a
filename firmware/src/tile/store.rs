//! Storage that survives a power cut: key, boot counter and calibration, in two copies.
//!
//! In: a NOR flash with two pages, one for each copy, and the record. Out: the newest valid record. A record has a
//! version, a generation and a CRC, and is appended to a page; a full page is erased first. The second copy is written
//! only after the first has been read back, so a power cut at any write leaves at least one whole record: the old one
//! or the new one. Erasing stalls the flash for up to 2 s: store only while drives are off and the watchdog allows it.
//! Own code instead of a crate for wear-levelled storage: sequential-storage and ekv use futures, but a tick must end
//! in bounded time; the format of the former may change with its version, but a calibration outlives the program; and
//! one record of 48 bytes needs no map.

use crate::link::checksum::{checked, checksum};
use crate::link::message::Trim;
use embedded_storage::nor_flash::NorFlash;

/// Version of the layout.
const VERSION: u8 = 1;
/// Bytes of a record: version, generation, boot, key, four offsets, filling, CRC.
pub const RECORD: usize = 48;
/// Bytes of a record before its CRC.
const PLAIN: usize = RECORD - 4;

/// What is stored.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Record {
    /// Number of records stored before.
    pub generation: u32,
    /// Number of starts of the tile.
    pub boot: u32,
    /// Bytes of the key.
    pub key: [u8; 16],
    /// Offsets of the sensors.
    pub trim: Trim,
}

impl Record {
    /// As bytes.
    #[must_use]
    pub fn to_bytes(&self) -> [u8; RECORD] {
        let mut bytes = [0xFF; RECORD];
        let [a, b, c] = self.trim.height;
        let offsets = [a, b, c, self.trim.pressure].map(|x| x.to_bits().to_le_bytes());
        let fields =
            [VERSION].into_iter().chain(self.generation.to_le_bytes()).chain(self.boot.to_le_bytes());
        let fields = fields.chain(self.key).chain(offsets.into_iter().flatten());
        bytes.iter_mut().zip(fields).for_each(|(byte, field)| *byte = field);
        let (plain, sum) = bytes.split_at_mut(PLAIN);
        sum.copy_from_slice(&checksum(plain));
        bytes
    }

    /// From bytes, if version and CRC are right and the offsets are finite.
    #[must_use]
    pub fn from_bytes(bytes: &[u8; RECORD]) -> Option<Self> {
        let plain = checked(bytes)?;
        let (version, rest) = plain.split_first()?;
        let (generation, rest) = word(rest)?;
        let (boot, rest) = word(rest)?;
        let (key, mut rest) = rest.split_first_chunk::<16>()?;
        let mut offsets = [0.0; 4];
        for offset in &mut offsets {
            let (bits, after) = word(rest)?;
            *offset = f32::from_bits(bits);
            rest = after;
        }
        let [a, b, c, pressure] = offsets;
        let is_sound = *version == VERSION && offsets.iter().all(|x| x.is_finite());
        let trim = Trim { height: [a, b, c], pressure };
        is_sound.then_some(Self { generation, boot, key: *key, trim })
    }
}

fn word(bytes: &[u8]) -> Option<(u32, &[u8])> {
    let (word, rest) = bytes.split_first_chunk::<4>()?;
    Some((u32::from_le_bytes(*word), rest))
}

/// Two pages of a flash.
#[derive(Clone, Debug)]
pub struct Store<F> {
    flash: F,
    /// Address of each copy's page.
    pages: [u32; 2],
    /// Bytes of a page: a whole number of the flash's erase units.
    page: u32,
}

impl<F: NorFlash> Store<F> {
    /// The record in these pages of this size.
    pub fn new(flash: F, pages: [u32; 2], page: u32) -> Self {
        Self { flash, pages, page }
    }

    /// The newest valid record of either copy.
    pub fn load(&mut self) -> Option<Record> {
        let [a, b] = self.pages.map(|page| self.newest(page));
        match (a, b) {
            (Some(a), Some(b)) => Some(if b.generation > a.generation { b } else { a }),
            (a, b) => a.or(b),
        }
    }

    /// Stores a record with the next generation, and reads both copies back.
    ///
    /// # Errors
    /// The error of the flash, or None if the bytes read back differ.
    pub fn save(&mut self, record: &Record) -> Result<(), Option<F::Error>> {
        let generation = self.load().map_or(0, |old| old.generation.wrapping_add(1));
        let bytes = Record { generation, ..*record }.to_bytes();
        for page in self.pages {
            self.append(page, &bytes).map_err(Some)?;
            if self.newest(page).map(|r| r.generation) != Some(generation) {
                return Err(None);
            }
        }
        Ok(())
    }

    /// Called at each start: counts the boot and returns the record, or None if it cannot be read or stored.
    pub fn start(&mut self) -> Option<Record> {
        let old = self.load()?;
        let record = Record { boot: old.boot.checked_add(1)?, ..old };
        self.save(&record).ok()?;
        Some(record)
    }

    /// The flash.
    pub fn flash(&mut self) -> &mut F {
        &mut self.flash
    }

    fn places(&self, page: u32) -> impl Iterator<Item = u32> + use<F> {
        (0..self.page / RECORD as u32).map(move |n| page + n * RECORD as u32)
    }

    fn read(&mut self, place: u32) -> Option<[u8; RECORD]> {
        let mut bytes = [0; RECORD];
        self.flash.read(place, &mut bytes).ok()?;
        Some(bytes)
    }

    /// The valid record with the highest generation in a page.
    // Not inlined, like `append`: less stack and flash.
    #[inline(never)]
    fn newest(&mut self, page: u32) -> Option<Record> {
        let places = self.places(page);
        let good = places.filter_map(|place| self.read(place).and_then(|b| Record::from_bytes(&b)));
        good.max_by_key(|r| r.generation)
    }

    /// Writes to the first place never written; erases the page first if there is none.
    #[inline(never)]
    fn append(&mut self, page: u32, bytes: &[u8; RECORD]) -> Result<(), F::Error> {
        let mut places = self.places(page);
        let free = places.find(|place| self.read(*place) == Some([0xFF; RECORD]));
        let place = match free {
            Some(place) => place,
            None => {
                self.flash.erase(page, page + self.page)?;
                page
            }
        };
        self.flash.write(place, bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::{RECORD, Record, Store};
    use crate::link::message::Trim;
    use embedded_storage::nor_flash::{ErrorType, NorFlash, NorFlashError, NorFlashErrorKind, ReadNorFlash};
    use std::vec;
    use std::vec::Vec;

    const PAGE: u32 = 4 * RECORD as u32;

    /// A flash that loses power after so many words written or pages erased; half an erased page is noise.
    #[derive(Debug, Clone)]
    struct Flash {
        bytes: Vec<u8>,
        life: usize,
    }

    #[derive(Debug)]
    struct Cut;
    impl NorFlashError for Cut {
        fn kind(&self) -> NorFlashErrorKind {
            NorFlashErrorKind::Other
        }
    }
    impl ErrorType for Flash {
        type Error = Cut;
    }
    impl ReadNorFlash for Flash {
        const READ_SIZE: usize = 1;
        fn read(&mut self, offset: u32, bytes: &mut [u8]) -> Result<(), Cut> {
            bytes.copy_from_slice(&self.bytes[offset as usize..][..bytes.len()]);
            Ok(())
        }
        fn capacity(&self) -> usize {
            self.bytes.len()
        }
    }
    impl Flash {
        fn live(&mut self) -> Result<(), Cut> {
            self.life = self.life.checked_sub(1).ok_or(Cut)?;
            Ok(())
        }
    }
    impl NorFlash for Flash {
        const WRITE_SIZE: usize = 4;
        const ERASE_SIZE: usize = PAGE as usize;
        fn erase(&mut self, from: u32, to: u32) -> Result<(), Cut> {
            let page = from as usize..to as usize;
            if self.live().is_err() {
                self.bytes[page].iter_mut().step_by(3).for_each(|b| *b = 0x5A);
                return Err(Cut);
            }
            self.bytes[page].fill(0xFF);
            Ok(())
        }
        fn write(&mut self, offset: u32, bytes: &[u8]) -> Result<(), Cut> {
            for (n, word) in bytes.chunks(4).enumerate() {
                self.live()?;
                let place = offset as usize + 4 * n;
                // NOR flash can only clear bits.
                self.bytes[place..place + 4].iter_mut().zip(word).for_each(|(b, w)| *b &= w);
            }
            Ok(())
        }
    }

    fn store(life: usize) -> Store<Flash> {
        Store::new(Flash { bytes: vec![0xFF; 2 * PAGE as usize], life }, [0, PAGE], PAGE)
    }

    fn record(boot: u32) -> Record {
        let trim = Trim { height: [1e-3, -2e-3, 0.0], pressure: boot as f32 };
        Record { generation: 0, boot, key: [boot as u8; 16], trim }
    }

    #[test]
    fn a_record_comes_back_and_a_wrong_one_does_not() {
        let bytes = record(7).to_bytes();
        assert_eq!(Record::from_bytes(&bytes), Some(record(7)));
        for bit in 0..8 * RECORD {
            let mut wrong = bytes;
            wrong[bit / 8] ^= 1 << (bit % 8);
            assert_eq!(Record::from_bytes(&wrong), None, "bit {bit}");
        }
        let no_number = Trim { pressure: f32::NAN, ..record(7).trim };
        assert_eq!(Record::from_bytes(&Record { trim: no_number, ..record(7) }.to_bytes()), None);
    }

    #[test]
    fn an_empty_store_starts_no_life() {
        assert_eq!(store(1000).start(), None);
    }

    /// Power is cut at every word and every erasure of a save, over more saves than a page holds.
    #[test]
    fn a_cut_at_any_write_leaves_the_old_record_or_the_new_one() {
        let mut store = store(usize::MAX);
        for boot in 0..11 {
            store.save(&record(boot)).expect("there is power");
            let mut cuts = 0;
            for life in 0.. {
                let mut torn = Store::new(Flash { life, ..store.flash.clone() }, [0, PAGE], PAGE);
                let done = torn.save(&record(boot + 1)).is_ok();
                torn.flash.life = usize::MAX;
                let found = torn.load().expect("a record").boot;
                assert!(found == boot + 1 || (found == boot && !done), "{boot} cut at {life}: {found}");
                // And the next life goes on from it.
                assert_eq!(torn.start().map(|r| r.boot), Some(found + 1), "{boot} cut at {life}");
                if done {
                    break;
                }
                cuts += 1;
            }
            assert!(cuts >= 2 * RECORD / 4, "{cuts}");
        }
    }

    /// Power fails twice, at any two writes of saves that follow each other.
    #[test]
    fn two_cuts_in_a_row_leave_a_record_too() {
        let mut store = store(usize::MAX);
        (0..3).for_each(|boot| store.save(&record(boot)).expect("there is power"));
        for (first, second) in (0..60).flat_map(|first| (0..60).map(move |second| (first, second))) {
            let mut torn = Store::new(Flash { life: first, ..store.flash.clone() }, [0, PAGE], PAGE);
            let _ = torn.save(&record(3));
            torn.flash.life = second;
            let _ = torn.save(&record(4));
            torn.flash.life = usize::MAX;
            let found = torn.load().map(|r| r.boot);
            assert!(found.is_some_and(|boot| boot >= 2), "cut at {first}, then at {second}: {found:?}");
        }
    }

    #[test]
    fn one_copy_is_enough() {
        for page in [0, PAGE] {
            let mut store = store(usize::MAX);
            store.save(&record(3)).expect("there is power");
            store.flash().bytes[page as usize..][..PAGE as usize].fill(0);
            assert_eq!(store.load().map(|r| r.boot), Some(3));
            assert_eq!(store.start().map(|r| r.boot), Some(4), "a spoilt page is erased");
        }
    }
}
