//! The emitted Rust, compiled into a dynamic library and called through its one C function.

use super::kinds::{Engine, EngineScalar};
use super::{cache, crate_text};
use crate::failure::Failure;
use libloading::Library;
use smartbed_codegen::program::arguments::Arguments;
use smartbed_codegen::{Function, Program};
use smartbed_runtime::mechanism::{Fault, Mechanism};

/// The C function: number of the answer, arguments, results; returns whether the lengths fit.
type AnswerFunction<S> = unsafe extern "C" fn(u32, *const S, usize, *mut S, usize) -> bool;

/// Number of the first function on request, as the C function takes it.
const FIRST: u32 = 8;

/// Numbers of the other answers.
#[derive(Clone, Copy)]
enum Which {
    Rates = 0,
    Energy = 1,
    Speeds = 2,
    Outputs = 3,
    Projection = 4,
    Prepare = 5,
    Drive = 6,
    SpeedProjection = 7,
}

/// A mechanism whose equations are called in the compiled library.
#[derive(Debug)]
pub struct Compiled<S> {
    function: AnswerFunction<S>,
    /// Keeps the library loaded.
    _library: Library,
    n_speeds: usize,
    n_outputs: usize,
    /// Number of results of each function on request.
    n_results: Vec<usize>,
    is_driven: bool,
    is_redundant: bool,
    corrected: Vec<usize>,
    angles: Vec<bool>,
    arguments: Arguments<S>,
    rates: Vec<S>,
}

impl<S: EngineScalar> Compiled<S> {
    /// Compiles the program, if it is not in the cache, and loads it.
    ///
    /// # Errors
    /// As [`cache::library`]; [`Failure::Wrong`] if the library cannot be loaded.
    pub fn new(program: &Program) -> Result<Self, Failure> {
        let files = crate_text::dynamic(program, S::scalar_type(), &cache::libm_version());
        let path = cache::library(&files)?;
        let (library, function) =
            load(&path).map_err(|e| Failure::Wrong(format!("cannot load {}: {e}", path.display())))?;
        let functions = [Function::each(&program.standing()), program.functions.clone()].concat();
        let roots: Vec<_> = functions.iter().flat_map(|f| program.function_roots(f)).collect();
        let n_prepared = program.prepared(&roots).len();
        let parameters: Vec<S> = program.parameters.iter().map(|p| S::from_f64(p.value)).collect();
        let mut this = Self {
            function,
            _library: library,
            n_speeds: program.speeds.len(),
            n_outputs: program.outputs.len(),
            n_results: program.functions.iter().map(|f| program.function_roots(f).len()).collect(),
            is_driven: program.drive.is_some(),
            is_redundant: program.is_redundant(),
            corrected: program.correction.iter().map(|(i, _)| *i).collect(),
            angles: program.q.iter().map(|q| q.is_angle).collect(),
            arguments: Arguments::new(program, n_prepared),
            rates: vec![S::ZERO; program.q.len() + program.u.len() + 1],
        };
        this.prepare(&parameters)
            .map_err(|_| Failure::Wrong(format!("{} lacks parameters", path.display())))?;
        Ok(this)
    }

    /// Computes what depends on the parameters alone.
    fn prepare(&mut self, parameters: &[S]) -> Result<(), Fault> {
        call(self.function, Which::Prepare as u32, parameters, self.arguments.prepared_mut())
    }

    fn answer(&self, which: Which, results: &mut [S]) -> Result<(), Fault> {
        call(self.function, which as u32, self.arguments.values(), results)
    }
}

#[expect(unsafe_code, reason = "a compiled library is loaded through the C interface of the system")]
fn load<S>(path: &std::path::Path) -> Result<(Library, AnswerFunction<S>), libloading::Error> {
    // SAFETY: the library is this program's own, written by `crate_text::dynamic`: it has no
    // initialisers, and the symbol has exactly this type for the scalar that it was emitted with.
    unsafe {
        let library = Library::new(path)?;
        let function = *library.get::<AnswerFunction<S>>(b"smartbed_answer\0")?;
        Ok((library, function))
    }
}

