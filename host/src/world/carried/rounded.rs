//! A world in another scalar: built in f64, every number of it rounded once, as those are that the chip's tables hold.
//!
//! In: a world in f64 and its assembly. Out: the same in f32. Its engine finds rest in f64 and rounds the state there.

use super::air::Air;
use super::{CarriedWorld, Fixed, Place, Room};
use crate::engine::ScalarKind;
use crate::failure::Failure;
use crate::world::accounts::Accounts;
use crate::world::assembly::Assembly;
use crate::world::carriers::HostCarrier;
use crate::world::engine::{Column, Energies, Engine, Event, Settled};
use crate::world::picture::Picture;
use crate::world::rounding::{frame, numbers, shape, vector};
use smartbed_runtime::flexible::Spring;
use smartbed_runtime::gas::{Chamber, Gas, GasState, Line, Nozzle, Regulated, Source};
use smartbed_runtime::real::Scalar;
use smartbed_runtime::rigid::RigidBody;
use smartbed_runtime::vec3::Vec3;
use smartbed_runtime::world::{Attachment, Cell, Content, Floating, Still, Wall, Wrench};

/// A world in f32, and the one in f64 that it was rounded from.
#[derive(Clone, Debug)]
struct Single {
    wide: CarriedWorld,
    own: CarriedWorld<f32>,
}

/// The engine of a world in f32: all its parts go together.
///
/// # Errors
/// What cannot be derived, assembled or stepped, in words.
pub fn engine(assembly: &Assembly) -> Result<Box<dyn Engine>, Failure> {
    let wide = CarriedWorld::new(assembly)?;
    Ok(Box::new(Single { own: wide.rounded(), wide }))
}

impl Engine for Single {
    fn columns(&self) -> Vec<Column> {
        self.own.columns()
    }

    fn state(&mut self) -> Result<Vec<f64>, String> {
        self.own.state()
    }

    fn energies(&mut self) -> Result<Energies, String> {
        self.own.energies()
    }

    fn picture(&mut self) -> Result<Picture, String> {
        self.own.picture()
    }

    fn step(&mut self, h: f64, found: &mut Vec<Event>) -> Result<(), String> {
        self.own.step(h, found)
    }

    fn inputs(&self) -> Vec<String> {
        self.own.inputs()
    }

    fn set_input(&mut self, input: usize, value: f64) {
        self.own.set_input(input, value);
    }

    fn settle(&mut self) -> Result<Settled, String> {
        let settled = self.wide.settle()?;
        self.own.load(&self.wide.save())?;
        Ok(settled)
    }

    fn keep_accounts(&mut self) {
        self.own.keep_accounts();
    }

    fn accounts(&mut self) -> Result<Accounts, String> {
        self.own.accounts()
    }

    fn save(&self) -> Vec<f64> {
        self.own.save()
    }

    fn load(&mut self, numbers: &[f64]) -> Result<(), String> {
        self.own.load(numbers)
    }

    fn scalar(&self) -> ScalarKind {
        ScalarKind::F32
    }

    fn pivots(&self) -> Vec<(&str, f64)> {
        self.own.pivots()
    }

    fn passed(&self, run: [f64; 2]) -> Option<(&str, f64)> {
        self.own.passed(run)
    }

    fn warnings(&self) -> Vec<String> {
        self.own.warnings()
    }

    fn middles(&self) -> Vec<Vec3<f64>> {
        self.own.middles()
    }

    fn largest_term(&self) -> f64 {
        self.own.largest_term()
    }

    fn method(&self) -> String {
        self.own.method()
    }
}

impl CarriedWorld {
    /// The same in another scalar.
    #[must_use]
    pub fn rounded<S: Scalar>(&self) -> CarriedWorld<S> {
        let carriers = self.carriers.iter().map(|carrier| match carrier {
            HostCarrier::Mechanism(wide) => HostCarrier::Mechanism(Box::new(wide.rounded())),
            HostCarrier::Floating(Floating { body, gravity }) => {
                let body = RigidBody { mass: S::from_f64(body.mass), inertia: vector(body.inertia) };
                HostCarrier::Floating(Floating { body, gravity: vector(*gravity) })
            }
            HostCarrier::Still(Still(at)) => HostCarrier::Still(Still(frame(at))),
        });
        CarriedWorld {
            carriers: carriers.collect(),
            names: self.names.clone(),
            places: self.places.iter().map(place).collect(),
            fixed: self.fixed.rounded(),
            room: self.room.rounded(),
            x: numbers(&self.x),
            low: numbers(&self.low),
            scratch: numbers(&self.scratch),
            contacts: self.contacts,
            method: self.method,
            h: self.h,
            starts: self.starts.iter().map(frame).collect(),
            t: self.t,
            works: self.works,
            airs: self.airs.iter().map(air).collect(),
            touching: self.touching.as_ref().map(|touching| touching.rounded()),
            unsettled: self.unsettled,
            rims: self.rims.clone(),
            forced: self.forced,
            books: None,
            stable: self.stable,
        }
    }
}

