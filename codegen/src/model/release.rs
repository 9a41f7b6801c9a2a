//! Releases components of a joint, so that the force they transmit appears in an equation of motion.
//!
//! In: a model, a cut, the components to release. Out: the model with one coordinate more per component, by which the
//! outer side of the cut could move against the inner side; the coordinate stays 0. The generalised force that its
//! speed would need to stay 0 is that component of the joint's reaction: Kane's auxiliary speeds (Kane and Levinson
//! 1985, section 4.9). All later stages derive it like any other model.

use super::data::*;
use super::expression::{Axis, Expr, ExprKind};
use super::ids::*;
use super::unit::Unit;
use crate::diagnostic::Diagnostic;
use crate::id::{Id, IdVec};
use crate::source::Span;

/// Components of a wrench: three of the force, three of the moment.
pub const COMPONENTS: usize = 6;
const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];
const ORIGIN: usize = 0;

/// Where a mechanism is cut. Everything reached from `point`, or that turns with `frame`, is the outer side.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Cut {
    /// The point where the force acts and about which moments are taken.
    pub point: PointId,
    /// The frame that turns with the outer side; `None` if no moment is asked for.
    pub frame: Option<FrameId>,
}

/// How an expression depends on the two sides of the cut.
#[derive(Clone, Copy, Default)]
struct Reads {
    /// It contains an axis that turns with the outer side.
    turning: bool,
    /// It contains the point of the cut.
    cut: bool,
    /// It contains any point.
    point: bool,
    /// It contains a point of the outer side.
    outer: bool,
    /// It contains a point whose position depends on the attitude of the outer side.
    swept: bool,
}

/// The two sides of a cut.
struct Sides<'m> {
    model: &'m Model,
    cut: Cut,
    definitions: IdVec<DefinitionId, Reads>,
    /// By frame: does it turn with the outer side?
    turning: IdVec<FrameId, bool>,
    /// By point: is it on the outer side?
    outer: IdVec<PointId, bool>,
    swept: IdVec<PointId, bool>,
    /// Expressions of points that lead from the cut to the outer side: the point, and the number of the expression
    /// among those that its declaration gives.
    starts: Vec<(PointId, usize)>,
    /// Bodies of the outer side whose mass centre is a point that both sides share.
    sharing: Vec<BodyId>,
    /// The first point that turns with the outer side but is not reached from the cut.
    stray: Option<PointId>,
}

impl Model {
    /// The model with these components of the joint released: 0 to 2 are displacements, 3 to 5 rotations, along the
    /// axes of the frame of the cut or, without a frame, along those of N.
    ///
    /// # Errors
    /// If the cut does not separate the model into two sides.
    pub(crate) fn released(&self, cut: Cut, components: &[usize]) -> Result<Self, Diagnostic> {
        let sides = Sides::new(self, cut)?;
        let mut model = self.clone();
        let span = self.points[cut.point].span;
        let added: Vec<CoordinateId> =
            components.iter().map(|&component| model.add_locked(component, span)).collect();
        if let Some((dof, _)) = &mut model.dof {
            *dof += components.len();
        }
        let axes_of = cut.frame.unwrap_or(FrameId::from_index(0));
        let node = |kind| Expr { kind, span, unit: Unit::NONE };
        let mut rotations = Vec::new();
        let mut displaced: Option<Expr> = None;
        for (&component, &coordinate) in components.iter().zip(&added) {
            let amount = node(ExprKind::Coordinate(coordinate));
            let axis = AXES[component % 3];
            if component >= 3 {
                rotations.push((axis, amount));
                continue;
            }
            let along = node(ExprKind::Axis(axes_of, axis));
            let term = node(ExprKind::Multiply(Box::new(amount), Box::new(along)));
            displaced = Some(match displaced {
                Some(sum) => node(ExprKind::Add(Box::new(sum), Box::new(term))),
                None => term,
            });
        }
        if let Some(frame) = cut.frame {
            sides.keep_rolling(&mut model, frame);
            model.turn_further(frame, rotations);
        }
        if let Some(displaced) = displaced {
            sides.displace(&mut model, &displaced);
        }
        Ok(model)
    }

