//! The results of a program as roots of its DAG, and functions that replace all of them.

use super::answer::Answer;
use super::derived::Program;
use crate::expr::{ExprId, SymbolId};
use rustc_hash::FxHashMap as HashMap;

impl Program {
    /// All results of all answers.
    #[must_use]
    pub fn all_roots(&self) -> Vec<ExprId> {
        let mut roots = self.forward_dynamics();
        roots.push(self.rates.worst_pivot);
        roots.extend(self.energy);
        roots.extend(self.speeds.iter().map(|(_, e)| *e));
        roots.extend(self.outputs.iter().map(|(_, e)| *e));
        roots.extend(self.correction.iter().map(|(_, e)| *e));
        roots.push(self.residual);
        roots.extend(&self.speed_correction);
        roots.extend(self.augmented_roots());
        roots.extend(self.drive);
        roots.extend(self.asked_roots());
        roots
    }

    /// The results of all requested answers.
    fn asked_roots(&self) -> Vec<ExprId> {
        self.answers.iter().flat_map(Answer::roots).collect()
    }

    /// q' and u'.
    #[must_use]
    pub fn forward_dynamics(&self) -> Vec<ExprId> {
        self.rates.q_dot.iter().chain(&self.rates.u_dot).copied().collect()
    }

    /// Operations in one evaluation of q' and u': at run time, and of parameters alone.
    #[must_use]
    pub fn operations(&self) -> usize {
        self.dag.state_cost(&self.forward_dynamics())
    }

    /// Substitutes expressions for symbols in every result.
    pub(super) fn substitute(&mut self, replacement: &HashMap<SymbolId, ExprId>) {
        if replacement.is_empty() {
            return;
        }
        let roots = self.all_roots();
        let image = self.dag.rebuild(&roots, |dag, id, _| replacement.get(&dag.as_symbol(id)?).copied());
        self.map_roots(|e| image.of(e));
        for pivot in &mut self.pivots {
            pivot.value = image.of(pivot.value);
        }
    }

    /// Replaces every result by its image, which must have the same value.
    pub(super) fn map_roots(&mut self, mut image: impl FnMut(ExprId) -> ExprId) {
        self.map_answers(&mut image);
        let augmented = &mut self.augmented;
        for part in
            [&mut augmented.mass, &mut augmented.jacobian, &mut augmented.forcing, &mut augmented.bias]
        {
            part.iter_mut().for_each(|e| *e = image(*e));
        }
    }

    /// All results except those of the augmented form, in groups: forward dynamics with the worst pivot, then the other
    /// answers of every program, then the requested answers.
    pub(super) fn groups(&self) -> Vec<Vec<ExprId>> {
        let mut rates = self.forward_dynamics();
        rates.push(self.rates.worst_pivot);
        let named = self.speeds.iter().chain(&self.outputs).map(|(_, e)| *e);
        let mut others: Vec<ExprId> = self.correction.iter().map(|(_, e)| *e).collect();
        others.push(self.residual);
        others.extend(&self.speed_correction);
        others.extend(self.energy.into_iter().chain(named).chain(self.drive));
        let asked = self.asked_roots();
        let mut groups = vec![rates, others];
        groups.extend((!asked.is_empty()).then_some(asked));
        groups
    }

    /// Replaces the results that [`Program::groups()`] lists by their images.
    pub(super) fn map_answers(&mut self, mut image: impl FnMut(ExprId) -> ExprId) {
        let rates = &mut self.rates;
        for e in rates.q_dot.iter_mut().chain(&mut rates.u_dot) {
            *e = image(*e);
        }
        rates.worst_pivot = image(rates.worst_pivot);
        for e in &mut self.energy {
            *e = image(*e);
        }
        for (_, e) in self.speeds.iter_mut().chain(&mut self.outputs) {
            *e = image(*e);
        }
        for (_, e) in &mut self.correction {
            *e = image(*e);
        }
        self.residual = image(self.residual);
        self.speed_correction.iter_mut().for_each(|e| *e = image(*e));
        self.drive = self.drive.map(&mut image);
        for part in self.answers.iter_mut().flat_map(|answer| &mut answer.parts) {
            part.values.iter_mut().for_each(|e| *e = image(*e));
        }
    }

    /// Mass matrix, Jacobian, forcing and bias of the augmented form, one after the other.
    #[must_use]
    pub fn augmented_roots(&self) -> Vec<ExprId> {
        let parts = &self.augmented;
        [&parts.mass, &parts.jacobian, &parts.forcing, &parts.bias].into_iter().flatten().copied().collect()
    }
}
