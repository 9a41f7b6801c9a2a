//! A scene in motion: owns the memory that the runtime's kernels borrow.
//!
//! In: [`Lists`], ground, gas, method, rounded once to the scalar. Out: the state after each step.

use smartbed_runtime::contact::compensation::PointImpact;
use smartbed_runtime::contact::soft;
use smartbed_runtime::contact::stable_step::{Sums, largest_stable_step};
use smartbed_runtime::contact::{ContactLaw, ContactState, Ground, System, massless};
use smartbed_runtime::flexible::{Body, BodyError, Gas, Inflation, Massless, Spring};
use smartbed_runtime::ode::nodes::method::{Dop853, DormandPrince};
use smartbed_runtime::ode::nodes::{MOTION_ROWS, Method, Motion, Step, Workspace, workspace_len};
use smartbed_runtime::real::Scalar;
use smartbed_runtime::scene::{Observer, State, StepReport, step};
use smartbed_runtime::vec3::{self, Vec3};

use super::grid::Woven;
use super::lists::Lists;
use super::marcher::Marcher;
use super::patches::Patched;
use crate::contact_force::ContactForce;

/// The surroundings of a body: constants in f64.
#[derive(Clone, Debug)]
pub struct Surroundings {
    /// Acceleration of gravity (m/s^2).
    pub gravity: [f64; 3],
    /// Viscous drag of the air per point (N s/m).
    pub air_drag: f64,
    /// Ground, if any.
    pub ground: Option<Ground<f64>>,
    /// Gas inside the facets.
    pub inflation: Option<Inflation<f64>>,
}

/// A body in motion, over the scalar S.
#[derive(Clone, Debug)]
pub struct Simulation<S: Scalar> {
    mass: Vec<S>,
    fixed: Vec<bool>,
    inverse_mass: Vec<Vec3<S>>,
    springs: Vec<Spring<S>>,
    facets: Vec<[usize; 4]>,
    gravity: Vec3<S>,
    air_drag: S,
    ground: Option<Ground<S>>,
    inflation: Option<Inflation<S>>,
    massless: Links,
    grid: Option<Woven<S>>,
    /// The springs in patches, if there is no grid.
    patches: Option<Patched<S>>,
    /// Where many steps can be taken at once.
    pub(super) marcher: Option<Marcher<S>>,
    method: Method<S>,
    /// The state, and memory for the state at the end of a step.
    motions: [Vec<Vec3<S>>; 2],
    scratch: Vec<Vec3<S>>,
    impacts: Vec<PointImpact<S>>,
    modes: Vec<ContactState>,
    time: [S; 2],
    next_step: S,
    anchor: S,
}

/// The massless points and the springs of each: the memory that [`Massless`] borrows.
#[derive(Clone, Debug, Default)]
struct Links {
    points: Vec<usize>,
    first: Vec<usize>,
    springs: Vec<usize>,
}

impl Links {
    fn new<S: Scalar>(mass: &[S], fixed: &[bool], springs: &[Spring<S>]) -> Links {
        // What is held in space needs no mass.
        let is_massless =
            |point: usize| mass.get(point) == Some(&S::ZERO) && fixed.get(point) == Some(&false);
        let mut of_point = vec![Vec::new(); mass.len()];
        for (number, spring) in springs.iter().enumerate() {
            for end in [spring.tail, spring.head].into_iter().filter(|end| is_massless(*end)) {
                of_point[end].push(number);
            }
        }
        let mut links = Links { first: vec![0], ..Links::default() };
        for point in (0..mass.len()).filter(|point| is_massless(*point)) {
            links.points.push(point);
            links.springs.append(&mut of_point[point]);
            links.first.push(links.springs.len());
        }
        links
    }

    fn view(&self) -> Massless<'_> {
        Massless { points: &self.points, first: &self.first, springs: &self.springs }
    }
}

