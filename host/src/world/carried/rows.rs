//! Rows, energies, pictures and steps of a world of flexible parts.

use super::air::SAVED;
use super::methods::Contacts;
use super::rest::Settle;
use super::{CarriedWorld, Place, words};
use crate::world::accounts::Accounts;
use crate::world::carriers::HostCarrier;
use crate::world::engine::{self, Column, Energies, Engine, Event, Settled};
use crate::world::picture::Picture;
use crate::world::ported::Ported;
use crate::world::pushed::Pushed;
use crate::world::rounding::{wide, wide_shape};
use crate::world::touching::Touching;
use smartbed_runtime::vec3::Vec3;
use smartbed_runtime::world::{Accounts as Works, Carrier, Cell, Content};

impl<S: Settle> Engine for CarriedWorld<S> {
    fn columns(&self) -> Vec<Column> {
        let mut columns = Vec::new();
        let mut add = |name: String, unit: &str, by_default: bool| {
            columns.push(Column { name, unit: unit.to_owned(), by_default });
        };
        for (number, (name, place)) in self.names.iter().zip(&self.places).enumerate() {
            match place {
                Place::Carrier(number, _) => match &self.carriers[*number] {
                    HostCarrier::Mechanism(ported) => {
                        let n_q = ported.n_q();
                        for (n, (own, unit)) in ported.names.iter().enumerate() {
                            add(format!("{name}.{own}"), unit, n < n_q);
                        }
                        for (own, unit) in ported.closed() {
                            add(format!("{name}.{own}"), unit, false);
                        }
                    }
                    HostCarrier::Floating(_) => {
                        crate::world::rigid::NUMBERS.iter().for_each(|(own, unit)| {
                            add(format!("{name}.{own}"), unit, ["x", "y", "z"].contains(own))
                        })
                    }
                    HostCarrier::Still(_) => {}
                },
                Place::Shape(..) => {}
                Place::Nodes(nodes, _, cell) => {
                    let air = self.air_of(number);
                    add(format!("{name}.top"), "m", true);
                    if cell.is_some() {
                        add(format!("{name}.volume"), "m^3", true);
                        add(format!("{name}.gauge"), "Pa", true);
                    }
                    if air.is_some() {
                        add(format!("{name}.temperature"), "K", false);
                        add(format!("{name}.gas_mass"), "kg", false);
                        add(format!("{name}.heat"), "J", false);
                    }
                    for node in 0..nodes.len() {
                        ["x", "y", "z"]
                            .iter()
                            .for_each(|axis| add(format!("{name}.{axis}{node}"), "m", false));
                    }
                }
            }
        }
        if let Some(touching) = &self.touching {
            let pairs = touching.parts.iter().map(|parts| parts.map(|part| self.names[part].as_str()));
            columns.extend(Pushed::columns(pairs));
        }
        columns
    }

    fn state(&mut self) -> Result<Vec<f64>, String> {
        self.press();
        let (t, x) = (S::from_f64(self.t), self.x.clone());
        self.with(|mut island| island.place(t, &x)).map_err(words)?;
        let n_q = self.split();
        let (mut q, mut u, mut values) = (0, n_q, Vec::new());
        let mut rows: Vec<Vec<S>> = Vec::new();
        for carrier in &mut self.carriers {
            let (own_q, own_u) = (&x[q..q + carrier.n_q()], &x[u..u + carrier.n_u()]);
            rows.push(match carrier {
                HostCarrier::Floating(floating) => {
                    let state = floating.state(own_q, own_u).map_err(words)?;
                    let spin = floating.body.angular_velocity(&state);
                    // The method integrates Euler parameters of any length.
                    let turn = state.attitude.parameters();
                    [&state.position[..], &turn, &state.velocity, &spin].concat()
                }
                HostCarrier::Mechanism(own) => {
                    let closed = own.closed_forms(t, own_q, own_u).map_err(words)?;
                    let values: Vec<S> = closed.iter().map(|[value, _]| *value).collect();
                    [own_q, own_u, &values].concat()
                }
                HostCarrier::Still(_) => Vec::new(),
            });
            (q, u) = (q + carrier.n_q(), u + carrier.n_u());
        }
        for (part, place) in self.places.iter().enumerate() {
            match place {
                Place::Carrier(number, _) => values.extend(rows[*number].iter().map(|x| x.to_f64())),
                Place::Shape(..) => {}
                Place::Nodes(nodes, _, cell) => {
                    let pos = &self.room.pos[nodes.clone()];
                    values.push(pos.iter().map(|p| p[2].to_f64()).fold(f64::NEG_INFINITY, f64::max));
                    if let Some(cell) = cell.map(|cell| self.fixed.cells[cell]) {
                        let volume = cell.volume(&self.fixed.facets, &self.room.pos);
                        values.push(volume.to_f64());
                        values.push(cell.content.gauge_pressure(volume).map_or(f64::NAN, S::to_f64));
                        values.extend(
                            self.air_of(part).iter().flat_map(|air| air.told(&self.fixed.cells, volume)),
                        );
                    }
                    values.extend(pos.as_flattened().iter().map(|x| x.to_f64()));
                }
            }
        }
        values.extend(self.pushed());
        Ok(values)
    }

