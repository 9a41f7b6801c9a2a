//! The controller and a simulated tile in lock-step with a host: on the chip through a serial line, on the host
//! through standard input and output. The same library, so the same bytes.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(not(target_os = "none"))]
fn main() -> std::process::ExitCode {
    use smartbed_firmware::lockstep::{Host, Last, serve};
    use smartbed_firmware::tile::integrity::Program;
    use std::io::{BufReader, BufWriter, Read, Stdin, Stdout, Write, stdin, stdout};

    /// Pipes; output is flushed before waiting for input.
    struct Pipes(BufReader<Stdin>, BufWriter<Stdout>);
    impl Host for Pipes {
        fn read(&mut self) -> Option<u8> {
            if self.0.buffer().is_empty() {
                self.1.flush().ok()?;
            }
            let mut byte = [0];
            self.0.read_exact(&mut byte).ok().map(|()| byte[0])
        }
        fn write(&mut self, byte: u8) {
            // That the host is gone is noticed when reading.
            let _ = self.1.write_all(&[byte]);
        }
    }

    let mut pipes = Pipes(BufReader::new(stdin()), BufWriter::new(stdout()));
    let last = serve(&mut pipes, Program::default(), 0);
    0_u32.to_le_bytes().into_iter().for_each(|byte| pipes.write(byte));
    let is_done = pipes.1.flush().is_ok() && last == Last::End;
    if is_done { std::process::ExitCode::SUCCESS } else { std::process::ExitCode::FAILURE }
}

#[cfg(target_os = "none")]
#[expect(unsafe_code, reason = "registers and the stack are reached by address")]
#[path = "chip/lockstep.rs"]
mod chip;