impl<S: Scalar> Simulation<S> {
    /// Rounds the lists to S and places the points; call [`Simulation::begin`] before the first step.
    ///
    /// # Errors
    /// What the runtime refuses about the body.
    pub fn new(lists: &Lists, around: &Surroundings, method: Method<f64>) -> Result<Self, BodyError<S>> {
        let real = S::from_f64;
        let vector = |v: &[f64; 3]| v.map(real);
        let n = lists.points.len();
        let method = round_method(method);
        let mut motion = vec![[S::ZERO; 3]; MOTION_ROWS * n];
        for (i, x) in lists.points.iter().enumerate() {
            motion[i] = vector(x);
            motion[2 * n + i] = lists.velocities.get(i).map_or([S::ZERO; 3], vector);
        }
        let mass: Vec<S> = lists.masses.iter().map(|m| real(*m)).collect();
        let springs: Vec<Spring<S>> = lists.elements(0).collect();
        let grid = Woven::new(lists, [0; 3]);
        let mut simulation = Simulation {
            massless: Links::new(&mass, &lists.fixed, &springs),
            patches: if grid.is_none() { Patched::new(&springs, n) } else { None },
            grid,
            marcher: None,
            mass,
            fixed: lists.fixed.clone(),
            inverse_mass: Vec::new(),
            springs,
            facets: lists.facets.clone(),
            gravity: vector(&around.gravity),
            air_drag: real(around.air_drag),
            ground: around.ground.as_ref().map(|g| round_ground(g, lists)),
            inflation: around.inflation.map(round_inflation),
            method,
            motions: [motion, vec![[S::ZERO; 3]; MOTION_ROWS * n]],
            scratch: vec![[S::ZERO; 3]; workspace_len(n, method.stages()) - MOTION_ROWS * n],
            impacts: vec![PointImpact::none(); n],
            modes: vec![ContactState::Free; n],
            time: [S::ZERO; 2],
            next_step: S::ZERO,
            anchor: S::ZERO,
        };
        let body = Body::new(simulation.body())?;
        simulation.inverse_mass = (0..n).map(|i| [body.inverse_mass(i); 3]).collect();
        simulation.settle();
        simulation.marcher = simulation.with(|system, _, _| Ok(Marcher::new(system, method)))?;
        if simulation.ground.is_some()
            && let Some(stable) = simulation.largest_stable_step()
        {
            simulation.method = limit_step(simulation.method, stable);
        }
        Ok(simulation)
    }

    /// Moves massless points to their equilibrium, so that the initial energy is that of the first step.
    fn settle(&mut self) {
        let Some(ground) = self.ground.filter(|ground| ground.law == ContactLaw::MasslessPoint) else {
            return;
        };
        // A start below the ground is left to the first step, which refuses it.
        if self.pos().iter().any(|x| ground.gap(*x) < -ground.tolerance) {
            return;
        }
        let mut places = self.pos().to_vec();
        let mut origins = places.clone();
        massless::settle(&self.body(), &ground, &mut places, &mut origins);
        self.motions[0][..places.len()].copy_from_slice(&places);
    }

