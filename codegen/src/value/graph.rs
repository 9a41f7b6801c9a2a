//! The value graph: classes of equal values, each with all its known definitions.
//!
//! A class stands for a value up to its sign; a definition is one operation on other classes. The value is stored as
//! two elements of a prime field (exact, for the identity test) and as f64 at the guard's states (for round-off
//! bounds).

use super::field::Field;
use super::guard::{self, Estimate};
use crate::expr::{Binary, ExprId, Unary};
use crate::id::{Id, IdVec, ids};
use rustc_hash::FxHashMap as HashMap;

ids! {
    /// A class of equal values.
    ClassId,
}

/// The value at two independent random points: equality by chance is practically impossible.
pub(super) type Value = [Field; 2];

/// A class or its negative; negation is free.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Signed {
    pub class: ClassId,
    pub negative: bool,
}

impl Signed {
    #[inline]
    pub fn times(self, negative: bool) -> Self {
        Self { negative: self.negative != negative, ..self }
    }
}

/// The operation of a definition.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Operation {
    /// A symbol or a constant.
    Leaf(ExprId),
    /// a + b, operands signed.
    Sum,
    /// a b.
    Product,
    /// a / b.
    Quotient,
    /// f(a).
    Unary(Unary),
    /// One of atan2, min, max.
    Binary(Binary),
}

impl Operation {
    /// Estimated time, in additions.
    #[inline]
    pub fn weight(self) -> u32 {
        match self {
            Self::Leaf(_) => 0,
            Self::Sum | Self::Product => 1,
            Self::Binary(Binary::Min | Binary::Max) | Self::Unary(Unary::Abs | Unary::Sign) => 1,
            Self::Quotient | Self::Unary(Unary::Sqrt) => 12,
            Self::Unary(_) | Self::Binary(_) => 20,
        }
    }
}

/// One way to compute a class.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Definition {
    pub operation: Operation,
    /// Is the class the negative of the operation's result?
    pub negative: bool,
    /// The operands. For one operand the second repeats the first; for a leaf both are the class itself.
    pub operands: [Signed; 2],
    /// Its round-off bound relative to that of the class; 1 if it is no larger.
    pub error: f64,
    /// Depends on parameters alone, so that it is computed only when they change.
    pub prepared: bool,
}

/// Weight of an operation of every evaluation relative to one that is done only when parameters change.
const EVERY_EVALUATION: u32 = 32;

impl Definition {
    /// Defines the class (or its negative, if `negative`) as a (operation) b.
    #[inline]
    pub fn new(operation: Operation, a: Signed, b: Signed, negative: bool) -> Self {
        let commutes = matches!(operation, Operation::Sum | Operation::Product);
        let (a, b) = if commutes && b.class < a.class { (b, a) } else { (a, b) };
        match operation {
            // Canonical signs: a sum has them all in its terms, a product or quotient has none in its factors.
            Operation::Sum => Self {
                operation,
                negative: false,
                operands: [a.times(negative), b.times(negative)],
                error: 1.0,
                prepared: false,
            },
            Operation::Product | Operation::Quotient => Self {
                operation,
                negative: negative ^ a.negative ^ b.negative,
                operands: [a, b].map(|o| Signed { negative: false, ..o }),
                error: 1.0,
                prepared: false,
            },
            _ => Self { operation, negative, operands: [a, b], error: 1.0, prepared: false },
        }
    }

    /// Value and round-off bound at a state from those of its operands.
    #[inline(always)]
    fn estimate(&self, a: &Estimate, b: &Estimate) -> Estimate {
        let (x, y) = (self.operands[0].negative, self.operands[1].negative);
        let value = match self.operation {
            Operation::Leaf(_) => a.signed(x),
            Operation::Sum => Estimate::sum(a.signed(x), b.signed(y)),
            Operation::Product => Estimate::product(a.signed(x), b.signed(y)),
            Operation::Quotient => Estimate::quotient(a.signed(x), b.signed(y)),
            Operation::Unary(f) => Estimate::unary(f, a.signed(x)),
            Operation::Binary(f) => Estimate::binary(f, a.signed(x), b.signed(y)),
        };
        value.signed(self.negative)
    }

    /// Its contribution to the cost that the search minimises.
    #[inline]
    pub fn cost(&self) -> u32 {
        self.operation.weight() * if self.prepared { 1 } else { EVERY_EVALUATION }
    }

    /// The classes that it depends on.
    #[inline]
    pub fn reads(&self) -> impl Iterator<Item = ClassId> + use<> {
        let n = match self.operation {
            Operation::Leaf(_) => 0,
            Operation::Unary(_) => 1,
            _ => 2,
        };
        let [a, b] = self.operands;
        (0..n).map(move |k| if k == 0 { a.class } else { b.class })
    }