    /// A frame like this one that stays where it stood, right before it in the order.
    fn standing(&mut self, frame: FrameId) -> FrameId {
        let own = &self.frames[frame];
        let standing =
            Frame { name: format!("{} standing", own.name), fixed_vectors: Vec::new(), ..own.clone() };
        let standing = self.frames.push(standing);
        let place = self.order.iter().position(|entity| *entity == Entity::Frame(frame)).unwrap_or(0);
        self.order.insert(place, Entity::Frame(standing));
        standing
    }

    /// Turns a frame further from where it stood.
    fn turn_further(&mut self, frame: FrameId, further: Vec<(Axis, Expr)>) {
        if let Orientation::Rotations { rotations, .. } = &mut self.frames[frame].orientation {
            rotations.extend(further);
        } else if !further.is_empty() {
            let parent = self.standing(frame);
            self.frames[frame].orientation = Orientation::Rotations { parent, rotations: further };
        }
    }

    /// An independent coordinate that never leaves 0, and its speed. No name of a model has a space.
    fn add_locked(&mut self, component: usize, span: Span) -> CoordinateId {
        let unit = if component < 3 { "m" } else { "rad" };
        let name = format!("released {component}");
        let coordinate = self.coordinates.push(Coordinate {
            name: name.clone(),
            doc: String::new(),
            unit: unit.to_owned(),
            written_unit: (unit.to_owned(), 1.0),
            independent: true,
            nominal: 0.0,
            range: (0.0, 0.0),
            written: [None, None, None],
            closed_form: None,
            span,
        });
        self.speeds.push(Speed {
            name: format!("rate of {name}"),
            unit: format!("{unit}/s"),
            meaning: SpeedMeaning::RateOf(coordinate),
            independent: true,
            span,
        });
        coordinate
    }
}

impl<'m> Sides<'m> {
    fn new(model: &'m Model, cut: Cut) -> Result<Self, Diagnostic> {
        let point = &model.points[cut.point];
        if !point.closures.is_empty() || point.velocity.is_some() {
            let why = if point.velocity.is_some() {
                "its velocity is stated"
            } else {
                "its position is given by several legs"
            };
            return Err(Diagnostic::error(format!("no reaction can be computed at `{}`", point.name))
                .label(point.span, why)
                .help("name a point that is the end of one leg only"));
        }
        if let Some(frame) = cut.frame.map(|frame| &model.frames[frame])
            && frame.orientation.parent().is_none()
        {
            return Err(Diagnostic::error(format!("`{}` is not the outer side of a joint", frame.name))
                .label(frame.span, "it is not given by rotations from another frame")
                .help(
                    "name a frame with `rotations` or `euler`; for a frame given by directions, ask for the \
                       reactions at the points that carry it",
                ));
        }
        let mut sides = Self {
            model,
            cut,
            definitions: model.definitions.iter().map(|_| Reads::default()).collect(),
            turning: model.frames.ids().map(|frame| Some(frame) == cut.frame).collect(),
            outer: model.points.ids().map(|p| cut.frame.is_none() && p == cut.point).collect(),
            swept: model.points.iter().map(|_| false).collect(),
            starts: Vec::new(),
            sharing: Vec::new(),
            stray: None,
        };
        for entity in &model.order {
            match *entity {
                Entity::Definition(id) => sides.definitions[id] = sides.reads(&model.definitions[id].value),
                Entity::Frame(id) => sides.frame(id),
                Entity::Point(id) => sides.point(id),
                Entity::Parameter(_) | Entity::Coordinate(_) => {}
            }
        }
        if sides.swept[cut.point] {
            return Err(Diagnostic::error(format!("`{}` moves with `{}`", point.name, sides.frame_name()))
                .label(point.span, "the joint's point must stand still while the frame turns about it")
                .help("name the point about which the frame turns relative to its parent"));
        }
        if let Some(stray) = sides.stray.map(|stray| &model.points[stray]) {
            return Err(sides.elsewhere(&format!("the point `{}`", stray.name), stray.span));
        }
        sides.bodies()?;
        sides.constraints()?;
        Ok(sides)
    }

