//! Memory of an image: flash (code, constants, initial values) and static RAM.

use object::elf::{SHF_ALLOC, SHF_WRITE};
use object::{Object, ObjectSection, SectionFlags, SectionKind};

/// Bytes by kind of memory.
#[derive(Clone, Copy, Default, PartialEq, Eq, Debug)]
pub struct Size {
    /// Flash (bytes).
    pub flash: u64,
    /// Static RAM, without the stack (bytes).
    pub ram: u64,
}

impl Size {
    /// Sums up the sections that are loaded.
    #[must_use]
    pub fn of(file: &object::File) -> Self {
        let mut size = Self::default();
        for section in file.sections() {
            let SectionFlags::Elf { sh_flags, .. } = section.flags() else { continue };
            if sh_flags.0 & SHF_ALLOC.0 == 0 {
                continue;
            }
            if sh_flags.0 & SHF_WRITE.0 != 0 {
                size.ram += section.size();
            }
            if section.kind() != SectionKind::UninitializedData {
                size.flash += section.size();
            }
        }
        size
    }
}
