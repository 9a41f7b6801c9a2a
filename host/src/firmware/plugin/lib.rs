//! Plug-in of the emulator (QEMU plug-in interface, version 1): counts executed instructions.
//!
//! For every call of each function `fn=NAME@ADDRESS`, callees included, it records the executed
//! instructions and an interval of Cortex-M4F cycles, and writes to `out=FILE`
//!
//! ```text
//! total INSTRUCTIONS CYCLES_LOW CYCLES_HIGH
//! NAME CALLS MIN MEDIAN MAX MEDIAN_CYCLES_LOW MEDIAN_CYCLES_HIGH MAX_CYCLES_HIGH
//! ```
//!
//! No clock is involved and the guest is not changed: the same image gives the same numbers. Counting is by translated
//! block: a call, a return and a taken branch always end one, so every function starts one.
//! Compiled by `smartbed firmware` with the host's rustc; not a member of the workspace, because
//! the interface is C and every call into it is unsafe.

#[path = "../cycles.rs"]
mod cycles;

use std::collections::HashMap;
use std::ffi::{CStr, c_char, c_int, c_uint, c_void};
use std::fmt::Write as _;
use std::sync::Mutex;

/// A translated block, owned by the emulator.
#[repr(C)]
pub struct Block {
    _opaque: [u8; 0],
}

/// An instruction of a block, owned by the emulator.
#[repr(C)]
pub struct Instruction {
    _opaque: [u8; 0],
}

unsafe extern "C" {
    fn qemu_plugin_register_vcpu_tb_trans_cb(id: u64, callback: extern "C" fn(u64, *mut Block));
    fn qemu_plugin_register_atexit_cb(id: u64, callback: extern "C" fn(u64, *mut c_void), data: *mut c_void);
    fn qemu_plugin_register_vcpu_tb_exec_cb(
        block: *mut Block,
        callback: extern "C" fn(c_uint, *mut c_void),
        flags: c_int,
        data: *mut c_void,
    );
    fn qemu_plugin_tb_n_insns(block: *const Block) -> usize;
    fn qemu_plugin_tb_get_insn(block: *const Block, index: usize) -> *mut Instruction;
    fn qemu_plugin_insn_vaddr(instruction: *const Instruction) -> u64;
    fn qemu_plugin_insn_size(instruction: *const Instruction) -> usize;
    fn qemu_plugin_insn_data(instruction: *const Instruction) -> *const u8;
}

/// The version of the interface that this file is written for.
#[unsafe(no_mangle)]
pub static qemu_plugin_version: c_int = 1;

/// Instructions, fewest cycles, most cycles.
type Cost = [u64; 3];

/// What the execution of a block adds. Leaked: its address is the callback's datum.
struct Meta {
    start: u64,
    end: u64,
    cost: Cost,
}

/// A call that has not returned.
struct Open {
    function: usize,
    return_to: u64,
    at: Cost,
}

#[derive(Default)]
struct State {
    names: Vec<String>,
    starts: HashMap<u64, usize>,
    out: String,
    calls: Vec<Vec<Cost>>,
    open: Vec<Open>,
    now: Cost,
    previous_end: u64,
}

static STATE: Mutex<Option<State>> = Mutex::new(None);

impl State {
    fn execute(&mut self, block: &Meta) {
        if self.previous_end != block.start {
            self.now[1] += cycles::REFILL.0;
            self.now[2] += cycles::REFILL.1;
        }
        while self.open.last().is_some_and(|call| call.return_to == block.start) {
            if let Some(call) = self.open.pop() {
                self.calls[call.function].push(std::array::from_fn(|k| self.now[k] - call.at[k]));
            }
        }
        if let Some(&function) = self.starts.get(&block.start) {
            self.open.push(Open { function, return_to: self.previous_end, at: self.now });
        }
        for (now, more) in self.now.iter_mut().zip(block.cost) {
            *now += more;
        }
        self.previous_end = block.end;
    }