    fn energies(&mut self) -> Result<Energies, String> {
        let (t, x) = (S::from_f64(self.t), self.x.clone());
        let overlaps: f64 = self.stored_by_pairs(t, &x).map_err(words)?.iter().sum();
        let island = self.with(|mut island| island.energy(t, &x)).map_err(words)?;
        let Works { damping, drag, impact, friction, drive } = self.works;
        let mut energies = Energies {
            kinetic: island.body.kinetic.to_f64(),
            gravity: island.body.gravity.to_f64(),
            spring: island.body.spring.to_f64() + overlaps,
            pressure: island.body.pressure.to_f64(),
            damping,
            drag,
            impact,
            friction,
            actuator: drive,
        };
        let mut endless = None;
        self.each_mechanism(self.of_carriers(&x), |carrier, ported, q, u, wrenches| {
            let account = ported.account(t, q, u, wrenches)?;
            let [kinetic, gravity, spring] = account.stored.map(S::to_f64);
            if !(kinetic.is_finite() && account.driven.to_f64().is_finite()) {
                endless = Some(carrier);
            }
            energies.kinetic += kinetic;
            energies.gravity += gravity;
            energies.spring += spring;
            Ok(())
        })
        .map_err(words)?;
        endless.map_or(Ok(()), |carrier| Err(self.endless(carrier)))?;
        let n_q = self.split();
        let (mut q, mut u) = (0, n_q);
        for carrier in &mut self.carriers {
            let (next_q, next_u) = (q + carrier.n_q(), u + carrier.n_u());
            if let HostCarrier::Floating(own) = carrier {
                let (kinetic, gravity) = own.energy(t, &x[q..next_q], &x[u..next_u]).map_err(words)?;
                energies.kinetic += kinetic.to_f64();
                energies.gravity += gravity.to_f64();
            }
            (q, u) = (next_q, next_u);
        }
        Ok(energies)
    }

    fn picture(&mut self) -> Result<Picture, String> {
        self.press();
        let (t, x) = (S::from_f64(self.t), self.x.clone());
        self.with(|mut island| island.place(t, &x)).map_err(words)?;
        let mut mechanisms = Vec::new();
        self.each_mechanism(self.of_carriers(&x), |_, ported, q, u, _| {
            mechanisms.push(ported.picture(t, q, u)?);
            Ok(())
        })
        .map_err(words)?;
        let (mut picture, mut next, mut port) = (Picture::default(), mechanisms.into_iter(), 0);
        for place in &self.places {
            match place {
                Place::Shape(port, place, shape) => {
                    let frame = self.room.frames[*port];
                    let axes = place.axes.map(|axis| frame.to_inertial(axis));
                    picture.solid(&wide_shape(shape), wide(frame.point(place.origin)), axes.map(wide));
                }
                Place::Nodes(nodes, ..) => {
                    picture.points.extend(self.room.pos[nodes.clone()].iter().map(|x| wide(*x)))
                }
                Place::Carrier(number, shape) => {
                    let frame = self.room.frames.get(port);
                    port += self.carriers[*number].n_ports();
                    match (shape, frame) {
                        (Some(shape), Some(frame)) => {
                            picture.solid(&wide_shape(shape), wide(frame.origin), frame.axes.map(wide));
                        }
                        (Some(_), None) => {}
                        (None, _) => {
                            if let Some(own) = next.next() {
                                picture.append(&own);
                            }
                        }
                    }
                }
            }
        }
        picture.forces = self.touching.as_ref().map(|touching| touching.forces.clone()).unwrap_or_default();
        Ok(picture)
    }

