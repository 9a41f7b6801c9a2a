//! Memory that the runtime's world borrows for a step; it keeps the contacts of the last one.

use smartbed_runtime::real::Scalar;
use smartbed_runtime::rigid::contact::Twist;
use smartbed_runtime::surface::Frame;
use smartbed_runtime::vec3::Vec3;
use smartbed_runtime::world::{Coupling, Extent, Inertias, InverseInertia, StepMemory, Touch};

/// What a [`StepMemory`] borrows.
#[derive(Clone, Debug)]
pub(super) struct Room<S> {
    scratch: Vec<S>,
    frames: [Vec<Frame<S>>; 2],
    twists: [Vec<Twist<S>>; 3],
    normals: Vec<Vec3<S>>,
    extents: Vec<Extent<S>>,
    couplings: Vec<Coupling>,
    answers: Vec<InverseInertia<S>>,
    yields: Vec<S>,
    touches: [Vec<Touch<S>>; 2],
    /// Contacts of the last step and of the one before.
    pub(super) counts: [usize; 2],
}

impl<S: Scalar> Room<S> {
    /// For so many ports, nodes, answers and numbers of the state, things and contacts at once.
    pub(super) fn new([ports, points, answers, n]: [usize; 4], [things, contacts]: [usize; 2]) -> Self {
        Room {
            scratch: vec![S::ZERO; StepMemory::<S>::scratch(n)],
            frames: [0; 2].map(|_| vec![Frame::inertial(); ports]),
            twists: [0; 3].map(|_| vec![Twist::zero(); ports + points]),
            normals: vec![[S::ZERO; 3]; points],
            extents: vec![Extent::everywhere(); things],
            couplings: vec![Coupling::default(); ports],
            answers: vec![[[S::ZERO; 6]; 6]; answers],
            yields: vec![S::ZERO; points],
            touches: [0; 2].map(|_| vec![Touch::empty(); contacts]),
            counts: [0, 0],
        }
    }

    /// Numbers of ports, nodes and answers.
    pub(super) fn sizes(&self) -> [usize; 3] {
        [self.frames[0].len(), self.normals.len(), self.answers.len()]
    }

    /// The memory of a step; the caller keeps its counts.
    pub(super) fn memory(&mut self) -> StepMemory<'_, S> {
        let [first, last] = &mut self.frames;
        let [start, free, end] = &mut self.twists;
        let [now, before] = &mut self.touches;
        StepMemory {
            scratch: &mut self.scratch,
            frames: [first, last],
            twists: [start, free, end],
            normals: &mut self.normals,
            inertias: Inertias {
                couplings: &mut self.couplings,
                answers: &mut self.answers,
                nodes: &mut self.yields,
            },
            extents: &mut self.extents,
            touches: [now, before],
            counts: self.counts,
        }
    }
}
