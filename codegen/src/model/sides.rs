//! The two sides of a joint that is cut: what moves with the outer side, what stays with the inner side.
//!
//! In: a model, a cut. Out: for every frame, point, body and constraint the side that it belongs to, and the
//! expressions in which the outer side is reached from the joint's own point, which both sides share.

use super::data::*;
use super::expression::{Expr, ExprKind};
use super::ids::*;
use super::unit::Unit;
use crate::diagnostic::Diagnostic;
use crate::id::{Id, IdVec};
use crate::source::Span;

/// The place of O among the points.
pub(super) const ORIGIN: usize = 0;

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
pub(super) struct Reads {
    /// It contains an axis that turns with the outer side.
    pub turning: bool,
    /// It contains the point of the cut.
    pub cut: bool,
    /// It contains any point.
    pub point: bool,
    /// It contains a point of the outer side.
    outer: bool,
    /// It contains a point of the inner side, other than that of the cut and O.
    inner: bool,
    /// It contains a point whose position depends on the attitude of the outer side.
    swept: bool,
}

/// An expression for a point: the point, and the number of the expression among those that its declaration gives.
pub(super) type Way = (PointId, usize);

/// The two sides of a cut.
pub(super) struct Sides<'m> {
    pub model: &'m Model,
    pub cut: Cut,
    /// The joint's point itself goes with the outer side: where no frame is named, and where a word of `[joints]` made
    /// both. Then all that is reached from the point goes with it, except what the joint itself holds.
    pub goes: bool,
    pub definitions: IdVec<DefinitionId, Reads>,
    /// By frame: does it turn with the outer side?
    turning: IdVec<FrameId, bool>,
    /// By point: is it on the outer side?
    outer: IdVec<PointId, bool>,
    swept: IdVec<PointId, bool>,
    /// Expressions that lead from the cut to the outer side.
    pub starts: Vec<Way>,
    /// Expressions that mix points of the outer side with that of the cut, such as the middle of a link.
    pub mixing: Vec<Way>,
    /// Expressions of points of the inner side that lead there from a joint's point which goes with the outer side.
    pub staying: Vec<Way>,
    /// Bodies of the outer side whose mass centre is a point that both sides share.
    pub sharing: Vec<BodyId>,
    /// Bodies of the inner side whose mass centre is a joint's point which goes with the outer side.
    pub left: Vec<BodyId>,
    /// The first point that turns with the outer side but is not reached from the cut.
    stray: Option<PointId>,
}

