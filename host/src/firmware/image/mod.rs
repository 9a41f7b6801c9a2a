//! An ELF image for a Cortex-M or a RISC-V core: its functions, its memory, and whether it obeys the rules.
//!
//! In: the bytes of the ELF. Out: [`Image`] (functions decoded once), then [`size::Size`], [`stack::Stack`] and the
//! list of broken rules ([`rules::findings`]). Invariant: an address is decoded as an instruction only where the ABI's
//! mapping symbols ($t, $x, $d) mark code.

pub mod checksum;
#[cfg(test)]
mod handmade;
pub mod rules;
pub mod size;
pub mod stack;
pub mod straight;
mod table;

use super::riscv;
use super::thumb::{self, Instruction, Kind};
use crate::failure::Failure;
use object::elf::SHF_EXECINSTR;
use object::{Architecture, Object, ObjectKind, ObjectSection, ObjectSymbol, SectionFlags, SymbolKind};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// A function of the image with the effects of its instructions.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Function {
    /// Readable name.
    pub name: String,
    /// Address of its first instruction.
    pub address: u32,
    /// Address after its last byte; bytes between functions are padding.
    pub end: u32,
    /// Number of its instructions.
    pub instructions: u64,
    /// Address and effect of every instruction that is not [`Kind::Other`].
    pub effects: Vec<(u32, Kind)>,
}

/// A decoded image.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Image {
    /// Functions by address.
    pub functions: Vec<Function>,
    /// Readable names of functions with their addresses; one address may have several.
    pub entries: Vec<(String, u32)>,
    /// Every defined symbol's readable name, sorted.
    pub symbols: Vec<String>,
    /// Addresses in the vector table: the reset handler, then the handlers of exceptions and interrupts.
    pub vectors: Vec<u32>,
    /// Bytes in flash and RAM.
    pub size: size::Size,
}

impl Image {
    /// Reads an image.
    ///
    /// # Errors
    /// A message if the bytes are not a little-endian ELF that is linked for ARM or RISC-V.
    pub fn read(elf: &[u8]) -> Result<Self, String> {
        let file = object::File::parse(elf).map_err(|e| format!("the image is not an ELF file: {e}"))?;
        let marks = marks(&file);
        let decode: Decode = match file.architecture() {
            Architecture::Arm => arm,
            Architecture::Riscv32 => |base, code, at| riscv::decode(address(base, at), &code[at..]),
            other => {
                return Err(format!(
                    "the code is of {other:?}; expected an image for a Cortex-M (ARM) or for RISC-V with 32 bits"
                ));
            }
        };
        if file.kind() != ObjectKind::Executable {
            return Err(format!("expected an executable image, not {:?}: link it first", file.kind()));
        }
        let mut functions = functions(&file);
        for section in file.sections() {
            let SectionFlags::Elf { sh_flags, .. } = section.flags() else { continue };
            if sh_flags.0 & SHF_EXECINSTR.0 != 0 {
                let code = section.data().map_err(|e| format!("section of code: {e}"))?;
                let base = word(section.address());
                decode_section(base, code, decode, &marks, &mut functions);
            }
        }
        let mut symbols: Vec<String> = file
            .symbols()
            .filter(|s| s.is_definition())
            .filter_map(|s| s.name().ok().map(readable))
            .collect();
        symbols.sort();
        symbols.dedup();
        let entries = text_symbols(&file).map(|(name, address, _)| (name, address)).collect();
        Ok(Self { functions, entries, symbols, vectors: vectors(&file), size: size::Size::of(&file) })
    }

    /// Reads a file.
    ///
    /// # Errors
    /// [`Failure::Wrong`] names the file and what is wrong with it.
    pub fn open(elf: &Path) -> Result<Self, Failure> {
        let wrong = |e: String| Failure::Wrong(format!("{}: {e}", elf.display()));
        Self::read(&fs::read(elf).map_err(|e| wrong(e.to_string()))?).map_err(wrong)
    }

    /// Index of the function that contains `address`.
    #[must_use]
    pub fn owner(&self, address: u32) -> Option<usize> {
        owner(&self.functions, address)
    }

    /// Index of the function of that name.
    #[must_use]
    pub fn find(&self, name: &str) -> Option<usize> {
        self.functions.iter().position(|f| f.name == name)
    }
}

