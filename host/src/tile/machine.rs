//! A running tile: an emulated chip connected by a socket, or the same program on this machine connected by pipes.

use crate::failure::Failure;
use crate::firmware::chip::Chip;
use crate::firmware::compile;
use crate::firmware::process::clean;
use crate::firmware::settings::{Settings, Subject};
use crate::firmware::toolchain;
use crate::firmware::workspace::{lock, workspace};
use crate::output;
use smartbed_firmware::turns::{BREAK, END, HELLO, MOST_TICKS, TICKS};
use std::io::{BufReader, Read, Write};
use std::os::unix::net::UnixListener;
use std::path::{Path, PathBuf};
use std::process::{Child, Stdio};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Time limit for the emulator to connect.
const PATIENCE: Duration = Duration::from_secs(30);

/// Where a tile runs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// On emulated chips of this kind.
    Emulated(Chip),
    /// On this machine.
    Native,
}

/// The program to run: the emulator with the chip that it emulates, if there is one, and the image or executable.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Program {
    /// The emulator and its chip.
    pub emulator: Option<(PathBuf, Chip)>,
    /// Image of the chip, or program of this machine.
    pub file: PathBuf,
}

/// Builds the loop of controller and simulated tile. Each kind is built only once per process: chips of one target
/// share an output folder, so that alternating between them would rebuild each time.
///
/// # Errors
/// Status 1 if it does not build, status 2 if a tool is missing.
pub fn build(kind: Kind) -> Result<Program, Failure> {
    static BUILT: Mutex<Vec<(Kind, Program)>> = Mutex::new(Vec::new());
    let mut built = BUILT.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((_, program)) = built.iter().find(|(known, _)| *known == kind) {
        return Ok(program.clone());
    }
    let program = build_anew(kind)?;
    built.push((kind, program.clone()));
    Ok(program)
}

fn build_anew(kind: Kind) -> Result<Program, Failure> {
    let workspace = workspace()?;
    let toolchain = match kind {
        Kind::Emulated(chip) => toolchain::toolchain(chip.target)?,
        Kind::Native => toolchain::native()?,
    };
    let folder = workspace.join("target/image");
    let _lock = lock(&folder)?;
    let settings = Settings::controller(Subject::Loop);
    output::say(&format!("building the controller with {}", toolchain.describe()));
    Ok(match kind {
        Kind::Emulated(chip) => Program {
            emulator: Some((toolchain::emulator()?, chip)),
            file: compile::image(&toolchain, &workspace, &folder, &chip, &settings)?,
        },
        Kind::Native => {
            Program { emulator: None, file: compile::program(&toolchain, &workspace, &folder, &settings)? }
        }
    })
}

/// A running tile.
pub struct Machine {
    child: Child,
    reader: BufReader<Box<dyn Read>>,
    writer: Box<dyn Write>,
    /// Margin of self-locking.
    margin: f64,
}

impl std::fmt::Debug for Machine {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Machine").field("child", &self.child).finish_non_exhaustive()
    }
}

fn wrong(what: &str) -> impl Fn(std::io::Error) -> Failure + '_ {
    move |e| Failure::Wrong(format!("{what}: {e}"))
}

impl Machine {
    /// Starts tile `number`; `options` go to the emulator.
    ///
    /// # Errors
    /// [`Failure::Wrong`] if it does not start or does not send what it should.
    pub fn start(program: &Program, number: u8, options: Option<&[&str]>) -> Result<Self, Failure> {
        let (child, reader, writer) = match &program.emulator {
            Some((emulator, chip)) => emulate(emulator, chip, &program.file, options.unwrap_or(&[]))?,
            None => pipe(&program.file)?,
        };
        let mut machine = Self { child, reader: BufReader::new(reader), writer, margin: 0.0 };
        if machine.byte()? != HELLO {
            return Err(Failure::Wrong("the tile does not begin as it should: rebuild it".to_owned()));
        }
        machine.write(&[number])?;
        let margin = [machine.byte()?, machine.byte()?];
        machine.margin = f64::from(u16::from_le_bytes(margin)) * 1e-3;
        Ok(machine)
    }

    /// Margin of self-locking at the lowest friction, as sent by the tile at its start.
    #[must_use]
    pub fn margin(&self) -> f64 {
        self.margin
    }

