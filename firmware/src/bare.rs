//! The controller linked for a core without a board: a station whose line, store and readings are memory of unknown
//! content. It is only built to be measured (`smartbed tile --budget`), which shows the cost of a port to RISC-V; it
//! runs nowhere.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(not(target_os = "none"))]
fn main() -> std::process::ExitCode {
    eprintln!("this program is to be measured: `cargo smartbed tile --budget` builds it");
    std::process::ExitCode::FAILURE
}

#[cfg(target_os = "none")]
#[expect(unsafe_code, reason = "the linker finds the entry by its plain name")]
mod bare {
    use core::hint::black_box;
    use embedded_storage::nor_flash::{ErrorType, NorFlash, NorFlashError, NorFlashErrorKind, ReadNorFlash};
    use smartbed_firmware::link::serial::{Line, Serial};
    use smartbed_firmware::node::Node;
    use smartbed_firmware::station::Station;
    use smartbed_firmware::tile::board::Readings;
    use smartbed_firmware::tile::integrity::Program;
    use smartbed_firmware::tile::store::Store;

    /// Bytes of a page.
    const PAGE: u32 = 0x4000;

    /// A line and a flash whose content the compiler cannot know.
    #[derive(Default)]
    struct Memory;

    #[derive(Debug)]
    struct Refused;

    impl Line for Memory {
        fn read(&mut self) -> Option<u8> {
            black_box(None)
        }
        fn write(&mut self, byte: u8) -> bool {
            black_box(byte) != 0
        }
    }

    impl NorFlashError for Refused {
        fn kind(&self) -> NorFlashErrorKind {
            NorFlashErrorKind::Other
        }
    }

    impl ErrorType for Memory {
        type Error = Refused;
    }

    impl ReadNorFlash for Memory {
        const READ_SIZE: usize = 1;
        fn read(&mut self, offset: u32, bytes: &mut [u8]) -> Result<(), Refused> {
            bytes.iter_mut().for_each(|byte| *byte = black_box(offset as u8));
            black_box(Ok(()))
        }
        fn capacity(&self) -> usize {
            2 * PAGE as usize
        }
    }

    impl NorFlash for Memory {
        const WRITE_SIZE: usize = 4;
        const ERASE_SIZE: usize = PAGE as usize;
        fn erase(&mut self, from: u32, to: u32) -> Result<(), Refused> {
            black_box((from, to));
            black_box(Ok(()))
        }
        fn write(&mut self, offset: u32, bytes: &[u8]) -> Result<(), Refused> {
            black_box((offset, bytes));
            black_box(Ok(()))
        }
    }

    /// Ticks for ever. Setting up stack pointer and memory would be a board's part.
    #[unsafe(no_mangle)]
    extern "C" fn _start() -> ! {
        let store = Store::new(Memory, [0, PAGE], PAGE);
        let node = Node::new(black_box(0), store, black_box(0));
        let mut station = Station::new(node, Serial::<Memory>::default(), black_box(Program::default()), 0);
        loop {
            let readings = black_box(Readings::at_rest());
            black_box(station.tick(&readings, black_box(Program::default())));
        }
    }

    /// Never linked in: the image's checks refuse any code that could call it.
    #[panic_handler]
    fn panic(_: &core::panic::PanicInfo) -> ! {
        loop {
            core::hint::spin_loop();
        }
    }
}