impl Fixed {
    fn rounded<S: Scalar>(&self) -> Fixed<S> {
        let spring = |own: &Spring<f64>| Spring {
            tail: own.tail,
            head: own.head,
            stiffness: S::from_f64(own.stiffness),
            damping: S::from_f64(own.damping),
            rest_length: S::from_f64(own.rest_length),
        };
        let wall = |own: Wall<f64>| Wall {
            first: own.first,
            port: own.port,
            attachments: own.attachments,
            volume: S::from_f64(own.volume),
            area: vector(own.area),
        };
        let cell = |own: &Cell<f64>| Cell {
            facets: own.facets,
            content: content(&own.content),
            form: own.form,
            wall: own.wall.map(wall),
        };
        let attachment = |own: &Attachment<f64>| Attachment {
            node: own.node,
            port: own.port,
            place: vector(own.place),
            push: vector(own.push),
        };
        let mut rounded = Fixed {
            mass: numbers(&self.mass),
            inverse_mass: Vec::new(),
            held: self.held.clone(),
            springs: self.springs.iter().map(spring).collect(),
            facets: self.facets.clone(),
            grids: self.grids.iter().map(|grid| grid.rounded()).collect(),
            cells: self.cells.iter().map(cell).collect(),
            attachments: self.attachments.iter().map(attachment).collect(),
            restrained: self.restrained.clone(),
            gravity: vector(self.gravity),
            air_drag: S::from_f64(self.air_drag),
        };
        rounded.weigh();
        rounded
    }
}

impl Room {
    fn rounded<S: Scalar>(&self) -> Room<S> {
        let rows = |rows: &[Vec3<f64>]| rows.iter().map(|row| vector(*row)).collect();
        Room {
            pos: rows(&self.pos),
            vel: rows(&self.vel),
            elastic: rows(&self.elastic),
            viscous: rows(&self.viscous),
            frames: self.frames.iter().map(frame).collect(),
            wrenches: vec![Wrench::zero(); self.wrenches.len()],
        }
    }
}

fn place<S: Scalar>(of: &Place) -> Place<S> {
    match of {
        Place::Carrier(number, own) => Place::Carrier(*number, own.as_ref().map(shape)),
        Place::Shape(port, at, own) => Place::Shape(*port, frame(at), shape(own)),
        Place::Nodes(nodes, facets, cell) => Place::Nodes(nodes.clone(), facets.clone(), *cell),
    }
}

fn gas<S: Scalar>(of: &Gas<f64>) -> Gas<S> {
    Gas {
        gas_constant: S::from_f64(of.gas_constant),
        heat_capacity_ratio: S::from_f64(of.heat_capacity_ratio),
    }
}

fn content<S: Scalar>(of: &Content<f64>) -> Content<S> {
    let real = S::from_f64;
    match of {
        Content::Regulated(own) => Content::Regulated(Regulated {
            gas: gas(&own.gas),
            gauge: real(own.gauge),
            ambient: real(own.ambient),
        }),
        Content::Sealed { chamber, state } => Content::Sealed {
            chamber: Chamber {
                gas: gas(&chamber.gas),
                exponent: real(chamber.exponent),
                reference_volume: real(chamber.reference_volume),
                ambient: real(chamber.ambient),
            },
            state: GasState { reference_pressure: real(state.reference_pressure), mass: real(state.mass) },
        },
    }
}

fn air<S: Scalar>(of: &Air) -> Air<S> {
    let real = S::from_f64;
    let line = |own: &Line<f64>| Line {
        nozzle: Nozzle {
            conductance: real(own.nozzle.conductance),
            critical_ratio: real(own.nozzle.critical_ratio),
        },
        opening: real(own.opening),
        reservoir: Source {
            pressure: real(own.reservoir.pressure),
            temperature: real(own.reservoir.temperature),
        },
    };
    Air::new(of.part, of.cell, of.lines.each_ref().map(|own| own.as_ref().map(line)))
}
