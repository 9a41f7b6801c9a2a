//! What generated code says of a value: its name, where the model declares it, and its section of the equations.
//!
//! A name stays only while it is true of every use: a value with two different names, given by the derivation or merged
//! by the value graph, has none. A labelled value is kept as a value of its own: no sum is taken apart at it.

use crate::section::Section;

/// Section, name and place of a value.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Label {
    /// The section of the equations.
    pub section: Section,
    name: Name,
    /// File and line of its declaration.
    pub place: Option<String>,
}

#[derive(Clone, PartialEq, Eq, Debug)]
enum Name {
    Unnamed,
    One(String),
    Several,
}

impl Label {
    /// A label without a name.
    #[must_use]
    pub fn of(section: Section) -> Self {
        Self { section, name: Name::Unnamed, place: None }
    }

    /// A label with this name.
    #[must_use]
    pub fn named(section: Section, name: impl Into<String>) -> Self {
        Self { section, name: Name::One(name.into()), place: None }
    }

    /// The label with the place of its declaration, as file and line.
    #[must_use]
    pub fn at(self, place: String) -> Self {
        Self { place: Some(place), ..self }
    }

    /// The name, if exactly one was given.
    #[must_use]
    pub fn name(&self) -> Option<&str> {
        match &self.name {
            Name::One(name) => Some(name),
            Name::Unnamed | Name::Several => None,
        }
    }

    /// Merges the label of an equal value: the earlier section; the name only if both agree or only one has a name.
    pub fn join(&mut self, other: &Self) {
        self.section = self.section.min(other.section);
        match (&self.name, &other.name) {
            (_, Name::Unnamed) => {}
            (Name::Unnamed, _) => (self.name, self.place) = (other.name.clone(), other.place.clone()),
            (one, another) if one == another => {}
            _ => (self.name, self.place) = (Name::Several, None),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::Dag;

    #[test]
    fn of_two_names_neither_stays() {
        let mut dag = Dag::default();
        let (x, y) = (dag.symbol("x"), dag.symbol("y"));
        let sum = dag.add(x, y);
        dag.label(sum, Label::named(Section::Forces, "a").at("m.toml:3".to_owned()));
        dag.label(sum, Label::of(Section::Constraints));
        dag.label(sum, Label::named(Section::Forces, "a"));
        let label = dag.label_of(sum).expect("a label");
        assert_eq!((label.name(), label.section), (Some("a"), Section::Constraints));
        assert_eq!(label.place.as_deref(), Some("m.toml:3"));
        for name in ["b", "a"] {
            dag.label(sum, Label::named(Section::Forces, name));
            assert_eq!(dag.name_of(sum), None);
        }
        dag.label(x, Label::named(Section::Forces, "c"));
        assert_eq!(dag.label_of(x), None, "symbols have their own names");
    }
}