#[expect(unsafe_code, reason = "the one call through the C interface of a compiled library")]
fn call<S>(function: AnswerFunction<S>, which: u32, arguments: &[S], results: &mut [S]) -> Result<(), Fault> {
    let (n_arguments, n_results) = (arguments.len(), results.len());
    // SAFETY: pointers and lengths are those of two slices; the library is loaded as long as the
    // mechanism that holds `function`.
    let fits = unsafe { function(which, arguments.as_ptr(), n_arguments, results.as_mut_ptr(), n_results) };
    if fits { Ok(()) } else { Err(Fault::Shape) }
}

impl<S: EngineScalar> Mechanism<S> for Compiled<S> {
    fn n_q(&self) -> usize {
        self.arguments.n_q()
    }
    fn n_u(&self) -> usize {
        self.arguments.n_u()
    }
    fn n_inputs(&self) -> usize {
        self.arguments.n_inputs()
    }
    fn is_angle(&self, index: usize) -> bool {
        self.angles.get(index).copied().unwrap_or(false)
    }
    fn rates(
        &mut self,
        t: S,
        q: &[S],
        u: &[S],
        inputs: &[S],
        q_dot: &mut [S],
        u_dot: &mut [S],
    ) -> Result<S, Fault> {
        self.arguments.set(t, q, u, inputs)?;
        call(self.function, Which::Rates as u32, self.arguments.values(), &mut self.rates)?;
        self.arguments.split_rates(&self.rates, q_dot, u_dot)
    }
    fn set_time(&mut self, t: S) {
        self.arguments.set_time(t);
    }
    fn project(&mut self, q: &mut [S]) -> Result<S, Fault> {
        self.arguments.set_coordinates(q)?;
        let mut results = vec![S::ZERO; self.corrected.len() + 1];
        self.answer(Which::Projection, &mut results)?;
        for (&index, &correction) in self.corrected.iter().zip(&results) {
            q[index] = q[index] + correction;
        }
        Ok(results[self.corrected.len()])
    }
    fn project_speeds(&mut self, q: &[S], u: &mut [S]) -> Result<(), Fault> {
        if !self.is_redundant {
            return Ok(());
        }
        self.arguments.set_state(q, u)?;
        let mut corrections = vec![S::ZERO; u.len()];
        self.answer(Which::SpeedProjection, &mut corrections)?;
        for (speed, &correction) in u.iter_mut().zip(&corrections) {
            *speed = *speed + correction;
        }
        Ok(())
    }
    fn energy(&mut self, q: &[S], u: &[S]) -> Result<(S, S), Fault> {
        self.arguments.set_state(q, u)?;
        let mut energy = [S::ZERO; 2];
        self.answer(Which::Energy, &mut energy)?;
        Ok((energy[0], energy[1]))
    }
}

impl<S: EngineScalar> Engine<S> for Compiled<S> {
    fn set_parameters(&mut self, values: &[S]) {
        self.prepare(values).expect("as many values as parameters");
    }
    fn speeds(&mut self, q: &[S], u: &[S]) -> Result<Vec<S>, Fault> {
        self.arguments.set_state(q, u)?;
        let mut values = vec![S::ZERO; self.n_speeds];
        self.answer(Which::Speeds, &mut values)?;
        Ok(values)
    }
    fn outputs(&mut self, t: S, q: &[S], u: &[S], inputs: &[S]) -> Result<Vec<S>, Fault> {
        self.arguments.set(t, q, u, inputs)?;
        let mut values = vec![S::ZERO; self.n_outputs];
        self.answer(Which::Outputs, &mut values)?;
        Ok(values)
    }
    fn drive(&mut self, t: S, q: &[S], u: &[S], inputs: &[S]) -> Result<S, Fault> {
        self.arguments.set(t, q, u, inputs)?;
        let mut power = [S::ZERO];
        if self.is_driven {
            self.answer(Which::Drive, &mut power)?;
        }
        Ok(power[0])
    }
    fn function(
        &mut self,
        place: usize,
        (t, q, u, inputs, u_dot): (S, &[S], &[S], &[S], &[S]),
    ) -> Result<Vec<S>, Fault> {
        self.arguments.set(t, q, u, inputs)?;
        self.arguments.set_u_dot(u_dot)?;
        let mut results = vec![S::ZERO; *self.n_results.get(place).ok_or(Fault::Shape)?];
        call(self.function, FIRST + place as u32, self.arguments.values(), &mut results)?;
        Ok(results)
    }
}