    /// The body with its springs and facets as lists, for queries outside of steps.
    fn body(&self) -> Body<'_, S> {
        Body {
            mass: &self.mass,
            fixed: &self.fixed,
            inverse_mass: &self.inverse_mass,
            springs: &self.springs,
            gravity: self.gravity,
            air_drag: self.air_drag,
            facets: &self.facets,
            inflation: self.inflation,
            massless: self.massless.view(),
            grids: &[],
            patches: None,
        }
    }

    /// Body and ground.
    #[must_use]
    pub fn system(&self) -> System<'_, S> {
        System::new(self.body(), self.ground)
    }

    /// Method of integration.
    #[must_use]
    pub fn method(&self) -> Method<S> {
        self.method
    }

    /// Lets the runtime work on the views of this memory.
    pub(super) fn with<R>(
        &mut self,
        work: impl for<'a> FnOnce(&System<S>, &mut State<'a, S>, &mut Workspace<'a, S>) -> Result<R, BodyError<S>>,
    ) -> Result<R, BodyError<S>> {
        // A march takes its memory out before it comes here.
        if let Some(marcher) = &mut self.marcher {
            marcher.forget();
        }
        let n = self.mass.len();
        let grid = self.grid.as_ref().map(Woven::view);
        let body = Body {
            mass: &self.mass,
            fixed: &self.fixed,
            inverse_mass: &self.inverse_mass,
            springs: &self.springs,
            gravity: self.gravity,
            air_drag: self.air_drag,
            facets: &self.facets,
            inflation: self.inflation,
            massless: self.massless.view(),
            grids: grid.as_slice(),
            patches: self.patches.as_ref().map(Patched::view),
        };
        let system = System::new(body, self.ground);
        let [motion, end] = &mut self.motions;
        let ((motion, _), (end, _)) = (Motion::cut(motion, n)?, Motion::cut(end, n)?);
        let start = motion.pos.as_ptr();
        let mut state = State {
            motion,
            modes: &mut self.modes,
            impacts: &mut self.impacts,
            time: self.time,
            next_step: self.next_step,
            anchor: self.anchor,
        };
        let mut workspace = Workspace::around(end, &mut self.scratch, n, self.method.stages())?;
        let done = work(&system, &mut state, &mut workspace);
        let is_exchanged = state.motion.pos.as_ptr() != start;
        (self.time, self.next_step, self.anchor) = (state.time, state.next_step, state.anchor);
        if is_exchanged {
            self.motions.swap(0, 1);
        }
        done
    }

    /// Computes forces, energy and contacts of the initial state.
    ///
    /// # Errors
    /// Those of the gas law.
    pub fn begin<O: Observer<S>>(&mut self, h: S, observer: &mut O) -> Result<(), BodyError<S>> {
        let method = self.method;
        self.with(|system, state, work| state.begin(system, h, method, work, observer))
    }

    /// Advances by h.
    ///
    /// # Errors
    /// The state is then the one before the step.
    pub fn step<O: Observer<S>>(&mut self, h: S, observer: &mut O) -> Result<StepReport, BodyError<S>> {
        let method = self.method;
        // A march of the energy-momentum method has bits of its own, whoever looks between its steps; an undamped body
        // without ground has nothing to tell an observer.
        if method == Method::EnergyMomentum
            && let Some(evaluations) = self.march(h, 1)
        {
            return Ok(StepReport { substeps: 1, evaluations, ..StepReport::default() });
        }
        self.with(|system, state, work| step(system, state, h, method, work, observer))
    }

    /// Largest stable step of an explicit method in the present state (s).
    #[must_use]
    pub fn largest_stable_step(&self) -> Option<S> {
        let mut sums = vec![Sums::none(); self.mass.len()];
        largest_stable_step(&self.system(), self.pos(), self.vel(), &mut sums)
    }

    /// Positions (m).
    #[must_use]
    pub fn pos(&self) -> &[Vec3<S>] {
        &self.motions[0][..self.mass.len()]
    }

    /// Velocities (m/s).
    #[must_use]
    pub fn vel(&self) -> &[Vec3<S>] {
        &self.motions[0][2 * self.mass.len()..3 * self.mass.len()]
    }

    /// Contact state of each point.
    #[must_use]
    pub fn modes(&self) -> &[ContactState] {
        &self.modes
    }

    /// Forces of the ground on the points in contact: those of the contact constraint, or those of a compliant ground.
    #[must_use]
    pub fn ground_forces(&self) -> Vec<ContactForce> {
        let (n, system) = (self.mass.len(), self.system());
        let of = |i: usize| {
            let ground = self.ground.as_ref()?;
            let (place, velocity) = (self.motions[0][i], self.motions[0][2 * n + i]);
            let fixed = self.fixed.get(i).is_some_and(|f| *f);
            let held = ground.is_rigid() && self.modes[i].is_held() && !fixed;
            let rubbed = held || (!ground.is_rigid() && !fixed);
            let [elastic, viscous] = [4, 5].map(|row| self.motions[0][row * n + i]);
            let load = vec3::add(elastic, viscous);
            let size = match held {
                true => system.normal_force(load).max(S::ZERO),
                false => soft::normal_force(ground, place, velocity).0,
            };
            // Coulomb friction: at a sticking point it balances the load, at a sliding one it opposes the motion.
            let across = match self.modes[i] {
                ContactState::Stuck if rubbed => vec3::tangential(load, ground.normal),
                _ if rubbed => {
                    let (way, _) = vec3::direction(vec3::tangential(velocity, ground.normal));
                    vec3::scale(way, ground.friction * size)
                }
                _ => vec3::zero(),
            };
            let widen = |x: Vec3<S>| x.map(Scalar::to_f64);
            let force = ContactForce {
                point: widen(place),
                normal: widen(vec3::scale(ground.normal, size)),
                friction: widen(vec3::scale(across, -S::ONE)),
                on_both: false,
            };
            (size > S::ZERO).then_some(force)
        };
        (0..n).filter_map(of).collect()
    }

    /// Time (s).
    #[must_use]
    pub fn t(&self) -> S {
        self.time[0]
    }

    /// Masses (kg).
    #[must_use]
    pub fn mass(&self) -> &[S] {
        &self.mass
    }
}

