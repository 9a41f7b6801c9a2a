//! Memory that the runtime's world borrows for a step; it keeps the contacts of the last one.

use smartbed_runtime::real::Scalar;
use smartbed_runtime::rigid::contact::Twist;
use smartbed_runtime::surface::Frame;
use smartbed_runtime::vec3::Vec3;
use smartbed_runtime::world::{Coupling, Extent, Inertias, InverseInertia, StepMemory, Touch};

/// Memory of steps, made when one first asks for it: worlds without contacts that a method of `ode` steps need none.
#[derive(Clone, Debug)]
pub(super) struct Room<S> {
    /// Ports, nodes, answers and numbers of the state.
    sizes: [usize; 4],
    /// Things and contacts at once.
    contacts: [usize; 2],
    lists: Option<Lists<S>>,
    /// Contacts of the last step and of the one before.
    pub(super) counts: [usize; 2],
}

/// What a [`StepMemory`] borrows.
#[derive(Clone, Debug)]
struct Lists<S> {
    scratch: Vec<S>,
    frames: [Vec<Frame<S>>; 2],
    twists: [Vec<Twist<S>>; 3],
    normals: Vec<Vec3<S>>,
    extents: Vec<Extent<S>>,
    couplings: Vec<Coupling>,
    answers: Vec<InverseInertia<S>>,
    yields: Vec<S>,
    touches: [Vec<Touch<S>>; 2],
}

impl<S: Scalar> Room<S> {
    /// For so many ports, nodes, answers and numbers of the state, things and contacts at once.
    pub(super) fn new(sizes: [usize; 4], contacts: [usize; 2]) -> Self {
        Room { sizes, contacts, lists: None, counts: [0, 0] }
    }

    /// Numbers of ports, nodes, answers and of the state.
    pub(super) fn sizes(&self) -> [usize; 4] {
        self.sizes
    }

    /// The memory of a step; the caller keeps its counts.
    pub(super) fn memory(&mut self) -> StepMemory<'_, S> {
        let lists = self.lists.get_or_insert_with(|| Lists::new(self.sizes, self.contacts));
        let [first, last] = &mut lists.frames;
        let [start, free, end] = &mut lists.twists;
        let [now, before] = &mut lists.touches;
        StepMemory {
            scratch: &mut lists.scratch,
            frames: [first, last],
            twists: [start, free, end],
            normals: &mut lists.normals,
            inertias: Inertias {
                couplings: &mut lists.couplings,
                answers: &mut lists.answers,
                nodes: &mut lists.yields,
            },
            extents: &mut lists.extents,
            touches: [now, before],
            counts: self.counts,
        }
    }
}

impl<S: Scalar> Lists<S> {
    fn new([ports, points, answers, n]: [usize; 4], [things, contacts]: [usize; 2]) -> Self {
        Lists {
            scratch: vec![S::ZERO; StepMemory::<S>::scratch(n)],
            frames: [0; 2].map(|_| vec![Frame::inertial(); ports]),
            twists: [0; 3].map(|_| vec![Twist::zero(); ports + points]),
            normals: vec![[S::ZERO; 3]; points],
            extents: vec![Extent::everywhere(); things],
            couplings: vec![Coupling::default(); ports],
            answers: vec![[[S::ZERO; 6]; 6]; answers],
            yields: vec![S::ZERO; points],
            touches: [0; 2].map(|_| vec![Touch::empty(); contacts]),
        }
    }
}