/// The name as in the source, without the hash.
fn readable(name: &str) -> String {
    format!("{:#}", rustc_demangle::demangle(name))
}

/// An address as 32 bits; larger ones do not occur.
fn word(address: u64) -> u32 {
    u32::try_from(address).unwrap_or(u32::MAX)
}

/// All functions by address; if there are several names at an address, the first in the alphabet. A function without a
/// size, as in hand-written assembly, extends to the next one.
fn functions(file: &object::File) -> Vec<Function> {
    let mut found = BTreeMap::<u32, (u32, String)>::new();
    for (name, address, size) in text_symbols(file) {
        let entry = found.entry(address).or_insert((size, name.clone()));
        entry.0 = entry.0.max(size);
        entry.1 = entry.1.clone().min(name);
    }
    let nexts: Vec<u32> = found.keys().skip(1).copied().chain([u32::MAX]).collect();
    let with_ends = found.into_iter().zip(nexts);
    with_ends
        .map(|((address, (size, name)), next)| {
            let end = if size == 0 { next } else { address.saturating_add(size) };
            Function { name, address, end, instructions: 0, effects: Vec::new() }
        })
        .collect()
}

/// Name, address and size of every function's symbol.
fn text_symbols(file: &object::File) -> impl Iterator<Item = (String, u32, u32)> {
    let defined = file.symbols().filter(|s| s.kind() == SymbolKind::Text && s.is_definition());
    defined.filter_map(|symbol| {
        let name = symbol.name().ok().filter(|name| !name.is_empty() && !name.starts_with('$'))?;
        Some((readable(name), word(symbol.address()) & !1, word(symbol.size())))
    })
}

/// By address, whether code begins there: the mapping symbols of the ABI.
fn marks(file: &object::File) -> BTreeMap<u32, bool> {
    file.symbols()
        .filter_map(|s| Some((word(s.address()), s.name().ok()?)))
        .filter(|(_, name)| ["$t", "$x", "$d", "$a"].iter().any(|mark| name.starts_with(mark)))
        .map(|(address, name)| (address & !1, name.starts_with("$t") || name.starts_with("$x")))
        .collect()
}

/// Entries of the section `.vector_table` after the first, which is the initial value of sp.
fn vectors(file: &object::File) -> Vec<u32> {
    let section = file.section_by_name(".vector_table");
    let table = section.and_then(|s| s.data().ok()).unwrap_or_default();
    let words = table.as_chunks::<4>().0.iter().map(|b| u32::from_le_bytes(*b));
    words.skip(1).filter(|w| *w != 0).map(|w| w & !1).collect()
}

/// Index of the function that contains `address`.
fn owner(functions: &[Function], address: u32) -> Option<usize> {
    let last = functions.partition_point(|f| f.address <= address).checked_sub(1)?;
    functions.get(last).filter(|f| address < f.end).map(|_| last)
}

/// Decodes the instruction at a byte of this code, which begins at this address.
type Decode = fn(u32, &[u8], usize) -> Instruction;

fn arm(base: u32, code: &[u8], at: usize) -> Instruction {
    let half = |at: usize| code.get(at..at + 2).map_or(0, |b| u16::from_le_bytes([b[0], b[1]]));
    let instruction = thumb::decode(address(base, at), half(at), half(at + 2));
    if instruction.kind == Kind::IndirectJump && table::is_branch(base, half, at) {
        return Instruction { kind: Kind::Other, ..instruction };
    }
    instruction
}

/// Address of a byte of code that begins at `base`.
fn address(base: u32, at: usize) -> u32 {
    base.saturating_add(u32::try_from(at).unwrap_or(u32::MAX))
}