    #[inline]
    fn same_but_for_signs(&self, other: &Self) -> bool {
        self.operation == other.operation && self.operands.map(|o| o.class) == other.operands.map(|o| o.class)
    }
}

/// A class of equal values.
#[derive(Clone, Debug)]
pub(super) struct Class {
    pub value: Value,
    /// The first definition, and others found later; most classes have only one.
    first: Definition,
    others: Vec<Definition>,
    /// The definition in use.
    pub current: Definition,
    /// Does the class depend on parameters alone, by its first definition?
    pub prepared: bool,
}

impl Class {
    /// All known definitions, the first one first.
    #[inline]
    pub fn definitions(&self) -> impl Iterator<Item = &Definition> {
        std::iter::once(&self.first).chain(&self.others)
    }

    /// The k-th definition, if it exists.
    #[inline]
    pub fn definition(&self, k: usize) -> Option<Definition> {
        if k == 0 { Some(self.first) } else { self.others.get(k - 1).copied() }
    }

    #[inline]
    pub fn is_leaf(&self) -> bool {
        matches!(self.current.operation, Operation::Leaf(_))
    }
}

/// Classes by value.
#[derive(Debug)]
pub(super) struct Graph {
    pub classes: IdVec<ClassId, Class>,
    index: HashMap<u64, ClassId>,
    points: usize,
    /// Estimates at the guard's states: `points` entries per class.
    estimates: Vec<Estimate>,
}

impl Graph {
    #[inline]
    pub fn new(points: usize) -> Self {
        Self { classes: IdVec::default(), index: HashMap::default(), points, estimates: Vec::new() }
    }

    /// Reserves memory for this number of additional classes.
    pub fn reserve(&mut self, classes: usize) {
        self.classes.reserve(classes);
        self.index.reserve(classes);
        self.estimates.reserve(classes * self.points);
    }

    #[inline]
    pub fn value(&self, x: Signed) -> Value {
        let value = self.classes[x.class].value;
        if x.negative { value.map(|v| -v) } else { value }
    }

    /// Values and round-off bounds of a class at the guard's states.
    #[inline]
    pub fn estimates(&self, class: ClassId) -> &[Estimate] {
        let start = class.index() * self.points;
        &self.estimates[start..start + self.points]
    }

    #[inline]
    pub fn signed_estimates(&self, x: Signed) -> impl Iterator<Item = Estimate> {
        self.estimates(x.class).iter().map(move |e| e.signed(x.negative))
    }

    /// The class with this value, if there is one.
    #[inline]
    pub fn find(&self, value: Value) -> Option<Signed> {
        let negative = value[0].is_upper();
        let canonical = if negative { value.map(|v| -v) } else { value };
        let &class = self.index.get(&canonical[0].bits())?;
        (self.classes[class].value == canonical).then_some(Signed { class, negative })
    }

    /// The class with this value at the first point of the field; the second is not compared.
    #[inline]
    pub fn find_at_first_point(&self, value: Field) -> Option<Signed> {
        let &class = self.index.get(&value.canonical().bits())?;
        Some(Signed { class, negative: value.is_upper() })
    }

    /// Adds a class for a (operation) b with the given value; the class may stand for the negative.
    pub fn add(&mut self, value: Value, operation: Operation, a: Signed, b: Signed) -> Signed {
        let negative = value[0].is_upper();
        let current = self.prepared(Definition::new(operation, a, b, negative));
        let known = self.estimates.len();
        self.estimates.resize(known + self.points, Estimate::exact(0.0));
        let (known, new) = self.estimates.split_at_mut(known);
        new.iter_mut().zip(estimates_of(known, self.points, current)).for_each(|(new, of)| *new = of);
        self.push(value, current)
    }

    /// Adds a class with its first definition; its estimates have been stored already.
    fn push(&mut self, value: Value, current: Definition) -> Signed {
        let negative = value[0].is_upper();
        let value = if negative { value.map(|v| -v) } else { value };
        let class = self.classes.push(Class {
            value,
            first: current,
            others: Vec::new(),
            current,
            prepared: current.prepared,
        });
        self.index.insert(value[0].bits(), class);
        Signed { class, negative }
    }

    /// The class of a symbol or constant.
    pub fn leaf(&mut self, value: Value, expr: ExprId, prepared: bool, estimates: &[Estimate]) -> Signed {
        if let Some(known) = self.find(value) {
            return known;
        }
        let own = Signed { class: ClassId::from_index(self.classes.len()), negative: false };
        let negative = value[0].is_upper();
        self.estimates.extend(estimates.iter().map(|e| e.signed(negative)));
        let leaf = self.push(value, Definition::new(Operation::Leaf(expr), own, own, negative));
        self.classes[leaf.class].prepared = prepared;
        leaf
    }

