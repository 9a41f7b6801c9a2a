//! Decides which curves share a panel: those of one unit, as long as none looks flat beside another.
//!
//! In: curves with units, in the author's order. Out: panels. Curves that consist of rounding errors are set to 0.

use super::chart::{Curve, Panel};

/// A panel's height may be at most this multiple of the variation of any curve in it.
const FLATTENED: f64 = 15.0;
/// Most different curves in one panel: as many as there are marks.
const CURVES: usize = 7;

/// Curves closer than this fraction of their size count as one.
const ALIKE: f64 = 1e-9;

/// A curve with its unit as shown and its typical size.
#[derive(Clone, Debug)]
pub struct Shown {
    /// The curve.
    pub curve: Curve,
    /// Unit.
    pub unit: String,
    /// Typical size of a quantity of this unit (1 for an angle in rad); 0 if unknown.
    pub natural: f64,
}

/// Panels of curves; `noise` is the rounding error of a number of size 1.
#[must_use]
pub fn of(shown: Vec<Shown>, noise: f64) -> Vec<Panel> {
    let mut units: Vec<(String, Vec<Shown>)> = Vec::new();
    for one in shown {
        match units.iter_mut().find(|(unit, _)| *unit == one.unit) {
            Some((_, list)) => list.push(one),
            None => units.push((one.unit.clone(), vec![one])),
        }
    }
    units.into_iter().flat_map(|(unit, list)| of_unit(&label(&unit), quiet(list, noise))).collect()
}

/// The curves of one unit. Those are set to 0 that are rounding errors relative to the largest and to the typical size.
fn quiet(list: Vec<Shown>, noise: f64) -> Vec<Curve> {
    let largest = list.iter().map(|s| s.curve.size().max(s.natural)).fold(0.0, f64::max);
    let silence = |mut curve: Curve| {
        if curve.size() <= noise * largest {
            curve.values.iter_mut().filter(|x| x.is_finite()).for_each(|x| *x = 0.0);
        }
        curve
    };
    list.into_iter().map(|s| silence(s.curve)).collect()
}

/// Panels in which each varying curve takes at least a fifteenth of the height; constant curves join where they fit.
fn of_unit(label: &str, curves: Vec<Curve>) -> Vec<Panel> {
    // The curves with the largest variation first.
    let mut order: Vec<usize> = (0..curves.len()).collect();
    order.sort_by(|&a, &b| curves[b].motion().total_cmp(&curves[a].motion()));
    let mut panels: Vec<Vec<usize>> = Vec::new();
    for number in order {
        let fits = |members: &Vec<usize>| {
            let all = || members.iter().chain([&number]).map(|&n| &curves[n]);
            let (low, high) = all().map(Curve::range).fold((f64::INFINITY, f64::NEG_INFINITY), union);
            let least = all().map(Curve::motion).filter(|m| *m > 0.0).fold(f64::INFINITY, f64::min);
            high - low <= FLATTENED * least
        };
        match panels.iter_mut().find(|p| fits(p)) {
            Some(panel) => panel.push(number),
            None => panels.push(vec![number]),
        }
    }
    panels.sort_by_key(|p| p.iter().copied().min());
    let mut curves: Vec<Option<Curve>> = curves.into_iter().map(Some).collect();
    let mut split = Vec::new();
    for mut members in panels {
        members.sort_unstable();
        let mut looks: Vec<Vec<Curve>> = Vec::new();
        for curve in members.iter().filter_map(|&n| curves[n].take()) {
            let distance = ALIKE * curve.size();
            match looks.iter_mut().find(|l| l[0].is_alike(&curve, distance)) {
                Some(look) => look.push(curve),
                None => looks.push(vec![curve]),
            }
        }
        // At most as many in each as there are marks, evenly distributed.
        let parts = looks.len().div_ceil(CURVES);
        for part in looks.chunks(looks.len().div_ceil(parts)) {
            split.push(Panel { label: label.to_owned(), curves: part.concat() });
        }
    }
    split
}

fn union(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    (a.0.min(b.0), a.1.max(b.1))
}

/// Quantity and unit.
pub(crate) fn label(unit: &str) -> String {
    let quantity = match unit {
        "rad" | "deg" => "angle",
        "m" | "mm" | "cm" | "km" | "um" => "length",
        "" | "1" => return "number".to_owned(),
        "m/s" | "mm/s" | "cm/s" | "km/s" => "speed",
        "rad/s" | "deg/s" | "1/s" => "rate",
        "N" | "kN" => "force",
        "m/s^2" => "acceleration",
        "N m" => "torque",
        "N s" | "kg m/s" => "momentum",
        "kg m^2/s" => "angular momentum",
        "m^3" => "volume",
        "Pa" | "kPa" => "pressure",
        "J" => "energy",
        "W" => "power",
        unit => return format!("[{unit}]"),
    };
    format!("{quantity} [{unit}]")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(name: &str, unit: &str, value: impl Fn(f64) -> f64) -> Shown {
        let values = (0..100).map(|n| value(0.1 * f64::from(n))).collect();
        let curve = Curve { name: name.to_owned(), values, color: None, across: None };
        Shown { curve, unit: unit.to_owned(), natural: if unit == "rad" { 1.0 } else { 0.0 } }
    }

    fn names(panels: &[Panel]) -> Vec<Vec<&str>> {
        panels.iter().map(|p| p.curves.iter().map(|c| c.name.as_str()).collect()).collect()
    }

    #[test]
    fn a_spin_does_not_flatten_a_swing() {
        let list = vec![
            shown("spin", "rad", |t| 5.0 * t),
            shown("swing", "rad", |t| 0.3 * t.sin()),
            shown("nod", "rad", |t| 0.1 * t.cos()),
            shown("height", "m", f64::sin),
            shown("rest", "rad", |_| 0.2),
        ];
        let panels = of(list, 1e-12);
        assert_eq!(names(&panels), [vec!["spin", "rest"], vec!["swing", "nod"], vec!["height"]]);
        assert_eq!(panels[1].label, "angle [rad]");
    }

    #[test]
    fn rounding_noise_is_zero() {
        let panels = of(vec![shown("noise", "rad", |t| 1e-16 * (37.0 * t).sin())], 1e-12);
        assert!(panels[0].curves[0].values.iter().all(|x| *x == 0.0));
        // A variation that is rounding for a mechanism of this size is set to 0.
        let panels = of(vec![shown("small", "m", |t| 1e-16 * t.sin())], 1e-12);
        assert!(panels[0].curves[0].values.iter().any(|x| *x != 0.0));
    }

    #[test]
    fn many_curves_are_shared_out() {
        let list = (0..10).map(|n| shown(&n.to_string(), "rad", move |t| (t + f64::from(n)).sin())).collect();
        assert_eq!(of(list, 1e-12).iter().map(|p| p.curves.len()).collect::<Vec<_>>(), [5, 5]);
        // Coinciding curves count as one.
        let list = (0..20).map(|n| shown(&n.to_string(), "rad", |t| t.sin())).collect();
        assert_eq!(of(list, 1e-12).len(), 1);
    }
}
