//! Releases components of a joint, so that the force they transmit appears in an equation of motion.
//!
//! In: a model, a cut, the components to release. Out: the model with one coordinate more per component, by which the
//! outer side of the cut could move against the inner side; the coordinate stays 0. The generalised force that its
//! speed would need to stay 0 is that component of the joint's reaction: Kane's auxiliary speeds (Kane and Levinson
//! 1985, section 4.9). All later stages derive it like any other model.

use super::data::*;
use super::expression::{Axis, Expr, ExprKind};
use super::ids::*;
use super::sides::{Cut, ORIGIN, Sides, Way};
use super::unit::Unit;
use crate::diagnostic::Diagnostic;
use crate::id::Id;
use crate::source::Span;

/// Components of a wrench: three of the force, three of the moment.
pub const COMPONENTS: usize = 6;
const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

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

impl Sides<'_> {
    /// Was it made by the joint that is cut? Then the joint transmits what it holds.
    fn is_of_joint(&self, span: Span) -> bool {
        let of_frame = self.cut.frame.map(|frame| self.model.frames[frame].span);
        span == self.model.points[self.cut.point].span && of_frame == Some(span)
    }

    /// Rolling constraints of the cut joint itself keep the angular velocity that the frame has with the joint closed.
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

    /// Adds the displacement `by` to everything on the outer side.
    fn displace(&self, model: &mut Model, by: &Expr) {
        for &(point, place) in &self.starts {
            let way = way_of(model, (point, place));
            *way = way.clone() + by.clone();
        }
        for &mixed in &self.mixing {
            let way = way_of(model, mixed);
            *way = self.all_displaced(way, by);
        }
        for &body in &self.sharing {
            let centre = self.model.bodies[body].centre;
            let name = format!("{} of {}", self.model.points[centre].name, self.model.bodies[body].name);
            model.bodies[body].centre = self.copy(model, centre, name, by);
        }
        if self.goes {
            if self.cut.frame.is_some() {
                self.detach(model);
            }
            let position = &mut model.points[self.cut.point].position;
            *position = position.clone() + by.clone();
        } else {
            let name = format!("{} beyond", self.model.points[self.cut.point].name);
            let beyond = self.copy(model, self.cut.point, name, by);
            self.attach(model, beyond);
        }
    }

    /// Displaces an expression that averages points of the outer side and the joint's own point. O cannot move: if the
    /// cut is there, all others move back by as much, and the average forward.
    fn all_displaced(&self, way: &Expr, by: &Expr) -> Expr {
        if self.cut.point.index() != ORIGIN {
            let own = |e: &Expr| e.clone() + by.clone();
            return self.with_points(way, &|p| p == self.cut.point, &own);
        }
        let back = |e: &Expr| e.clone() - by.clone();
        self.with_points(way, &|p| p.index() != ORIGIN, &back) + by.clone()
    }

    /// Constraints on the attitude of the outer side, and the drive of a sliding joint, refer to the displaced copy of
    /// the joint's point.
    fn attach(&self, model: &mut Model, beyond: PointId) {
        for constraint in model.configuration_constraints.iter_mut().chain(&mut model.motion_constraints) {
            if self.is_of_joint(constraint.span) {
                continue;
            }
            let reads = self.reads(&constraint.expression);
            if reads.turning && reads.cut {
                constraint.expression = self.at(&constraint.expression, beyond);
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

    /// A copy of the joint's point that stays with the inner side, before it in the order.
    fn leave_behind(&self, model: &mut Model) -> PointId {
        let own = &model.points[self.cut.point];
        let stays = Point { name: format!("{} standing", own.name), ..own.clone() };
        let stays = model.points.push(stays);
        let place = model.order.iter().position(|entity| *entity == Entity::Point(self.cut.point));
        model.order.insert(place.unwrap_or(0), Entity::Point(stays));
        stays
    }

    /// Constraints of the joint itself, and everything on the inner side, refer to the copy that stays.
    fn detach(&self, model: &mut Model) {
        let stays = self.leave_behind(model);
        for constraint in model.configuration_constraints.iter_mut().chain(&mut model.motion_constraints) {
            if self.is_of_joint(constraint.span) {
                constraint.expression = self.at(&constraint.expression, stays);
            }
        }
        for &staying in &self.staying {
            let way = way_of(model, staying);
            *way = self.at(way, stays);
        }
        for &body in &self.left {
            model.bodies[body].centre = stays;
        }
    }

    /// The expression with another point for that of the cut.
    fn at(&self, expr: &Expr, point: PointId) -> Expr {
        let other = |e: &Expr| {
            let kind = match e.kind {
                ExprKind::Velocity(_) => ExprKind::Velocity(point),
                _ => ExprKind::Point(point),
            };
            Expr { kind, ..e.clone() }
        };
        self.with_points(expr, &|p| p == self.cut.point, &other)
    }

    /// The expression with something else for some points and their velocities; definitions that read any point are
    /// written out.
    fn with_points(
        &self,
        expr: &Expr,
        chosen: &dyn Fn(PointId) -> bool,
        other: &dyn Fn(&Expr) -> Expr,
    ) -> Expr {
        expr.replaced(&|e| match e.kind {
            ExprKind::Point(p) | ExprKind::Velocity(p) if chosen(p) => Some(other(e)),
            ExprKind::Definition(d) if self.definitions[d].point => {
                Some(self.with_points(&self.model.definitions[d].value, chosen, other))
            }
            _ => None,
        })
    }

    /// A displaced copy of a point.
    fn copy(&self, model: &mut Model, point: PointId, name: String, by: &Expr) -> PointId {
        let span = self.model.points[point].span;
        let at = Expr { kind: ExprKind::Point(point), span, unit: Unit::NONE };
        let position = at + by.clone();
        let copy = model.points.push(Point { name, position, closures: Vec::new(), velocity: None, span });
        model.order.push(Entity::Point(copy));
        copy
    }
}

/// The expression for a point.
fn way_of(model: &mut Model, (point, place): Way) -> &mut Expr {
    let own = &mut model.points[point];
    if place == 0 { &mut own.position } else { &mut own.closures[place - 1] }
}