    fn reads(&self, expr: &Expr) -> Reads {
        let mut found = Reads::default();
        expr.visit(&mut |e| match e.kind {
            ExprKind::Axis(frame, _) | ExprKind::AngularVelocity(frame) => {
                found.turning |= self.turning[frame];
            }
            ExprKind::Point(p) | ExprKind::Velocity(p) => {
                found.point = true;
                found.cut |= p == self.cut.point;
                found.outer |= self.outer[p];
                found.swept |= self.swept[p];
            }
            ExprKind::Definition(d) => {
                let within = self.definitions[d];
                found.turning |= within.turning;
                found.cut |= within.cut;
                found.point |= within.point;
                found.outer |= within.outer;
                found.swept |= within.swept;
            }
            _ => {}
        });
        found
    }

    fn frame(&mut self, id: FrameId) {
        let orientation = &self.model.frames[id].orientation;
        self.turning[id] |= orientation.parent().is_some_and(|parent| self.turning[parent])
            || orientation.expressions().into_iter().any(|(_, part)| self.reads(part).turning);
    }

    fn point(&mut self, id: PointId) {
        let declared = &self.model.points[id];
        for (place, way) in ways(declared).enumerate() {
            let reads = self.reads(way);
            self.swept[id] |= reads.turning || reads.swept;
            if self.cut.frame.is_some() && reads.turning {
                if self.begins_at_cut(reads) {
                    self.starts.push((id, place));
                    self.outer[id] = true;
                } else if !reads.outer {
                    self.stray = self.stray.or(Some(id));
                }
            }
            self.outer[id] |= reads.outer;
        }
        let velocity = declared.velocity.as_ref().map(|velocity| self.reads(velocity));
        self.swept[id] |= velocity.is_some_and(|reads| reads.turning || reads.swept);
    }

    /// Collects the bodies that turn with the outer side although their mass centre is the joint's own point.
    fn bodies(&mut self) -> Result<(), Diagnostic> {
        for (id, body) in self.model.bodies.enumerate() {
            let turns = body.frame.is_some_and(|frame| self.turning[frame]);
            if !turns || self.outer[body.centre] {
                continue;
            }
            let centre = &self.model.points[body.centre];
            if body.centre != self.cut.point && !self.begins_at_cut(self.reads(&centre.position)) {
                return Err(self.elsewhere(&format!("the body `{}`", body.name), body.span));
            }
            self.sharing.push(id);
        }
        Ok(())
    }

    /// A length or velocity along what turns with the outer side must say from which point on.
    fn constraints(&self) -> Result<(), Diagnostic> {
        for constraint in self.model.configuration_constraints.iter().chain(&self.model.motion_constraints) {
            let reads = self.reads(&constraint.expression);
            let is_place = [Unit::LENGTH, Unit::VELOCITY].contains(&constraint.unit);
            if self.cut.frame.is_some() && is_place && reads.turning && !reads.cut && !reads.outer {
                return Err(self.elsewhere(&format!("the constraint `{}`", constraint.name), constraint.span));
            }
        }
        Ok(())
    }

    /// Was it made by the joint that is cut? Then the joint transmits what it holds.
    fn is_of_joint(&self, span: Span) -> bool {
        let of_frame = self.cut.frame.map(|frame| self.model.frames[frame].span);
        span == self.model.points[self.cut.point].span && of_frame == Some(span)
    }

    /// What the cut joint itself makes roll goes on as if the joint were not open.
    fn keep_rolling(&self, model: &mut Model, frame: FrameId) {
        let rolls = |e: &Expr| {
            let mut found = false;
            e.visit(&mut |e| found |= matches!(e.kind, ExprKind::AngularVelocity(f) if f == frame));
            found
        };
        let own = |c: &Constraint| self.is_of_joint(c.span) && rolls(&c.expression);
        if !model.motion_constraints.iter().any(own) {
            return;
        }
        let standing = model.standing(frame);
        for constraint in model.motion_constraints.iter_mut().filter(|c| own(c)) {
            constraint.expression = constraint.expression.replaced(&|e| match e.kind {
                ExprKind::AngularVelocity(f) if f == frame => {
                    Some(Expr { kind: ExprKind::AngularVelocity(standing), ..e.clone() })
                }
                _ => None,
            });
        }
    }