fn round_method<S: Scalar>(method: Method<f64>) -> Method<S> {
    match method {
        Method::SymplecticEuler => Method::SymplecticEuler,
        Method::Verlet => Method::Verlet,
        Method::DampedVerlet => Method::DampedVerlet,
        Method::Nystrom4 => Method::Nystrom4,
        Method::BlanesMoan4 => Method::BlanesMoan4,
        Method::Rk4 => Method::Rk4,
        Method::ImplicitMidpoint => Method::ImplicitMidpoint,
        Method::EnergyMomentum => Method::EnergyMomentum,
        Method::DormandPrince(DormandPrince { tolerance, longest }) => Method::DormandPrince(DormandPrince {
            tolerance: S::from_f64(tolerance),
            longest: S::from_f64(longest),
        }),
        Method::Dop853(Dop853 { tolerance, longest }) => {
            Method::Dop853(Dop853 { tolerance: S::from_f64(tolerance), longest: S::from_f64(longest) })
        }
    }
}

/// Limits an adaptive method to the stable step. In free fall its error estimate does not see the springs: it would
/// amplify rounding, and points that should touch together would touch one after the other.
fn limit_step<S: Scalar>(method: Method<S>, stable: S) -> Method<S> {
    match method {
        Method::DormandPrince(DormandPrince { tolerance, longest }) => {
            Method::DormandPrince(DormandPrince { tolerance, longest: longest.min(stable) })
        }
        Method::Dop853(Dop853 { tolerance, longest }) => {
            Method::Dop853(Dop853 { tolerance, longest: longest.min(stable) })
        }
        fixed => fixed,
    }
}

/// Gaps below this many roundings of the body's size count as 0.
const GAP_ROUNDING: f64 = 16.0;

fn round_ground<S: Scalar>(ground: &Ground<f64>, lists: &Lists) -> Ground<S> {
    let real = S::from_f64;
    let size = lists.points.iter().flatten().fold(1.0_f64, |m, x| m.max(x.abs()));
    let law = match ground.law {
        ContactLaw::Compensation { eta, anchor, plastic_alone, first_receiver } => {
            ContactLaw::Compensation { eta: real(eta), anchor, plastic_alone, first_receiver }
        }
        ContactLaw::Newton { restitution } => ContactLaw::Newton { restitution: real(restitution) },
        ContactLaw::Moreau { restitution } => ContactLaw::Moreau { restitution: real(restitution) },
        ContactLaw::MasslessPoint => ContactLaw::MasslessPoint,
        ContactLaw::Force(law) => ContactLaw::Force(law.rounded()),
    };
    Ground {
        normal: ground.normal.map(real),
        offset: real(ground.offset),
        law,
        friction: real(ground.friction),
        tolerance: real(ground.tolerance).max(real(GAP_ROUNDING * size) * S::EPSILON),
    }
}

fn round_inflation<S: Scalar>(inflation: Inflation<f64>) -> Inflation<S> {
    let real = S::from_f64;
    let gas = match inflation.gas {
        Gas::Constant(pressure) => Gas::Constant(real(pressure)),
        Gas::Polytropic { pressure, ambient, volume, exponent, dead_volume } => Gas::Polytropic {
            pressure: real(pressure),
            ambient: real(ambient),
            volume: real(volume),
            exponent: real(exponent),
            dead_volume: real(dead_volume),
        },
    };
    Inflation { gas, form: inflation.form }
}
