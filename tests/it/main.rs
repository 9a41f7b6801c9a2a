//! The only test binary.

mod emulator;