    fn report(&mut self) -> String {
        let mut text = format!("total {} {} {}\n", self.now[0], self.now[1], self.now[2]);
        for (name, calls) in self.names.iter().zip(&mut self.calls) {
            calls.sort_unstable();
            let (Some(min), Some(max)) = (calls.first(), calls.last()) else {
                let _ = writeln!(text, "{name} 0 0 0 0 0 0 0");
                continue;
            };
            let median = calls[calls.len() / 2];
            let most = calls.iter().map(|c| c[2]).max().unwrap_or(0);
            let _ = writeln!(
                text,
                "{name} {} {} {} {} {} {} {most}",
                calls.len(),
                min[0],
                median[0],
                max[0],
                median[1],
                median[2]
            );
        }
        text
    }
}

/// Called when a block is translated.
extern "C" fn translated(_id: u64, block: *mut Block) {
    let mut cost = [0; 3];
    let (mut start, mut end) = (0, 0);
    // SAFETY: the emulator passes a live block; instructions and their bytes live as long as this callback.
    let n = unsafe { qemu_plugin_tb_n_insns(block) };
    for index in 0..n {
        // SAFETY: as above; index < n, and an instruction has `size` bytes, 2 or 4.
        let (address, size, bytes) = unsafe {
            let instruction = qemu_plugin_tb_get_insn(block, index);
            let size = qemu_plugin_insn_size(instruction);
            let data = qemu_plugin_insn_data(instruction);
            (qemu_plugin_insn_vaddr(instruction), size, std::slice::from_raw_parts(data, size))
        };
        let half = |at: usize| bytes.get(at..at + 2).map_or(0, |b| u16::from_le_bytes([b[0], b[1]]));
        let (low, high) = cycles::cycles(half(0), half(2));
        cost = [cost[0] + 1, cost[1] + low, cost[2] + high];
        if index == 0 {
            start = address;
        }
        end = address + size as u64;
    }
    let meta: &'static Meta = Box::leak(Box::new(Meta { start, end, cost }));
    // SAFETY: the callback only reads the datum, which is never freed.
    unsafe {
        qemu_plugin_register_vcpu_tb_exec_cb(block, executed, 0, std::ptr::from_ref(meta).cast_mut().cast());
    }
}

/// Called when a block is executed.
extern "C" fn executed(_cpu: c_uint, data: *mut c_void) {
    // SAFETY: the datum registered in `translated`.
    let block = unsafe { &*data.cast_const().cast::<Meta>() };
    if let Ok(mut state) = STATE.lock()
        && let Some(state) = state.as_mut()
    {
        state.execute(block);
    }
}

/// Called when the emulator ends.
extern "C" fn ended(_id: u64, _data: *mut c_void) {
    if let Ok(mut state) = STATE.lock()
        && let Some(state) = state.as_mut()
    {
        let text = state.report();
        if let Err(error) = std::fs::write(&state.out, text) {
            eprintln!("count: {}: {error}", state.out);
        }
    }
}

fn options(arguments: impl Iterator<Item = String>) -> Option<State> {
    let mut state = State::default();
    for argument in arguments {
        match argument.split_once('=')? {
            ("fn", function) => {
                let (name, address) = function.split_once('@')?;
                state.starts.insert(address.parse().ok()?, state.names.len());
                state.names.push(name.to_owned());
                state.calls.push(Vec::new());
            }
            ("out", file) => file.clone_into(&mut state.out),
            _ => return None,
        }
    }
    Some(state)
}

/// Called when the plug-in is loaded.
#[unsafe(no_mangle)]
pub extern "C" fn qemu_plugin_install(
    id: u64,
    _info: *const c_void,
    argc: c_int,
    argv: *const *const c_char,
) -> c_int {
    let count = usize::try_from(argc).unwrap_or(0);
    // SAFETY: the emulator passes `argc` pointers to C strings.
    let arguments =
        (0..count).map(|i| unsafe { CStr::from_ptr(*argv.add(i)) }.to_string_lossy().into_owned());
    let (Some(options), Ok(mut state)) = (options(arguments), STATE.lock()) else {
        eprintln!("count: expected fn=NAME@ADDRESS... out=FILE");
        return -1;
    };
    *state = Some(options);
    // SAFETY: `id` is ours, and the callbacks are functions of this library.
    unsafe {
        qemu_plugin_register_vcpu_tb_trans_cb(id, translated);
        qemu_plugin_register_atexit_cb(id, ended, std::ptr::null_mut());
    }
    0
}