    fn step(&mut self, h: f64, found: &mut Vec<Event>) -> Result<(), String> {
        self.breathing(h, |world| world.move_on(h, found))?;
        self.watch_chatter()
    }

    fn inputs(&self) -> Vec<String> {
        self.drivable().into_iter().map(|(name, _)| name).collect()
    }

    fn set_input(&mut self, input: usize, value: f64) {
        self.drive_input(input, value);
    }

    fn settle(&mut self) -> Result<Settled, String> {
        S::settle(self)
    }

    fn keep_accounts(&mut self) {
        self.open_books();
    }

    fn accounts(&mut self) -> Result<Accounts, String> {
        self.balance()
    }

    fn save(&self) -> Vec<f64> {
        let Works { damping, drag, impact, friction, drive } = self.works;
        let accounts = [self.t, drive, damping, drag, impact, friction];
        let airs: Vec<f64> = self.airs.iter().flat_map(|air| air.save(&self.fixed.cells)).collect();
        let state: Vec<f64> = self.x.iter().chain(&self.low).map(|x| x.to_f64()).collect();
        let touching = self.touching.as_ref().map_or_else(Vec::new, Touching::save);
        [&accounts[..], &state, &airs, &touching].concat()
    }

    fn load(&mut self, numbers: &[f64]) -> Result<(), String> {
        let n = self.x.len();
        let air = 6 + 2 * n + SAVED * self.airs.len();
        if numbers.len() != air + self.touching.as_ref().map_or(0, |touching| touching.save().len()) {
            return Err(engine::other_world());
        }
        let (numbers, pairs) = numbers.split_at(air);
        if let Some(touching) = &mut self.touching {
            touching.load(pairs);
        }
        let &[t, drive, damping, drag, impact, friction, ref state @ ..] = numbers else {
            return Err(engine::other_world());
        };
        (self.t, self.works) = (t, Works { damping, drag, impact, friction, drive });
        for (x, own) in self.x.iter_mut().chain(&mut self.low).zip(state) {
            *x = S::from_f64(*own);
        }
        for (air, own) in self.airs.iter_mut().zip(state[2 * n..].chunks_exact(SAVED)) {
            air.load(own, &mut self.fixed.cells);
        }
        Ok(())
    }

    fn middles(&self) -> Vec<Vec3<f64>> {
        let starts = self.carrier_starts();
        let middle = |place: &Place<S>| match place {
            Place::Carrier(number, _) => match &self.carriers[*number] {
                HostCarrier::Floating(_) => {
                    let first = starts[*number][0];
                    wide([0, 1, 2].map(|axis| self.x[first + axis]))
                }
                HostCarrier::Still(still) => wide(still.0.origin),
                HostCarrier::Mechanism(_) => [0.0; 3],
            },
            Place::Shape(..) | Place::Nodes(..) => [0.0; 3],
        };
        self.places.iter().map(middle).collect()
    }

    fn largest_term(&self) -> f64 {
        let facets = &self.fixed.facets;
        let of = |cell: &Cell<S>| {
            let Content::Sealed { chamber, state } = &cell.content else { return 0.0 };
            let volume = cell.volume(facets, &self.room.pos);
            chamber.pressure(state, volume).map_or(0.0, |pressure| (pressure * volume).to_f64())
        };
        self.fixed.cells.iter().map(of).fold(0.0, f64::max)
    }