    /// The definition with `prepared` set.
    #[inline]
    fn prepared(&self, definition: Definition) -> Definition {
        // A leaf depends on no class; whether it is a parameter is set by the caller.
        let prepared = definition.reads().all(|c| self.classes[c].prepared);
        Definition { prepared, ..definition }
    }

    /// The result of an operation in the field; `None` for a division by zero or an operation other than + * /.
    #[inline]
    pub fn apply(&self, operation: Operation, a: Signed, b: Signed) -> Option<Value> {
        let (x, y) = (self.value(a), self.value(b));
        Some(match operation {
            Operation::Sum => [x[0] + y[0], x[1] + y[1]],
            Operation::Product => [x[0] * y[0], x[1] * y[1]],
            Operation::Quotient => [x[0] * y[0].inverse()?, x[1] * y[1].inverse()?],
            _ => return None,
        })
    }

    /// Values and round-off bounds of a definition at the guard's states.
    #[inline]
    pub fn estimates_of(&self, definition: &Definition) -> impl Iterator<Item = Estimate> {
        estimates_of(&self.estimates, self.points, *definition)
    }

    /// Adds a definition to `target`, which must have the same value; true if it is new and the guard admits it.
    pub fn propose(&mut self, target: Signed, operation: Operation, a: Signed, b: Signed) -> bool {
        self.propose_within(target, operation, [a, b], f64::INFINITY)
    }

    /// [`Self::propose`], but only if the round-off bound is at most `most` times that of the class.
    pub fn propose_within(
        &mut self,
        target: Signed,
        operation: Operation,
        [a, b]: [Signed; 2],
        most: f64,
    ) -> bool {
        let definition = self.prepared(Definition::new(operation, a, b, target.negative));
        let class = &self.classes[target.class];
        if class.is_leaf()
            || definition.reads().any(|c| c == target.class)
            || class.definitions().any(|d| d.same_but_for_signs(&definition))
        {
            return false;
        }
        let old = self.estimates(target.class).iter().copied();
        let Some(error) = guard::admits(old, self.estimates_of(&definition)).filter(|error| *error <= most)
        else {
            return false;
        };
        self.classes[target.class].others.push(Definition { error, ..definition });
        true
    }

    /// Replaces all definitions of `target` by this one, which must have the same value; false if the definition
    /// depends on the class.
    pub fn adopt(&mut self, target: Signed, operation: Operation, a: Signed, b: Signed) -> bool {
        let definition = self.prepared(Definition::new(operation, a, b, target.negative));
        if self.classes[target.class].is_leaf() || self.reads(&definition, target.class) {
            return false;
        }
        let class = &mut self.classes[target.class];
        (class.first, class.current) = (definition, definition);
        class.others.clear();
        true
    }

    /// Does `definition` depend on `class`, through the current definitions?
    #[inline]
    fn reads(&self, definition: &Definition, class: ClassId) -> bool {
        let mut seen = vec![false; self.classes.len()];
        let mut stack: Vec<ClassId> = definition.reads().collect();
        while let Some(next) = stack.pop() {
            if next == class {
                return true;
            }
            if !std::mem::replace(&mut seen[next.index()], true) {
                stack.extend(self.classes[next].current.reads());
            }
        }
        false
    }

    /// The class of a (operation) b, added if necessary; `None` if the value is zero or undefined.
    pub fn class_of(&mut self, operation: Operation, a: Signed, b: Signed) -> Option<Signed> {
        let value = self.apply(operation, a, b)?;
        if value[0] == Field::ZERO {
            return None;
        }
        if let Some(known) = self.find(value) {
            self.propose(known, operation, a, b);
            return Some(known);
        }
        Some(self.add(value, operation, a, b))
    }

    /// Takes over bounds of another definition of the same value where they are smaller.
    pub fn sharpen(&mut self, class: ClassId, other: &[Estimate]) {
        let start = class.index() * self.points;
        for (mine, other) in self.estimates[start..start + self.points].iter_mut().zip(other) {
            if other.error < mine.error {
                mine.error = other.error;
            }
        }
    }
}

/// Values and round-off bounds of a definition at each state, from those of all classes.
#[inline]
fn estimates_of(known: &[Estimate], points: usize, definition: Definition) -> impl Iterator<Item = Estimate> {
    let [x, y] = definition.operands;
    let of = |x: Signed| &known[x.class.index() * points..][..points];
    of(x).iter().zip(of(y)).map(move |(a, b)| definition.estimate(a, b))
}
