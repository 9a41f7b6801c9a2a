//! Impact of all contacts at one instant, applied to the state.

use super::{LocatedReport, PartialStep, USUAL};
use crate::mechanism::Fault;
use crate::ode::Ode;
use crate::real::Scalar;
use crate::rigid::law::Kind;
use crate::rigid::scene::{HIGHEST, OVERLAP};
use crate::rigid::struck::Struck;
use crate::world::carrier::Carrier;
use crate::world::detect::Touch;
use crate::world::impact::{Setting, Spare};
use crate::world::island::Island;
use crate::world::observer::{Observer, Strike};
use crate::world::pressed::Pressed;
use crate::world::whole::{StepMemory, World};

impl<S: Scalar> PartialStep<'_, '_, S> {
    /// Does any touching contact close?
    fn closes(&self) -> bool {
        self.touches().iter().any(|touch| touch.start[0] < -self.rounding.rate)
    }

    /// Notes the pairs with an overlap that was no contact in the last piece. Facets that turn towards each other catch
    /// what is behind them already.
    fn note_caught(&mut self, earlier: usize) {
        let [now, before] = &self.memory.touches;
        let earlier = before.get(..earlier).unwrap_or_default();
        let deepest = -S::from_f64(OVERLAP) * self.rounding.gap;
        let known = |touch: &Touch<S>| earlier.iter().any(|own| own.is(touch.pair, touch.id));
        for touch in now.iter().take(self.known) {
            if touch.gap < deepest - touch.sagitta
                && !known(touch)
                && let Some(overlaps) = self.overlaps.get_mut(touch.pair)
            {
                *overlaps = true;
            }
        }
    }

    /// Ends bounces that have died out: if each contact that closes bounced so low in the last piece, of this `length`,
    /// that it was always found, all have e = 0. `earlier` contacts were known at the start of that piece.
    ///
    /// A contact is found again one gap that counts as zero deeper than it was left, which alone keeps bounces as high
    /// as half that gap / (1 - e) alive for ever. A bounce that ends within that gap is found at the start of the next
    /// step, whose last piece is not known: it dies out by its height under a usual acceleration, or where it has sunk
    /// in bounce by bounce. With e = 1 no bounce dies out.
    fn end_bounces(&mut self, earlier: usize, length: S) {
        let earlier = self.memory.touches[1].get(..earlier).unwrap_or_default();
        let (gap, rate) = (self.rounding.gap, self.rounding.rate);
        let (is_first, deepest) = (length <= S::ZERO, -S::from_f64(OVERLAP) * gap);
        let bounces = |touch: &Touch<S>| {
            let speed = -touch.start[0];
            let height = if is_first {
                S::from_f64(0.5 / USUAL) * speed * speed
            } else {
                // With this speed at both ends a bounce is as high as a quarter of speed times duration.
                S::from_f64(0.25) * length * speed
            };
            let (lost, highest) = (S::ONE - touch.contact.restitution, S::from_f64(HIGHEST) * gap);
            let again = is_first || earlier.iter().any(|own| own.is(touch.pair, touch.id));
            let overlaps = self.overlaps.get(touch.pair).is_some_and(|overlaps| *overlaps);
            let has_sunk = is_first && !overlaps && touch.gap < deepest - touch.sagitta;
            let has_died_out = has_sunk || (again && lost * height <= gap);
            lost <= S::ZERO || height > highest || !has_died_out
        };
        if self.touches().iter().any(|touch| touch.start[0] < -rate && bounces(touch)) {
            return;
        }
        // One contact that comes to rest lifts others that were at rest by less than it fell: they rest too.
        let fastest = |most: S, touch: &Touch<S>| most.max(-touch.start[0]);
        self.rounding.still = self.touches().iter().fold(S::ZERO, fastest);
        let touches = self.memory.touches[0].iter_mut().take(self.known);
        touches.for_each(|touch| touch.contact.restitution = S::ZERO);
    }
}

impl<S: Scalar, C: Carrier<S>> World<'_, S, C> {
    /// Resolves the impact of all contacts, if any of them closes; returns whether one did. `length`: of the piece of
    /// the step before, 0 if this is the first; `since`: time since the step's start.
    pub(super) fn strike(
        &mut self,
        kinds: &[Kind],
        (t, length): (S, S),
        way: &mut PartialStep<S>,
        report: &mut LocatedReport<S>,
        (since, watch): (S, &mut impl Observer<S>),
    ) -> Result<bool, Fault> {
        let earlier = way.known;
        way.memory.touches.swap(0, 1);
        self.find_touches(t, way)?;
        if length > S::ZERO {
            way.note_caught(earlier);
        }
        if !way.closes() {
            return Ok(false);
        }
        way.end_bounces(earlier, length);
        let before = self.island.energy(t, way.now[0])?.total();
        let StepMemory { twists: [one, twists, other], inertias, touches: [touches, _], .. } =
            &mut *way.memory;
        let touches = touches.get(..way.known).unwrap_or_default();
        let [struck, lifts] = &mut way.struck;
        let struck = struck.get_mut(..touches.len()).ok_or(Fault::TooManyContacts)?;
        let touched = |port: usize| touches.iter().any(|own| own.contact.touches_body(port));
        self.island.ask_yields(t, way.now[0], inertias, touched)?;
        for (s, touch) in struck.iter_mut().zip(touches) {
            *s = Struck::new(touch.contact, inertias);
        }
        let law_of = |touch: &Touch<S>| Some((*kinds.get(touch.pair)?, touch.contact.restitution));
        let law =
            touches.first().and_then(law_of).filter(|law| touches.iter().all(|t| law_of(t) == Some(*law)));
        let island = &self.island;
        let ports = island.memory.frames.len();
        let setting = Setting { body: &island.body, pos: island.memory.pos, ports, inertia: &*inertias };
        let settled = setting.strike(struck, law, twists, &mut Spare { lifts, twists: [one, other] });
        report.settled &= settled;
        // The island still stands where it was before the impact.
        Pressed::read_twists(self, one);
        watch.strike(&Strike { time: since, touches, struck, ends: [&**one, &**twists] });
        let [x, low] = &mut way.now;
        let [a, b, c] = &mut way.spare;
        let contacts = struck.iter().map(|s| (&s.contact, s.contact.impulse));
        self.island.load_impulses(contacts);
        // What moves as commanded gives work in an impact as elsewhere: J . V.
        let Island { carrier, memory: own, .. } = &mut self.island;
        let mut given = S::ZERO;
        carrier.drive_powers(own.frames, own.wrenches, &mut |member, work| {
            given = given + work;
            watch.carried(member, [work, S::ZERO]);
        });
        self.island.set_speeds(x, twists)?;
        self.island.push_carrier(t, x, [&mut **a, &mut **b, &mut **c], false)?;
        if self.island.projections() > 0 {
            self.island.set_time(t);
            self.island.project(x)?;
        }
        let n_q = self.island.n_q();
        low.iter_mut().skip(n_q).for_each(|low| *low = S::ZERO);
        let after = self.island.energy(t, x)?.total();
        report.impacts += 1;
        report.accounts.drive = report.accounts.drive + given;
        report.accounts.impact = report.accounts.impact + (before + given - after);
        self.find_touches(t, way)?;
        Ok(true)
    }
}
