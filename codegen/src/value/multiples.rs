//! Values that are constant multiples of one another.
//!
//! In: live classes. Out: k x as a further definition of every value that is k times another one, x. A value is a
//! constant multiple of another exactly if their quotient is the same at both points of the field; then the quotient of
//! a value's own two field elements is the same for both, so that multiples are found by hashing instead of by pairs.

use super::field::Field;
use super::graph::{ClassId, Graph, Operation, Signed};
use rustc_hash::FxHashMap as HashMap;

/// Proposes k x for every live value that is k times a live value x.
pub(super) fn propose(graph: &mut Graph, live: &[ClassId]) {
    let values: Vec<Field> = live.iter().flat_map(|&class| graph.classes[class].value).collect();
    let inverses = Field::inverses(&values);
    let quotient = |i: usize| values[2 * i] * inverses[2 * i + 1];
    let mut order: Vec<(Field, usize)> =
        (0..live.len()).map(|i| (quotient(i), i)).filter(|&(quotient, _)| quotient != Field::ONE).collect();
    order.sort_unstable();
    // By value the place of its family in that order; one without relatives has none.
    let mut families = vec![0..0; live.len()];
    let mut start = 0;
    for family in order.chunk_by(|a, b| a.0 == b.0) {
        if family.len() > 1 {
            family.iter().for_each(|&(_, i)| families[i] = start..start + family.len());
        }
        start += family.len();
    }
    let constants = Constants::new(graph);
    for (i, family) in families.into_iter().enumerate() {
        for &(_, j) in order[family].iter().filter(|&&(_, j)| j != i) {
            let x = Signed { class: live[j], negative: false };
            if let Some(factor) = constants.class(graph, values[2 * i] * inverses[2 * j]) {
                graph.propose(Signed { class: live[i], negative: false }, Operation::Product, factor, x);
            }
        }
    }
}

/// The constants of the graph, their products and quotients. Any other factor is not a simple number.
struct Constants {
    /// By constant (canonical sign): the operation and the two constants that give it.
    made: HashMap<Field, (Operation, [Signed; 2])>,
}

impl Constants {
    fn new(graph: &Graph) -> Self {
        let is_constant = |class: &ClassId| {
            let [a, b] = graph.classes[*class].value;
            a == b && graph.classes[*class].is_leaf()
        };
        let known: Vec<ClassId> = graph.classes.ids().filter(is_constant).collect();
        let values: Vec<Field> = known.iter().map(|&class| graph.classes[class].value[0]).collect();
        let inverses = Field::inverses(&values);
        let mut made = HashMap::default();
        made.reserve(2 * known.len() * known.len());
        let operands = |i: usize, j: usize| [i, j].map(|i| Signed { class: known[i], negative: false });
        for i in 0..known.len() {
            for j in 0..known.len() {
                made.insert((values[i] * inverses[j]).canonical(), (Operation::Quotient, operands(i, j)));
                made.insert((values[i] * values[j]).canonical(), (Operation::Product, operands(i, j)));
            }
        }
        Self { made }
    }

    /// The class of a constant, added if necessary. A product of constants is folded when expressions are built.
    fn class(&self, graph: &mut Graph, value: Field) -> Option<Signed> {
        if let Some(known) = graph.find([value, value]) {
            return Some(known);
        }
        let &(operation, [a, b]) = self.made.get(&value.canonical())?;
        let class = graph.class_of(operation, a, b)?;
        (graph.value(class)[0] == value).then_some(class).or_else(|| graph.find([value, value]))
    }
}
