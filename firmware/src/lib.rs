//! The tile controller.
#![no_std]