    /// Sends bytes to the tile and runs it for a number of ticks; returns the bytes that it sent in each.
    ///
    /// # Errors
    /// [`Failure::Wrong`] if the tile does not answer.
    pub fn turn(&mut self, bytes: &[u8], ticks: u32) -> Result<Vec<Vec<u8>>, Failure> {
        let mut sent = Vec::new();
        // All bytes are sent in the first tick; callers never send more than fit into a turn.
        let mut turns: Vec<Vec<u8>> = Vec::new();
        let mut left = ticks;
        if !bytes.is_empty() && left > 0 {
            let count = u8::try_from(bytes.len()).ok().filter(|n| *n <= TICKS);
            let count = count.ok_or_else(|| Failure::Wrong("more bytes than a tick takes".to_owned()))?;
            turns.push([&[count], bytes].concat());
            left -= 1;
        }
        while left > 0 {
            let some = left.min(u32::from(MOST_TICKS));
            turns.push(vec![TICKS + some as u8]);
            left -= some;
        }
        for turn in turns {
            let ticks = if turn[0] > TICKS { turn[0] - TICKS } else { 1 };
            self.write(&turn)?;
            for _ in 0..ticks {
                let count = self.byte()?;
                sent.push((0..count).map(|_| self.byte()).collect::<Result<_, _>>()?);
            }
        }
        Ok(sent)
    }

    /// Causes a defect of the simulated tile; 0 repairs all.
    ///
    /// # Errors
    /// As [`Self::turn`].
    pub fn strike(&mut self, defect: u8) -> Result<(), Failure> {
        self.write(&[BREAK, defect])
    }

    /// Sends a control byte of the session itself: see `turns`.
    ///
    /// # Errors
    /// As [`Self::turn`].
    pub fn signal(&mut self, byte: u8) -> Result<(), Failure> {
        self.write(&[byte])
    }

    /// Ends it; returns the bytes of stack used. Fails if it did not end well.
    ///
    /// # Errors
    /// As [`Self::turn`].
    pub fn end(mut self) -> Result<u32, Failure> {
        self.write(&[END])?;
        let mut used = [0; 4];
        self.reader.read_exact(&mut used).map_err(wrong("the tile says no end"))?;
        let status = self.child.wait().map_err(wrong("the tile does not end"))?;
        if !status.success() {
            return Err(Failure::Wrong(format!("the tile ended with {status}")));
        }
        Ok(u32::from_le_bytes(used))
    }

    /// Waits until it ends for any reason.
    ///
    /// # Errors
    /// As [`Self::turn`].
    pub fn wait(mut self) -> Result<std::process::ExitStatus, Failure> {
        self.child.wait().map_err(wrong("the tile does not end"))
    }

    fn byte(&mut self) -> Result<u8, Failure> {
        let mut byte = [0];
        self.reader.read_exact(&mut byte).map_err(wrong("the tile is gone"))?;
        Ok(byte[0])
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        let done = self.writer.write_all(bytes).and_then(|()| self.writer.flush());
        done.map_err(wrong("the tile is gone"))
    }
}

impl Drop for Machine {
    fn drop(&mut self) {
        // If it has ended already, this has no effect.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

type Ends = (Child, Box<dyn Read>, Box<dyn Write>);

/// Starts the emulator, which connects its serial line to a socket opened here.
fn emulate(emulator: &Path, chip: &Chip, image: &Path, options: &[&str]) -> Result<Ends, Failure> {
    static COUNT: std::sync::atomic::AtomicU32 = std::sync::atomic::AtomicU32::new(0);
    let count = COUNT.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
    let path = std::env::temp_dir().join(format!("smartbed-{}-{count}", std::process::id()));
    let listener = UnixListener::bind(&path).map_err(wrong("a socket"))?;
    let mut command = clean(emulator);
    command.args(["-M", chip.machine, "-nographic", "-monitor", "none"]);
    command.arg("-serial").arg(format!("unix:{}", path.display()));
    command.args(["-semihosting-config", "enable=on,target=native"]).args(options).arg("-kernel").arg(image);
    command.stdout(Stdio::null());
    let child = command.spawn().map_err(wrong("the emulator"));
    let called = child.and_then(|child| Ok((wait_for(&listener)?, child)));
    let _ = std::fs::remove_file(&path);
    let (stream, child) = called?;
    let reader = stream.try_clone().map_err(wrong("a socket"))?;
    Ok((child, Box::new(reader), Box::new(stream)))
}

fn wait_for(listener: &UnixListener) -> Result<std::os::unix::net::UnixStream, Failure> {
    listener.set_nonblocking(true).map_err(wrong("a socket"))?;
    let start = Instant::now();
    loop {
        match listener.accept() {
            Ok((stream, _)) => {
                stream.set_nonblocking(false).map_err(wrong("a socket"))?;
                return Ok(stream);
            }
            Err(e) if e.kind() == std::io::ErrorKind::WouldBlock && start.elapsed() < PATIENCE => {
                std::thread::sleep(Duration::from_millis(2));
            }
            Err(e) => return Err(Failure::Wrong(format!("the emulator did not connect: {e}"))),
        }
    }
}

fn pipe(program: &Path) -> Result<Ends, Failure> {
    let mut child = clean(program)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .map_err(wrong("the tile does not start"))?;
    let gone = || Failure::Wrong("the tile has no pipes".to_owned());
    let reader = child.stdout.take().ok_or_else(gone)?;
    let writer = child.stdin.take().ok_or_else(gone)?;
    Ok((child, Box::new(reader), Box::new(writer)))
}
