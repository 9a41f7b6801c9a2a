//! Impact of all contacts at one instant, applied to the state.

use super::{LocatedReport, PartialStep};
use crate::mechanism::Fault;
use crate::ode::Ode;
use crate::real::Scalar;
use crate::rigid::law::Kind;
use crate::rigid::several::Struck;
use crate::world::carrier::Carrier;
use crate::world::detect::Touch;
use crate::world::impact::{Setting, Spare};
use crate::world::island::Island;
use crate::world::observer::Ends;
use crate::world::pressed::Pressed;
use crate::world::whole::{StepMemory, World};

/// Height of a bounce times 1 - e, in gaps that count as zero, below which a contact comes to rest. A contact is found
/// again one such gap deeper than it was left, which alone keeps a bounce of half this height alive for ever.
const LAST_BOUNCE: f64 = 1.0;

impl<S: Scalar, C: Carrier<S>> World<'_, S, C> {
    /// Resolves the impact of all contacts, if any of them closes; returns whether one did. `length`: of the piece of
    /// the step before, 0 if this is the first.
    pub(super) fn strike(
        &mut self,
        kinds: &[Kind],
        (t, length): (S, S),
        way: &mut PartialStep<S>,
        report: &mut LocatedReport<S>,
        show: impl FnOnce(&[Touch<S>], &[Struck<S>], Ends<'_, S>),
    ) -> Result<bool, Fault> {
        let before = way.known;
        way.memory.touches.swap(0, 1);
        self.find_touches(t, way)?;
        let closes = |touch: &Touch<S>| touch.start[0] < -way.rounding.rate;
        if !way.touches().iter().any(closes) {
            return Ok(false);
        }
        let [touches, before] = [(0, way.known), (1, before)].map(|(list, known)| {
            let list = &way.memory.touches[list];
            list.get(..known).unwrap_or_default()
        });
        let bounces = |touch: &Touch<S>| {
            // A bounce of this speed at both ends is as high as a quarter of speed times duration.
            let height = -(S::from_f64(0.25) * length * touch.start[0]);
            let limit = S::from_f64(LAST_BOUNCE) * way.rounding.gap;
            let again = before.iter().any(|own| own.pair == touch.pair && own.id == touch.id);
            !again || (S::ONE - touch.contact.restitution) * height > limit
        };
        if !touches.iter().any(|touch| closes(touch) && bounces(touch)) {
            // One contact that comes to rest lifts others that were at rest by less than it fell: they rest too.
            way.rounding.still = touches.iter().fold(S::ZERO, |most, touch| most.max(-touch.start[0]));
            way.memory.touches[0].iter_mut().for_each(|touch| touch.contact.restitution = S::ZERO);
        }
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
        show(touches, struck, [&**one, &**twists]);
        let [x, low] = &mut way.now;
        let [a, b, c] = &mut way.spare;
        let contacts = struck.iter().map(|s| (&s.contact, s.contact.impulse));
        self.island.load_impulses(contacts);
        // What moves as commanded gives work in an impact as elsewhere: J . V.
        let Island { carrier, memory: own, .. } = &mut self.island;
        let given = carrier.drive_power(own.frames, own.wrenches).unwrap_or(S::ZERO);
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