    fn pivots(&self) -> Vec<(&str, f64)> {
        self.mechanisms().map(|(name, own)| (name, own.pivot.to_f64())).collect()
    }

    fn passed(&self, run: [f64; 2]) -> Option<(&str, f64)> {
        // Copies of one mechanism do the same at the same times.
        let mut looked: Vec<&Ported<S>> = Vec::new();
        self.mechanisms().find_map(|(name, own)| {
            if looked.iter().any(|other| own.is_copy_of(other)) {
                return None;
            }
            looked.push(own);
            Some((name, own.passed(run)?))
        })
    }

    fn warnings(&self) -> Vec<String> {
        let steps = |count: usize| smartbed_codegen::words::count(count, "step");
        let mut said = self.bars_between_nodes();
        said.extend(self.parts_through_parts());
        said.extend(self.chatters());
        said.extend(self.rims.iter().cloned());
        if self.unsettled > 0 {
            let count = steps(self.unsettled);
            said.push(format!(
                "{count}: the iteration over the contacts did not converge; take a smaller step"
            ));
        }
        if self.forced > 0 {
            said.push(format!(
                "{} contained more events than a step may be split at, or contact forces that were not found, as where \
                 much friction jams: the rest of each was computed with e = 0, without locating events; take a smaller \
                 step, or impact = \"moreau\"",
                steps(self.forced)
            ));
        }
        said
    }

    fn method(&self) -> String {
        let name = self.method.0;
        match self.contacts {
            Contacts::None => format!("{name}, flexible parts and what carries them as one"),
            Contacts::Located if self.touching.as_ref().is_some_and(Touching::only_yields) => {
                format!("{name}, contact forces by depth")
            }
            Contacts::Located => format!("{name}, touches located in time"),
            Contacts::Unlocated => {
                format!("{name}, touches not located: of order 2 where nothing touches, else 1")
            }
        }
    }
}

impl<S: Settle> CarriedWorld<S> {
    /// Names of the mechanisms, and the mechanisms.
    fn mechanisms(&self) -> impl Iterator<Item = (&str, &Ported<S>)> {
        let of = |(name, place): (_, &Place<S>)| match *place {
            Place::Carrier(number, _) => match &self.carriers[number] {
                HostCarrier::Mechanism(ported) => Some((name, &**ported)),
                _ => None,
            },
            _ => None,
        };
        self.names.iter().map(String::as_str).zip(&self.places).filter_map(of)
    }

    /// Observes signs of speeds in laws and loads of mechanisms after a step.
    pub(super) fn watch_chatter(&mut self) -> Result<(), String> {
        let watched =
            |own: &HostCarrier<S>| matches!(own, HostCarrier::Mechanism(ported) if ported.chatter.any());
        if !self.carriers.iter().any(watched) {
            return Ok(());
        }
        let (t, x) = (S::from_f64(self.t), self.x.clone());
        self.each_mechanism(self.of_carriers(&x), |_, ported, q, u, _| ported.watch(t, q, u)).map_err(words)
    }

    /// Warnings of dry friction that chattered.
    fn chatters(&self) -> impl Iterator<Item = String> {
        let of = |(name, place): (&String, &Place<S>)| match place {
            &Place::Carrier(number, _) => match &self.carriers[number] {
                HostCarrier::Mechanism(ported) => ported.chatter.warning(Some(name)),
                _ => None,
            },
            _ => None,
        };
        self.names.iter().zip(&self.places).filter_map(of)
    }

    /// The message for a mechanism whose energy or power is no number.
    fn endless(&self, carrier: usize) -> String {
        let is_it = |place: &Place<S>| matches!(place, Place::Carrier(number, _) if *number == carrier);
        let part = self.places.iter().position(is_it).unwrap_or_default();
        format!(
            "`{}` has an energy or a power that is not finite here; expected `command` and `law` whose values, rates and \
             second rates are finite at every time from 0 on: sqrt(t) starts with infinite speed, \
             1 - cos(w*t) from rest",
            self.names[part]
        )
    }
}