impl<'m> Sides<'m> {
    pub fn new(model: &'m Model, cut: Cut) -> Result<Self, Diagnostic> {
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
        let goes =
            cut.frame.is_none() || frame_of_joint(model, cut.point).is_some_and(|own| Some(own) == cut.frame);
        let mut sides = Self {
            model,
            cut,
            goes,
            definitions: model.definitions.iter().map(|_| Reads::default()).collect(),
            turning: model.frames.ids().map(|frame| Some(frame) == cut.frame).collect(),
            outer: model.points.ids().map(|p| goes && p == cut.point).collect(),
            swept: model.points.iter().map(|_| false).collect(),
            starts: Vec::new(),
            mixing: Vec::new(),
            staying: Vec::new(),
            sharing: Vec::new(),
            left: Vec::new(),
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

    pub fn reads(&self, expr: &Expr) -> Reads {
        let mut found = Reads::default();
        expr.visit(&mut |e| match e.kind {
            ExprKind::Axis(frame, _) | ExprKind::AngularVelocity(frame) => {
                found.turning |= self.turning[frame];
            }
            ExprKind::Point(p) | ExprKind::Velocity(p) => {
                found.point = true;
                found.cut |= p == self.cut.point;
                found.outer |= self.outer[p];
                found.inner |= !self.outer[p] && p != self.cut.point && p.index() != ORIGIN;
                found.swept |= self.swept[p];
            }
            ExprKind::Definition(d) => {
                let within = self.definitions[d];
                found.turning |= within.turning;
                found.cut |= within.cut;
                found.point |= within.point;
                found.outer |= within.outer;
                found.inner |= within.inner;
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
        let hangs_inside = frame_of_joint(self.model, id).is_some_and(|frame| !self.turning[frame]);
        for (place, way) in ways(declared).enumerate() {
            let reads = self.reads(way);
            self.swept[id] |= reads.turning || reads.swept;
            if self.goes && self.cut.frame.is_some() && reads.cut && hangs_inside {
                self.staying.push((id, place));
                continue;
            }
            self.outer[id] |= reads.outer;
            if self.cut.frame.is_none() {
                continue;
            }
            if !self.goes && reads.outer && !reads.inner && self.mixes(way, reads) {
                self.mixing.push((id, place));
            } else if reads.turning && !reads.outer {
                if self.begins_at_cut(reads) {
                    self.starts.push((id, place));
                    self.outer[id] = true;
                } else {
                    self.stray = self.stray.or(Some(id));
                }
            }
        }
        let velocity = declared.velocity.as_ref().map(|velocity| self.reads(velocity));
        self.swept[id] |= velocity.is_some_and(|reads| reads.turning || reads.swept);
    }

    /// Does it lead to the outer side from the joint's own point too? From O also where no point is named: "A/2" is the
    /// middle of O and A.
    fn mixes(&self, way: &Expr, reads: Reads) -> bool {
        let from_origin = self.cut.point.index() == ORIGIN && self.weight(way) != Some(1.0);
        reads.cut || from_origin
    }

    /// The sum of the factors of points other than O, if it is plain.
    fn weight(&self, expr: &Expr) -> Option<f64> {
        match &expr.kind {
            ExprKind::Point(p) => Some(if p.index() == ORIGIN { 0.0 } else { 1.0 }),
            ExprKind::Definition(d) => self.weight(&self.model.definitions[*d].value),
            ExprKind::Negate(a) => Some(-self.weight(a)?),
            ExprKind::Add(a, b) => Some(self.weight(a)? + self.weight(b)?),
            ExprKind::Subtract(a, b) => Some(self.weight(a)? - self.weight(b)?),
            ExprKind::Multiply(a, b) if let ExprKind::Number(x) = a.kind => Some(x * self.weight(b)?),
            ExprKind::Multiply(a, b) if let ExprKind::Number(x) = b.kind => Some(x * self.weight(a)?),
            ExprKind::Divide(a, b) if let ExprKind::Number(x) = b.kind => Some(self.weight(a)? / x),
            _ => (!self.reads(expr).point).then_some(0.0),
        }
    }

    /// Collects the bodies of one side whose mass centre is a point that goes with the other.
    fn bodies(&mut self) -> Result<(), Diagnostic> {
        for (id, body) in self.model.bodies.enumerate() {
            let turns = body.frame.is_some_and(|frame| self.turning[frame]);
            // Of N nothing is left behind: its bodies do not move.
            let stands = body.frame.is_some_and(|frame| frame.index() > 0 && !self.turning[frame]);
            if self.goes && self.cut.frame.is_some() && body.centre == self.cut.point && stands {
                self.left.push(id);
            }
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

    /// At the point of the cut, or at O where no point is named.
    fn begins_at_cut(&self, reads: Reads) -> bool {
        reads.cut || (self.cut.point.index() == ORIGIN && !reads.point)
    }

    pub fn frame_name(&self) -> &str {
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

/// The frame that a word of `[joints]` made with this point: of the same name, or that of the point to which the joint
/// leads from it.
fn frame_of_joint(model: &Model, point: PointId) -> Option<FrameId> {
    let mut at = point;
    // From the base along the translations to the foot, from there to the link.
    for _ in 0..3 {
        let own = &model.points[at];
        let named = |f: &FrameId| model.frames[*f].span == own.span && model.frames[*f].name == own.name;
        if let Some(frame) = model.frames.ids().find(named) {
            return Some(frame);
        }
        at = model.points.ids().find(|q| {
            let next = &model.points[*q];
            let mut reached = false;
            next.position.visit(&mut |e| reached |= matches!(e.kind, ExprKind::Point(p) if p == at));
            next.span == own.span && reached
        })?;
    }
    None
}
