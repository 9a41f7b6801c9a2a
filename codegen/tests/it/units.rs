//! Units: reading, printing, rational exponents.

use smartbed_codegen::model;
use smartbed_codegen::model::unit::{Unit, parse};

#[track_caller]
fn check(text: &str, canonical: &str, factor: f64) {
    let scale = parse(text).unwrap_or_else(|(message, _)| panic!("{text}: {message}"));
    assert_eq!(scale.unit.to_string(), canonical, "{text}");
    assert_eq!(scale.factor, factor, "{text}");
}

#[test]
fn products_and_quotients_are_read() {
    check("kg m^2", "kg m^2", 1.0);
    check("N s/m", "N s/m", 1.0);
    check("m/s^2", "m/s^2", 1.0);
    check("kg/(m s^2)", "Pa", 1.0);
    check("N*m", "N m", 1.0);
    check("J", "N m", 1.0);
    check("1/s", "1/s", 1.0);
    check("rad", "1", 1.0);
    check("", "1", 1.0);
    check("m^(1/2)", "m^(1/2)", 1.0);
    check("mm", "m", 1e-3);
    check("kN/mm", "N/m", 1e6);
    check("V", "kg m^2/(s^3 A)", 1.0);
}

#[test]
fn every_canonical_text_reads_as_the_same_unit() {
    for text in ["kg m^2", "N s/m", "kg/(m s^2)", "W/K", "m^(1/2) s^-1", "A^(-3/2)", "J/(kg K)"] {
        let unit = parse(text).expect("a unit").unit;
        assert_eq!(parse(&unit.to_string()).expect("its text").unit, unit, "{text}");
    }
}

#[test]
fn faults_name_their_place() {
    let fault = |text: &str| parse(text).expect_err(text);
    assert_eq!(fault("kg mm/q"), ("unknown unit `q`".to_owned(), 6..7));
    assert_eq!(fault("kg/m s").0, "ambiguous after `/`: write kg/(m s^2)");
    assert_eq!(fault("m/s/s").0, "only one `/`: write kg/(m s^2)");
    assert_eq!(fault("m^").0, "expected an integer exponent of at most 64");
    assert_eq!(fault("m^(1/0)").0, "expected an exponent such as 2, -1 or (1/2)");
    assert_eq!(fault("m*").0, "a unit is missing here");
    assert_eq!(fault("(m").0, "`)` is missing");
    assert_eq!(fault("m)").0, "unexpected `)`");
    assert_eq!(fault("µm"), ("unknown unit `µ`".to_owned(), 0..2));
    assert_eq!(fault(&"(".repeat(1000)).0, "too many parentheses");
}

#[test]
fn exponents_stay_within_bounds() {
    let mut steps = 0;
    let mut unit = Unit::FORCE;
    while let Some(next) = unit.power(7, 3) {
        (unit, steps) = (next, steps + 1);
    }
    assert!((2..10).contains(&steps), "{steps} steps before 7^n leaves 8 bits");
    assert_eq!(Unit::FORCE.power(1, 2).and_then(|u| u.power(2, 1)), Some(Unit::FORCE));
    assert_eq!(Unit::FORCE.power(1, 0), None);
}

/// A start value as a model text holds it, in SI.
#[track_caller]
fn start(unit: &str, written: &str) -> f64 {
    let text = format!(
        "format = 1\nname = \"case\"\n[coordinates]\nq = {{ unit = \"{unit}\" }}\n[points]\nP = \"q*N.x\"\n\
         [bodies]\nbob = {{ centre = \"P\", mass = \"1_kg\" }}\n[start]\nq = {written}\n"
    );
    let text = if unit == "deg" { text.replace("q*N.x", "sin(q)*1_m*N.x") } else { text };
    let model = model::parse("case", &text).unwrap_or_else(|e| panic!("{written}: {e:?}"));
    model.start[0].1
}

#[test]
fn quotes_leave_plain_numbers_in_the_unit_of_the_coordinate() {
    let degree = std::f64::consts::PI / 180.0;
    for sixty in [
        "60",
        "60.0",
        "\"60\"",
        "\" 6e1 \"",
        "\"2*30\"",
        "\"-(20 - 80)\"",
        "\"120/2\"",
        "\"60*deg\"",
        "\"60_deg\"",
        "\"pi/3\"",
    ] {
        assert!((start("deg", sixty) - 60.0 * degree).abs() < 1e-15, "{sixty}");
    }
    for half in ["500", "\"500\"", "\"2*250\"", "\"0.5_m\"", "\"2*250_mm\""] {
        assert!((start("mm", half) - 0.5).abs() < 1e-15, "{half}");
    }
    assert_eq!(start("deg", "\"0.5*2_rad\""), 1.0);
    assert_eq!(start("deg", "\"atan2(1, 1)\""), std::f64::consts::FRAC_PI_4);
}

/// Plain numbers, quoted or not, are in the unit stated beside them, wherever a quantity states one.
#[test]
fn a_plain_number_is_in_the_unit_stated_beside_it() {
    let model = |number: &str| {
        let text = format!(
            "format = 1\nname = \"plain\"\n[parameters]\np = {{ value = {number}, unit = \"deg\" }}\n\
             [definitions]\nd = {{ value = {number}, unit = \"deg\" }}\nl = {{ value = {number}, unit = \"mm\" }}\n\
             [coordinates]\na = {{ unit = \"deg\", closed_form = {number} }}\nb = {{ unit = \"mm\", closed_form = {number} }}\n\
             s = {{ unit = \"m\", independent = true }}\n[points]\nP = \"s*N.x + b*N.y\"\n[bodies]\nm = {{ centre = \"P\", mass = 1 }}\n\
             [outputs]\ny = {{ value = {number}, unit = \"deg\" }}\nz = {{ value = {number}, unit = \"mm\" }}\n\
"
        );
        model::parse("plain.toml", &text).expect("it is read")
    };
    for number in ["60", "\"60\"", "\"2*30\""] {
        let model = model(number);
        let of = |expr: &model::Expr| match expr.kind {
            model::expression::ExprKind::Number(number) => number,
            _ => panic!("{number}: no number"),
        };
        let forms = model.coordinates.iter().filter_map(|c| c.closed_form.as_ref());
        let mut found: Vec<f64> = forms.map(of).collect();
        found.extend(model.definitions.iter().map(|d| of(&d.value)));
        found.extend(model.outputs.iter().take(2).map(|o| of(&o.value)));
        found.extend(model.parameters.iter().map(|p| of(&p.value)));
        let (angle, length) = (60_f64.to_radians(), 0.06);
        assert_eq!(found, [angle, length, angle, length, angle, length, angle], "{number}");
    }
}