fn decode_section(
    base: u32,
    code: &[u8],
    decode: Decode,
    marks: &BTreeMap<u32, bool>,
    functions: &mut [Function],
) {
    let mut at = 0;
    while at + 2 <= code.len() {
        let address = address(base, at);
        let is_code = marks.range(..=address).next_back().is_some_and(|(_, code)| *code);
        let Some(function) = owner(functions, address).filter(|_| is_code) else {
            at += 2;
            continue;
        };
        let instruction = decode(base, code, at);
        at += instruction.size as usize;
        functions[function].instructions += 1;
        if instruction.kind != Kind::Other {
            functions[function].effects.push((address, instruction.kind));
        }
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::handmade::{Section, Symbol};
    use super::*;

    /// An image of functions given by halfwords, laid out from 0x0800_0000 in order.
    pub(crate) fn image(functions: &[(&str, &[u16])]) -> Image {
        let mut address = 0x0800_0000;
        let mut marks = BTreeMap::new();
        let mut decoded = Vec::new();
        let mut code = Vec::new();
        marks.insert(address, true);
        for (name, halves) in functions {
            let end = address + 2 * u32::try_from(halves.len()).unwrap();
            let name = (*name).to_owned();
            decoded.push(Function { name, address, end, instructions: 0, effects: Vec::new() });
            address = end;
            code.extend(halves.iter().flat_map(|h| h.to_le_bytes()));
        }
        decode_section(0x0800_0000, &code, arm, &marks, &mut decoded);
        let symbols = functions.iter().map(|(name, _)| (*name).to_owned()).collect();
        Image {
            functions: decoded,
            entries: Vec::new(),
            symbols,
            vectors: Vec::new(),
            size: size::Size::default(),
        }
    }

    #[test]
    fn data_and_padding_are_not_decoded() {
        let f = |address, end| {
            let name = "f".to_owned();
            Function { name, address, end, instructions: 0, effects: Vec::new() }
        };
        let mut functions = vec![f(0, 8), f(12, 14)];
        let halves = [0xB510_u16, 0xBD10, 0xB5F0, 0xB5F0, 0xD4D4, 0xD4D4, 0xB510];
        let code: Vec<u8> = halves.iter().flat_map(|h| h.to_le_bytes()).collect();
        let marks = BTreeMap::from([(0, true), (4, false), (8, true)]);
        decode_section(0, &code, arm, &marks, &mut functions);
        assert_eq!(functions[0].effects, [(0, Kind::Stack(8))]);
        assert_eq!(functions[1].effects, [(12, Kind::Stack(8))], "padding between functions is not code");
    }

    #[test]
    fn functions_are_defined_symbols_of_code() {
        const CODE: u8 = 2;
        let executable = u32::try_from(SHF_EXECINSTR.0).unwrap();
        let code = [0x10, 0xB5, 0x10, 0xBD, 0x00, 0xBF];
        let table = [0x0000_0400_u32, 0x41, 0, 0x43].map(u32::to_le_bytes).concat();
        let file = handmade::elf(
            &[Section(".text", 0x40, executable, &code), Section(".vector_table", 0, 0, &table)],
            &[
                Symbol("$t", 0x40, 0, 0, true),
                Symbol("second", 0x45, 0, CODE, true),
                Symbol("first", 0x41, 4, CODE, true),
                Symbol("alias", 0x41, 2, CODE, true),
                Symbol("elsewhere", 0x43, 2, CODE, false),
                Symbol("table", 0x42, 2, 1, true),
                Symbol("$t.7", 0x43, 2, CODE, true),
                Symbol("", 0x43, 2, CODE, true),
            ],
        );
        let image = Image::read(&file).unwrap();
        let found: Vec<_> = image.functions.iter().map(|f| (f.name.as_str(), f.address, f.end)).collect();
        assert_eq!(found, [("alias", 0x40, 0x44), ("second", 0x44, u32::MAX)]);
        assert_eq!(image.functions[0].effects, [(0x40, Kind::Stack(8))]);
        assert_eq!(image.symbols, ["", "$t", "$t.7", "alias", "first", "second", "table"]);
        assert_eq!(image.vectors, [0x40, 0x42]);
    }

    #[test]
    fn no_image_of_these_chips() {
        assert!(Image::read(b"MZ").unwrap_err().contains("not an ELF"));
        let image = handmade::elf(&[], &[]);
        assert!(Image::read(&image).is_ok());
        // The file's header: kind at byte 16, machine at byte 18.
        let changed = |place: usize, value: u8| {
            let mut image = image.clone();
            image[place] = value;
            Image::read(&image).unwrap_err()
        };
        assert!(changed(18, 3).contains("for a Cortex-M (ARM)"), "{}", changed(18, 3));
        assert!(changed(16, 1).contains("link it first"), "{}", changed(16, 1));
    }
}