    /// Other constraints that say how the outer side turns hold it by its own copy of the joint's point, and so does the
    /// drive of a joint that slides.
    fn attach(&self, model: &mut Model, beyond: PointId) {
        for constraint in model.configuration_constraints.iter_mut().chain(&mut model.motion_constraints) {
            if self.is_of_joint(constraint.span) {
                continue;
            }
            let reads = self.reads(&constraint.expression);
            if reads.turning && reads.cut {
                constraint.expression = self.beyond(&constraint.expression, beyond);
            }
        }
        for load in &mut model.loads {
            if let LoadKind::Force { point, .. } = &mut load.kind
                && *point == self.cut.point
                && self.is_of_joint(load.span)
            {
                *point = beyond;
            }
        }
    }

    /// The expression with another point for that of the cut; definitions that read it are written out.
    fn beyond(&self, expr: &Expr, point: PointId) -> Expr {
        expr.replaced(&|e| {
            let kind = match e.kind {
                ExprKind::Point(p) if p == self.cut.point => ExprKind::Point(point),
                ExprKind::Velocity(p) if p == self.cut.point => ExprKind::Velocity(point),
                ExprKind::Definition(d) if self.definitions[d].cut => {
                    return Some(self.beyond(&self.model.definitions[d].value, point));
                }
                _ => return None,
            };
            Some(Expr { kind, ..e.clone() })
        })
    }

    /// At the point of the cut, or at O where no point is named.
    fn begins_at_cut(&self, reads: Reads) -> bool {
        reads.cut || (self.cut.point.index() == ORIGIN && !reads.point)
    }

    /// Adds the displacement `by` to everything on the outer side.
    fn displace(&self, model: &mut Model, by: &Expr) {
        if self.cut.frame.is_none() {
            let position = &mut model.points[self.cut.point].position;
            *position = sum(position.clone(), by.clone());
        }
        for &(point, place) in &self.starts {
            let own = &mut model.points[point];
            let way = if place == 0 { &mut own.position } else { &mut own.closures[place - 1] };
            *way = sum(way.clone(), by.clone());
        }
        for &body in &self.sharing {
            let centre = self.model.bodies[body].centre;
            let name = format!("{} of {}", self.model.points[centre].name, self.model.bodies[body].name);
            model.bodies[body].centre = self.copy(model, centre, name, by);
        }
        if self.cut.frame.is_some() {
            let name = format!("{} beyond", self.model.points[self.cut.point].name);
            let beyond = self.copy(model, self.cut.point, name, by);
            self.attach(model, beyond);
        }
    }

    /// A displaced copy of a point.
    fn copy(&self, model: &mut Model, point: PointId, name: String, by: &Expr) -> PointId {
        let span = self.model.points[point].span;
        let at = Expr { kind: ExprKind::Point(point), span, unit: Unit::NONE };
        let position = sum(at, by.clone());
        let copy = model.points.push(Point { name, position, closures: Vec::new(), velocity: None, span });
        model.order.push(Entity::Point(copy));
        copy
    }

    fn frame_name(&self) -> &str {
        self.cut.frame.map_or("", |frame| &self.model.frames[frame].name)
    }

    fn elsewhere(&self, what: &str, span: Span) -> Diagnostic {
        let (frame, point) = (self.frame_name(), &self.model.points[self.cut.point].name);
        Diagnostic::error(format!(
            "{what} turns with `{frame}`, but its position does not start from `{point}`"
        ))
        .label(span, format!("reached without `{point}`"))
        .help(format!(
            "name the point from which the positions of everything that turns with `{frame}` start, or write \
                 this position relative to `{point}`, by that name"
        ))
    }
}

/// All expressions for a point that its declaration gives: its position, and its closures.
fn ways(point: &Point) -> impl Iterator<Item = &Expr> {
    std::iter::once(&point.position).chain(&point.closures)
}

fn sum(a: Expr, b: Expr) -> Expr {
    let span = a.span;
    Expr { kind: ExprKind::Add(Box::new(a), Box::new(b)), span, unit: Unit::NONE }
}
