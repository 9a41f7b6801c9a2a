//! Writes into a controller's image the checksum by which the controller checks its own program.
//!
//! In: an ELF of the controller. Out: the same with a checksum over its vectors and over all bytes from the beginning
//! of the code to the end of the constants, in its section `.checksum`; the linker cannot compute it. A controller
//! without a valid checksum refuses to move anything.

use object::elf::SHF_ALLOC;
use object::{Object, ObjectSection, ObjectSymbol, SectionFlags};
use smartbed_firmware::link::checksum::checksum;

/// The section of the checksum.
const SECTION: &str = ".checksum";
/// The linker's symbols at the beginning and end of each range: the vectors, then code and constants.
const BOUNDS: [[&str; 2]; 2] = [["__svectors", "__evectors"], ["__stext", "__erodata"]];

/// Writes the checksum.
///
/// # Errors
/// A message if the ELF has no place for it, or the ranges have gaps.
pub fn write(elf: &mut [u8]) -> Result<(), String> {
    let file = object::File::parse(&*elf).map_err(|e| format!("the image is not an ELF file: {e}"))?;
    let program =
        BOUNDS.map(|bounds| between(&file, bounds)).into_iter().collect::<Result<Vec<_>, _>>()?.concat();
    let place = file.section_by_name(SECTION).and_then(|section| section.file_range());
    let (offset, _) = place.ok_or_else(|| format!("the image has no section {SECTION}"))?;
    let offset = usize::try_from(offset).map_err(|e| e.to_string())?;
    let sum = checksum(&program);
    let word = elf.get_mut(offset..).and_then(|rest| rest.first_chunk_mut::<4>());
    *word.ok_or_else(|| format!("{SECTION} is shorter than a checksum"))? = sum;
    Ok(())
}

/// The bytes between two symbols.
fn between(file: &object::File, bounds: [&str; 2]) -> Result<Vec<u8>, String> {
    let bound = |name: &str| {
        let found = file.symbols().find(|s| s.name() == Ok(name)).map(|s| s.address());
        found.ok_or_else(|| format!("the image has no symbol {name}"))
    };
    let (begin, end) = (bound(bounds[0])?, bound(bounds[1])?);
    // Sections that are not loaded have the address 0, which is also that of the vectors of some chips.
    let is_loaded = |flags: SectionFlags| matches!(flags, SectionFlags::Elf { sh_flags, .. } if sh_flags.0 & SHF_ALLOC.0 != 0);
    let here = |section: &object::Section| {
        (begin..end).contains(&section.address()) && section.size() > 0 && is_loaded(section.flags())
    };
    let mut sections: Vec<_> = file.sections().filter(here).collect();
    sections.sort_by_key(ObjectSection::address);
    let mut bytes = Vec::new();
    for section in sections {
        let here = begin + bytes.len() as u64;
        if section.address() != here {
            let name = section.name().unwrap_or("?");
            return Err(format!("{name} begins at {:#x}, behind a gap from {here:#x} on", section.address()));
        }
        bytes.extend_from_slice(section.data().map_err(|e| format!("a section of the program: {e}"))?);
    }
    let found = bytes.len() as u64;
    if begin + found != end {
        let [from, to] = bounds;
        return Err(format!("{found} bytes lie between {from} and {to}, not {}", end.saturating_sub(begin)));
    }
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::super::handmade::{Section, Symbol, elf};
    use super::*;

    const VECTORS: [u8; 4] = [10, 11, 12, 13];
    const CODE: [u8; 6] = [1, 2, 3, 4, 5, 6];
    const CONSTANTS: [u8; 2] = [7, 8];

    /// A program of vectors, code and constants that begin at an address, with its checksum after its bounds. A section
    /// that is not loaded has the address of the vectors.
    fn program(constants: u32) -> Vec<u8> {
        elf(
            &[
                Section(".rodata", constants, 2, &CONSTANTS),
                Section(".text", 0x100, 6, &CODE),
                Section(".init", 0x103, 6, &[]),
                Section(".vector_table", 0, 2, &VECTORS),
                Section(".debug_info", 0, 0, &[99; 8]),
                Section(SECTION, 0x108, 2, &[0xFF; 4]),
                Section(".data", 0x2000_0000, 3, &[9; 4]),
            ],
            &[
                Symbol("__svectors", 0, 0, 0, true),
                Symbol("__evectors", 4, 0, 0, true),
                Symbol("__stext", 0x100, 0, 0, true),
                Symbol("__erodata", 0x108, 0, 0, true),
            ],
        )
    }

    #[test]
    fn the_sum_is_that_of_vectors_code_and_constants_in_order() {
        let mut written = program(0x106);
        let before = written.clone();
        write(&mut written).unwrap();
        let sum = checksum(&[&VECTORS[..], &CODE, &CONSTANTS].concat());
        let changed: Vec<_> = (0..written.len()).filter(|&i| written[i] != before[i]).collect();
        let first = changed[0];
        assert_eq!(written[first..first + 4], sum);
        assert!(changed.iter().all(|i| (first..first + 4).contains(i)));
    }

    #[test]
    fn a_gap_or_an_overlap_is_refused() {
        let refused = |constants| write(&mut program(constants)).unwrap_err();
        assert!(refused(0x107).contains(".rodata begins at 0x107, behind a gap from 0x106 on"));
        assert!(refused(0x105).contains(".rodata begins at 0x105"));
        assert!(refused(0x200).contains("6 bytes lie between __stext and __erodata, not 8"));
    }
}
