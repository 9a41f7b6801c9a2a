//! Writes the entries that one joint stands for, in sections that the language already has.
//!
//! In: a joint's names and axes. Out: coordinates, speeds, frames, points, constraints and loads in [`Sections`], each
//! with the place of its joint. Coordinates come last, because their speeds depend on whether the joint rolls.

use super::axis::{Along, Direction, Motion};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::text::document::{Key, Table, Text, Value};
use crate::model::text::extend;
use crate::model::text::fields::Fields;
use crate::model::text::repeat::Sections;
use crate::source::Span;

/// Fields that a coordinate takes over from its joint unchanged.
const CARRIED: [&str; 4] = ["unit", "nominal", "range", "speed"];

/// Sections of which an extension overrides entries that joints stand for.
const OVERRIDDEN: [&str; 2] = ["coordinates", "speeds"];

/// A coordinate that translates or rotates along one axis.
struct Coordinate {
    name: String,
    direction: Direction,
    slides: bool,
}

/// A joint while its entries are being written.
pub struct Parts<'a> {
    /// The frame along whose axes the translations go and from which the rotations start.
    pub base: String,
    /// The link that the joint carries: a frame and a point.
    pub child: String,
    /// Point of the inner side at which the joint sits.
    hold: String,
    /// Point at the end of the translations.
    foot: String,
    coordinates: Vec<Coordinate>,
    attitude: bool,
    /// Speeds that are combinations of rates: name, unit, whether independent, value.
    combinations: Vec<(String, &'static str, bool, String)>,
    dependent: Vec<String>,
    independent: bool,
    key: &'a Key,
    fields: &'a Fields<'a>,
    sections: &'a mut Sections,
    found: &'a mut Diagnostics,
}

/// Generated text, with the place of its origin.
fn text(text: &str, span: Span) -> Value {
    Value::Text(Text::made(text, span))
}

/// A length, an angle or another plain value as text of an expression.
fn written(value: &Value, unit: &str) -> String {
    match value {
        Value::Number(number, _) => format!("{number:?}{unit}"),
        Value::Text(text) if text.text.trim().parse::<f64>().is_ok() => format!("{}{unit}", text.text.trim()),
        Value::Text(text) => text.text.clone(),
        _ => "0".to_owned(),
    }
}

