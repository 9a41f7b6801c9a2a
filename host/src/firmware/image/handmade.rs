//! Writes a small ELF (32 bits, little-endian, ARM) byte by byte, to test the code that reads ELFs.
//!
//! In: sections with their addresses and bytes, symbols. Out: the file. Layout: header, bytes of the sections,
//! including the symbols and all names, headers of the sections (System V ABI, chapter 4).

use object::elf::{EM_ARM, ET_EXEC, SHT_PROGBITS, SHT_STRTAB, SHT_SYMTAB};

/// Bytes of the header of the file, of a section and of a symbol.
const HEADER: u32 = 52;
const SECTION_HEADER: u32 = 40;
const SYMBOL: u32 = 16;

/// Name, address, flags and bytes.
pub struct Section<'a>(pub &'a str, pub u32, pub u32, pub &'a [u8]);

/// Name, address, size, type, and whether it is defined.
pub struct Symbol<'a>(pub &'a str, pub u32, pub u32, pub u8, pub bool);

/// A section as stored in the file.
struct Part<'a> {
    name: &'a str,
    kind: u32,
    flags: u32,
    address: u32,
    bytes: Vec<u8>,
    /// For symbols only: the section with the names, the first global symbol, bytes of an entry.
    table: [u32; 3],
}

/// The file.
pub fn elf(sections: &[Section], symbols: &[Symbol]) -> Vec<u8> {
    let part = |name, kind, bytes| Part { name, kind, flags: 0, address: 0, bytes, table: [0; 3] };
    let mut parts: Vec<Part> = sections
        .iter()
        .map(|&Section(name, address, flags, bytes)| Part {
            flags,
            address,
            ..part(name, SHT_PROGBITS.0, bytes.to_vec())
        })
        .collect();
    let names = length(&parts) + 2;
    let (table, texts) = table(symbols);
    parts.push(Part { table: [names, 1, SYMBOL], ..part(".symtab", SHT_SYMTAB.0, table) });
    parts.push(part(".strtab", SHT_STRTAB.0, texts));
    parts.push(part(".shstrtab", SHT_STRTAB.0, Vec::new()));
    let texts = parts.iter().flat_map(|part| [0].into_iter().chain(part.name.bytes()));
    let texts: Vec<u8> = texts.chain([0]).collect();
    parts.last_mut().expect("it was added").bytes = texts;

    let (mut at, mut name) = (HEADER, 1);
    let mut headers = vec![0; SECTION_HEADER as usize];
    for Part { name: text, kind, flags, address, bytes, table: [link, info, entry] } in &parts {
        let size = length(bytes);
        for word in [name, *kind, *flags, *address, at, size, *link, *info, 1, *entry] {
            headers.extend(word.to_le_bytes());
        }
        at += size;
        name += length(text.as_bytes()) + 1;
    }
    let mut file = header(at, length(&parts) + 1);
    parts.iter().for_each(|part| file.extend(&part.bytes));
    file.extend(headers);
    file
}

/// The file header; section headers begin at an offset, the last section holds their names.
fn header(sections: u32, count: u32) -> Vec<u8> {
    let mut file = vec![0x7F, b'E', b'L', b'F', 1, 1, 1];
    file.resize(16, 0);
    let half = |value: u32| u16::try_from(value).expect("a small file").to_le_bytes();
    file.extend([ET_EXEC.0, EM_ARM.0].into_iter().flat_map(u16::to_le_bytes));
    file.extend([1, 0, 0, sections, 0].into_iter().flat_map(u32::to_le_bytes));
    file.extend([HEADER, 0, 0, SECTION_HEADER, count, count - 1].into_iter().flat_map(half));
    file
}

/// Symbols as stored in the file, and their names.
fn table(symbols: &[Symbol]) -> (Vec<u8>, Vec<u8>) {
    let (mut table, mut texts) = (vec![0; SYMBOL as usize], vec![0]);
    for Symbol(name, address, size, kind, defined) in symbols {
        table.extend([length(&texts), *address, *size].into_iter().flat_map(u32::to_le_bytes));
        // Global, of the given type; in the first section, or undefined.
        table.extend([1 << 4 | kind, 0, u8::from(*defined), 0]);
        texts.extend(name.bytes().chain([0]));
    }
    (table, texts)
}

fn length<T>(of: &[T]) -> u32 {
    u32::try_from(of.len()).expect("a small file")
}