impl<'a> Parts<'a> {
    /// A joint with the name `key` and these fields, between the frame `base` and the link `child`.
    pub fn new(
        (key, fields): (&'a Key, &'a Fields<'a>),
        (base, child): (String, String),
        independent: bool,
        (sections, found): (&'a mut Sections, &'a mut Diagnostics),
    ) -> Self {
        Self {
            base,
            child,
            hold: format!("{}_base", key.name),
            foot: String::new(),
            coordinates: Vec::new(),
            attitude: false,
            combinations: Vec::new(),
            dependent: Vec::new(),
            independent,
            key,
            fields,
            sections,
            found,
        }
    }

    /// The name of something that belongs to the joint: the joint's name and a word.
    pub fn named(&self, word: &str) -> String {
        format!("{}_{word}", self.key.name)
    }

    fn put(&mut self, section: &str, name: &str, value: Value) {
        let key = Key { name: name.to_owned(), span: self.key.span };
        let entry = self.overridden(section, (key, value));
        self.sections.tables.entry(section.to_owned()).or_default().push(entry);
    }

    /// The entry with the fields that a model which extends the joint's gives to that coordinate or speed, such as a
    /// closed form. Files are numbered from the outermost extension inwards.
    fn overridden(&mut self, section: &str, (key, value): (Key, Value)) -> (Key, Value) {
        let entries = self.sections.tables.get_mut(section).filter(|_| OVERRIDDEN.contains(&section));
        let given = entries.and_then(|entries| {
            let extends = |(given, value): &(Key, Value)| {
                given.name == key.name && given.span.file < key.span.file && matches!(value, Value::Table(_))
            };
            entries.iter().position(extends).map(|at| entries.remove(at))
        });
        match given {
            Some(given) => extend::overridden(value, given),
            None => (key, value),
        }
    }

    fn table(&self, fields: Vec<(&str, Value)>) -> Value {
        let key = |name: &str| Key { name: name.to_owned(), span: self.key.span };
        let entries = fields.into_iter().map(|(name, value)| (key(name), value)).collect();
        Value::Table(Table { entries, span: self.key.span })
    }

    fn text(&self, written: &str) -> Value {
        text(written, self.key.span)
    }

    /// Adds a point at the vector `position` from O.
    pub fn point(&mut self, name: &str, position: &str) {
        let position = self.text(position);
        self.put("points", name, position);
    }

    /// Adds the motions of the joint, along or about `axes`.
    pub fn moves(&mut self, motions: &[Motion], axes: &[Direction]) {
        let single = motions.len() == 1;
        for motion in motions {
            let (along, word, slides) = match *motion {
                Motion::Slide(along, word) => (along, word, true),
                Motion::Turn(along, word) => (along, Some(word), false),
                Motion::Attitude => {
                    self.attitude = true;
                    continue;
                }
            };
            let direction = match along {
                Along::Given(n) => axes[n].clone(),
                Along::Letter(letter) => Direction::letter(letter),
                Along::Across(n) => axes[0].across(n),
            };
            let name = match word {
                _ if single => self.key.name.clone(),
                Some(word) => self.named(word),
                None => self.named(&direction.name()),
            };
            self.coordinates.push(Coordinate { name, direction, slides });
        }
    }

    /// Sets where the joint sits: at the link's point, unless translations lead away from there.
    pub fn sits(&mut self, at: Value) {
        let slides = self.coordinates.iter().any(|c| c.slides);
        let name = if slides { self.hold.clone() } else { self.child.clone() };
        self.put("points", &name, at);
    }

    /// Adds a point at the end of the translations.
    pub fn place(&mut self, name: &str) {
        let slides = self.coordinates.iter().filter(|c| c.slides);
        let shifts = slides.map(|c| format!(" + {}*{}", c.name, c.direction.of(&self.base)));
        let position = format!("{}{}", self.hold, shifts.collect::<String>());
        self.point(name, &position);
        self.foot = name.to_owned();
    }

    /// Adds a frame that is turned from another one.
    pub fn frame(&mut self, name: &str, parent: &str, rotations: Vec<Value>) {
        let rotations = Value::Array(rotations, self.key.span);
        let frame = self.table(vec![("parent", self.text(parent)), ("rotations", rotations)]);
        self.put("frames", name, frame);
    }

    /// The rotations by the joint's coordinates, about their axes in order.
    fn turns(&self) -> Vec<Value> {
        let turns = self.coordinates.iter().filter(|c| !c.slides);
        turns.flat_map(|c| c.direction.turn(&c.name, self.key.span)).collect()
    }

    /// Adds the frames of the link: `between` after the first `inner` rotations, and the link itself after the others.
    pub fn split_frame(&mut self, between: &str, inner: usize) {
        let mut turns = self.turns();
        let outer = turns.split_off(inner);
        let (base, child) = (self.base.clone(), self.child.clone());
        self.frame(between, &base, turns);
        self.frame(&child, between, outer);
    }

    /// Adds the frame of the link, turned from the base by the rotations `fixed` and then by the joint's own.
    pub fn link(&mut self, fixed: &[Value]) {
        let (base, child) = (self.base.clone(), self.child.clone());
        match self.attitude {
            true => self.attitude_frame(&child),
            false => self.frame(&child, &base, [fixed, &self.turns()].concat()),
        }
    }

    /// Adds a frame by Euler parameters e0 = cos(angle/2), e = axis sin(angle/2), of unit length. Speeds: the angular
    /// velocity w = 2 (e0 e' - e0' e - e x e') along the link's axes, and the rate of the constraint, which stays 0.
    /// Regular at every attitude.
    fn attitude_frame(&mut self, child: &str) {
        let [a, b, c, d] = ["e0", "e1", "e2", "e3"].map(|word| self.named(word));
        let parameters = [&a, &b, &c, &d].map(|e| self.text(e)).to_vec();
        let base = self.text(&self.base.clone());
        let frame = self.table(vec![("parent", base), ("euler", Value::Array(parameters, self.key.span))]);
        self.put("frames", child, frame);
        let rate = |e: &str, sign: &str, of: &str| format!(" {sign} {e}*q_dot({of})");
        let speed = |terms: [(&str, &str, &str); 4]| {
            let sum: String = terms.into_iter().map(|(sign, e, of)| rate(e, sign, of)).collect();
            format!("2*({})", sum.trim_start_matches([' ', '+']))
        };
        let (a, b, c, d) = (a.as_str(), b.as_str(), c.as_str(), d.as_str());
        let wx = speed([("+", a, b), ("-", b, a), ("+", d, c), ("-", c, d)]);
        let wy = speed([("+", a, c), ("-", c, a), ("+", b, d), ("-", d, b)]);
        let wz = speed([("+", a, d), ("-", d, a), ("+", c, b), ("-", b, c)]);
        let w0 = speed([("+", a, a), ("+", b, b), ("+", c, c), ("+", d, d)]);
        for (word, value, independent) in
            [("wx", wx, true), ("wy", wy, true), ("wz", wz, true), ("w0", w0, false)]
        {
            self.combine(word, "rad/s", independent, &value);
        }
        for (e, nominal) in [(a, Some(1.0)), (b, None), (c, None), (d, None)] {
            // All four alike: the unit constraint gives none of them where it passes through 0.
            let mut fields = vec![
                ("unit", self.text("1")),
                ("speed", Value::Boolean(false, self.key.span)),
                ("independent", Value::Boolean(self.independent, self.key.span)),
            ];
            fields.extend(nominal.map(|one| ("nominal", Value::Number(one, self.key.span))));
            let entry = self.table(fields);
            self.put("coordinates", e, entry);
        }
        let squares = [a, b, c, d].map(|e| format!("{e}.powi(2)")).join("+");
        let unit = self.text(&format!("({squares}) - 1"));
        let name = self.named("unit");
        self.put("constraints.configuration", &name, unit);
    }

    /// Adds a speed that is a combination of rates.
    pub fn combine(&mut self, word: &str, unit: &'static str, independent: bool, value: &str) {
        let name = self.named(word);
        self.combinations.push((name, unit, independent && self.independent, value.to_owned()));
    }

    /// Declares that the speeds of these coordinates follow from the motion constraints.
    pub fn depend(&mut self, words: &[&str]) {
        self.dependent.extend(words.iter().map(|word| format!("{}_{word}", self.key.name)));
    }

    /// The velocity relative to the inner side at the place of contact.
    pub fn slip(&self, velocity: &str) -> String {
        let (hold, foot, base) = (&self.hold, &self.foot, &self.base);
        format!("{velocity} - velocity({hold}) - cross(angular_velocity({base}), {foot} - {hold})")
    }

    /// Adds a motion constraint: no slip along a direction.
    pub fn constrain(&mut self, word: &str, slip: &str, along: &str) {
        let (name, expression) = (self.named(word), self.text(&format!("dot({slip}, {along})")));
        self.put("constraints.motion", &name, expression);
    }

    /// Adds the constraints for a point with this velocity that rests on the plane. Along the plane's own axes each row
    /// holds one speed of the place of contact with coefficient 1, so that no pivot can vanish. Along the normal
    /// nothing slips anyway.
    pub fn does_not_slip(&mut self, velocity: &str) {
        let (slip, base) = (self.slip(velocity), self.base.clone());
        self.constrain("roll_x", &slip, &format!("{base}.x"));
        self.constrain("roll_y", &slip, &format!("{base}.y"));
    }

    /// The length in a field of the joint.
    pub fn length(&mut self, field: &'static str, example: &str) -> String {
        let value = self.fields.need(field, example, self.found);
        value.map_or_else(|| "0".to_owned(), |value| written(value, "_m"))
    }

    /// The values of a field, one for each coordinate: a single value, or a list if there are several coordinates.
    fn each(&mut self, field: &'static str) -> Vec<Option<Value>> {
        let count = self.coordinates.len();
        match self.fields.get(field) {
            None => vec![None; count],
            Some(value) if count == 1 => vec![Some(value.clone())],
            Some(Value::Array(items, _)) if items.len() == count => items.iter().cloned().map(Some).collect(),
            Some(other) => {
                let names: Vec<&str> = self.coordinates.iter().map(|c| c.name.as_str()).collect();
                self.found.push(wrong_count(field, &self.key.name, &names, other));
                vec![None; count]
            }
        }
    }

    /// Adds the coordinates with their speeds, springs and drives.
    pub fn finish(mut self, driven: bool) {
        let carried = CARRIED.map(|field| self.each(field));
        let (stiffness, rest, damping) = (self.each("stiffness"), self.each("rest"), self.each("damping"));
        let drive = if driven { self.each("drive") } else { vec![None; self.coordinates.len()] };
        let doc = self.fields.get("doc").cloned();
        let span = self.key.span;
        for (i, Coordinate { name, direction, slides }) in
            std::mem::take(&mut self.coordinates).into_iter().enumerate()
        {
            let mut fields: Vec<(&str, Value)> =
                vec![("independent", Value::Boolean(self.independent, span))];
            fields.extend(doc.clone().map(|doc| ("doc", doc)));
            fields.extend(
                CARRIED.iter().zip(&carried).filter_map(|(&field, all)| Some((field, all[i].clone()?))),
            );
            if !fields.iter().any(|(field, _)| *field == "unit") {
                fields.push(("unit", self.text(if slides { "m" } else { "rad" })));
            }
            let combined =
                self.combinations.iter().any(|(.., value)| value.contains(&format!("q_dot({name})")));
            let dependent = self.dependent.contains(&name);
            if combined || dependent {
                let given =
                    fields.iter().position(|(field, _)| *field == "speed").map(|i| fields.remove(i).1);
                if let Some(given) = given.filter(|given| !matches!(given, Value::Boolean(false, _))) {
                    self.found.push(no_own_speed(&name, &given));
                }
                let held = self.table(vec![("independent", Value::Boolean(false, span))]);
                fields.push(("speed", if combined { Value::Boolean(false, span) } else { held }));
            }
            let entry = self.table(fields);
            self.put("coordinates", &name, entry);
            self.spring(&name, [&stiffness[i], &rest[i], &damping[i]]);
            if let Some(effort) = &drive[i] {
                // The axis of the last rotation is fixed in the link, that of an earlier one in the base.
                let last = !slides && i + 1 == drive.len();
                let along = direction.of(if last { &self.child } else { &self.base });
                self.drive(&name, effort, &along, slides);
            }
        }
        for (name, unit, independent, value) in std::mem::take(&mut self.combinations) {
            let fields = vec![
                ("unit", self.text(unit)),
                ("independent", Value::Boolean(independent, span)),
                ("value", self.text(&value)),
            ];
            let entry = self.table(fields);
            self.put("speeds", &name, entry);
        }
    }

    /// Adds a spring and a damper on a coordinate.
    fn spring(&mut self, coordinate: &str, [stiffness, rest, damping]: [&Option<Value>; 3]) {
        if stiffness.is_none() && rest.is_none() && damping.is_none() {
            return;
        }
        // A damper alone; `rest` without stiffness is refused as that of any spring.
        let none = rest.is_none().then_some(Value::Number(0.0, self.key.span));
        let mut fields = vec![("coordinate", self.text(coordinate))];
        fields.extend(stiffness.clone().or(none).map(|stiffness| ("stiffness", stiffness)));
        fields.extend(rest.clone().map(|rest| ("rest", rest)));
        fields.extend(damping.clone().map(|damping| ("damping", damping)));
        let entry = self.table(fields);
        self.put("springs", coordinate, entry);
    }

    /// Adds a force along a translation or a torque about a rotation, with its reaction on the inner side.
    fn drive(&mut self, coordinate: &str, effort: &Value, along: &str, slides: bool) {
        let unit = if slides { "_N" } else { "_J" };
        let effort = text(&format!("({})*{along}", written(effort, unit)), effort.span());
        let (section, on, what, against) = match slides {
            true => ("forces", "point", "force", self.hold.clone()),
            false => ("torques", "frame", "torque", self.base.clone()),
        };
        let child = self.text(&self.child);
        let entry = self.table(vec![(on, child), (what, effort), ("reaction", self.text(&against))]);
        self.put(section, coordinate, entry);
    }
}

/// The error for the speed of a coordinate whose speed the joint itself states.
fn no_own_speed(coordinate: &str, given: &Value) -> Diagnostic {
    Diagnostic::error(format!("the speed of `{coordinate}` cannot be stated here"))
        .label(given.span(), "its joint states it")
        .help("leave `speed` out, or give false in its place of the list; `check` lists the speeds of the joint")
}

/// The error for a list with more or fewer values than the joint has coordinates.
fn wrong_count(field: &str, joint: &str, coordinates: &[&str], given: &Value) -> Diagnostic {
    match coordinates.len() {
        0 => Diagnostic::error(format!("joint `{joint}` has no coordinate for `{field}`"))
            .label(given.span(), "no coordinate of this joint belongs to a single axis")
            .help("leave it out, or state it as a load: [springs], [forces], [torques]"),
        count => Diagnostic::error(format!(
            "`{field}` of joint `{joint}` is not one value for each of its {count} coordinates"
        ))
        .label(given.span(), "expected a list of as many")
        .help(format!("give {count} values in this order: {}", coordinates.join(", "))),
    }
}
