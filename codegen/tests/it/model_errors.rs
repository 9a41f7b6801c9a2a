//! Messages of faulty models in their final layout.

use smartbed_codegen::model;

const HEAD: &str = "format = 1\nname = \"m\"\n";

#[track_caller]
fn check(body: &str, expected: &str) {
    let text = format!("{HEAD}{body}");
    let found = model::parse("m.toml", &text).map(|_| ()).expect_err("the model is faulty");
    assert_eq!(found.to_string().trim_end(), expected.trim_matches('\n'), "\n{found}");
}

#[test]
fn units_are_checked_at_the_subexpression() {
    check(
        "[parameters]\nl = { value = 1, unit = \"m\" }\nk = { value = \"2*(l + 3)\", unit = \"m\" }\n",
        r#"
error: a quantity in m and one without unit cannot be added
 --> m.toml:5:23
  |
5 | k = { value = "2*(l + 3)", unit = "m" }
  |                       ^ this is without unit
  |                   - this is in m
  = help: a literal may carry its unit, such as 0.5_m; a factor in m is missing
"#,
    );
}

#[test]
fn a_zero_fits_all_unless_it_carries_a_unit() {
    let lengths = "[parameters]\nl = { value = 1, unit = \"m\" }\nk = { value = \"l + 0.0_m + 0 + 0*l*l + 0*l/1_kg + (0*l).powi(3) + sqrt(0*l)\", unit = \"m\" }\n";
    let motion = "[coordinates]\nq = { unit = \"m\" }\n[points]\nP = \"q*N.x + 0.2_m*N.y + 0.0_m*N.z + 0*N.z\"\n\
                  [bodies]\nb = { centre = \"P\", mass = \"1_kg\" }\n";
    model::parse("m.toml", &format!("{HEAD}{lengths}{motion}")).unwrap_or_else(|found| panic!("{found}"));
    check(
        "[parameters]\nl = { value = 1, unit = \"m\" }\nk = { value = \"l + 0.0_s\", unit = \"m\" }\n",
        r#"
error: a quantity in m and one in s cannot be added
 --> m.toml:5:20
  |
5 | k = { value = "l + 0.0_s", unit = "m" }
  |                    ^^^^^ this is in s
  |                - this is in m
  = help: a factor in m/s is missing
"#,
    );
}

#[test]
fn places_survive_repetition_and_several_lines() {
    check(
        "[repeat.r]\neach = [{ i = \"1\" }, { i = \"22\" }]\n[repeat.r.coordinates]\n\"q{i}\" = { unit = \"rad\" }\n[repeat.r.definitions]\n\"d{i}\" = '''\nsin(q{i}) + \n  coz(q{i})'''\n",
        r#"
error: unknown function `coz`
  --> m.toml:10:3
   |
10 |   coz(q{i})'''
   |   ^^^ not a function
   = help: did you mean `cos`?
"#,
    );
}

#[test]
fn all_errors_of_a_stage_come_at_once() {
    let text = format!("{HEAD}[parameters]\na = \"b\"\nc = \"d\"\n[inputs]\nF = {{ unit = \"Nm\" }}\n");
    let found = model::parse("m.toml", &text).expect_err("three faults");
    assert_eq!(found.items.len(), 3, "{found}");
}

#[test]
fn cycles_name_their_members() {
    check(
        "[definitions]\na = \"b + 1\"\nb = \"sin(c)\"\nc = \"a\"\n",
        r#"
error: cyclic definition: a -> b -> c -> a
 --> m.toml:4:6
  |
4 | a = "b + 1"
  |      ^ `a` needs `b`
5 | b = "sin(c)"
  |          - `b` needs `c`
6 | c = "a"
  |      - `c` needs `a`
  = help: nothing can be computed from itself: break the cycle
"#,
    );
}

#[test]
fn duplicates_show_both_places() {
    check(
        "[parameters]\na = 1\n[definitions]\na = \"2\"\n",
        r#"
error: `a` is declared twice
 --> m.toml:6:1
  |
6 | a = "2"
  | ^ declared here again
4 | a = 1
  | - already a parameter, declared here
  = help: parameters, coordinates, speeds, inputs, definitions and points share one name space; rename one of the two
"#,
    );
}

#[test]
fn masses_are_constant() {
    check(
        "[coordinates]\nq = { unit = \"m\" }\n[points]\nP = \"q*N.x\"\n[bodies]\nb = { centre = \"P\", mass = \"2_kg*(1 + q/1_m)\" }\n",
        r#"
error: a mass cannot depend on the coordinates
 --> m.toml:8:39
  |
8 | b = { centre = "P", mass = "2_kg*(1 + q/1_m)" }
  |                                       ^ this depends on the coordinates
  = help: only numbers, parameters and functions of them may stand here
"#,
    );
}

#[test]
fn motion_constraints_are_linear_in_the_speeds() {
    check(
        "[coordinates]\nx = { unit = \"m\" }\ny = { unit = \"m\" }\n[constraints.motion]\nbad = \"u_x - u_y*u_y/1_m*1_s\"\n",
        r#"
error: a motion constraint must be linear in the speeds
 --> m.toml:7:14
  |
7 | bad = "u_x - u_y*u_y/1_m*1_s"
  |              ^^^^^^^ this is not linear in the speeds
  = help: Kane's method needs velocities of the form sum of a_r(q, t) u_r + b(q, t)
"#,
    );
}

#[test]
fn stated_degrees_of_freedom_are_compared() {
    check(
        "dof = 1\n[coordinates]\nx = { unit = \"m\" }\ny = { unit = \"m\" }\n",
        r#"
error: dof = 1, but the model declares 2 independent speeds
 --> m.toml:3:7
  |
3 | dof = 1
  |       ^ independent: u_x, u_y
  = help: correct dof, or mark coordinates as `independent = true` or `false`
"#,
    );
}

#[test]
fn numbers_are_in_the_declared_unit_and_expressions_in_their_own() {
    let text = format!(
        "{HEAD}[parameters]\na = {{ value = 90, unit = \"deg\" }}\nb = {{ value = \"90\", unit = \"mm\" }}\nc = {{ value = \"90_mm\", unit = \"m\" }}\nd = {{ value = \"2*b\", unit = \"mm\" }}\n"
    );
    let model = model::parse("m.toml", &text).unwrap_or_else(|found| panic!("{found}"));
    let values: Vec<f64> = model.parameter_defaults().iter().copied().collect();
    assert_eq!(values, [90.0 * (std::f64::consts::PI / 180.0), 0.09, 0.09, 0.18]);
    let units: Vec<&str> = model.parameters.iter().map(|p| p.unit.as_str()).collect();
    assert_eq!(units, ["rad", "m", "m", "m"]);
}

#[test]
fn an_extension_takes_over_what_it_names() {
    let base = format!(
        "{HEAD}[parameters]\na = {{ value = 1, unit = \"m\", doc = \"length\" }}\nb = {{ value = 2, unit = \"m\" }}\n[inputs]\nF = {{ unit = \"m\" }}\n[law]\nF = \"2*a\"\n"
    );
    let text = "format = 1\nname = \"n\"\nextends = \"base.toml\"\n[parameters]\na = { value = 5 }\n[definitions]\nb = \"3*a\"\nF = \"a\"\n";
    let load = |path: &std::path::Path| {
        assert_eq!(path, std::path::Path::new("models/base.toml"));
        Ok(base.clone())
    };
    let model = model::parse_with("models/n.toml", text, &load).unwrap_or_else(|found| panic!("{found}"));
    assert_eq!(model.name, "n");
    assert_eq!(model.parameters.len(), 1);
    assert_eq!(
        model.parameters.iter().next().map(|p| (p.doc.as_str(), p.unit.as_str())),
        Some(("length", "m"))
    );
    assert_eq!(model.parameter_defaults().as_slice(), [5.0]);
    assert!(model.inputs.is_empty());
    // The base's law for the input that is a definition now is left out.
    assert!(model.laws.is_empty());
    let circle = model::parse_with("models/n.toml", text, &|_| Ok("extends = \"n.toml\"".to_owned()));
    assert!(circle.expect_err("a circle").to_string().contains("in a circle"));
}

/// `n = 3` over an entry in braces changes its value and keeps its unit, range and whether it is fixed, as
/// `n = { value = 3 }` does; so does a definition, and one in braces over a short one.
#[test]
fn a_short_entry_changes_the_field_that_it_is_short_for() {
    let base = format!(
        "{HEAD}[parameters]\ntilt = {{ value = 30, unit = \"deg\", range = [0, 60], fixed = true }}\nn = 2\n\
         [definitions]\nslope = {{ value = 10, unit = \"deg\" }}\ntwice = \"2*n\"\n"
    );
    let read = |changes: &str| {
        let text = format!("format = 1\nname = \"n\"\nextends = \"base.toml\"\n{changes}");
        model::parse_with("models/n.toml", &text, &|_| Ok(base.clone()))
    };
    let [short, long] = [
        "[parameters]\ntilt = 45\nn = { doc = \"a number\" }\n[definitions]\nslope = \"20\"\n",
        "[parameters]\ntilt = { value = 45 }\nn = { value = 2, doc = \"a number\" }\n[definitions]\nslope = { value = \"20\" }\n",
    ]
    .map(|changes| read(changes).unwrap_or_else(|found| panic!("{found}")));
    let seen = |model: &model::Model| {
        let of = |p: &model::Parameter| (p.doc.clone(), p.written_unit.clone(), p.tunable, p.range);
        (model.parameters.iter().map(of).collect::<Vec<_>>(), model.parameter_defaults().as_slice().to_vec())
    };
    assert_eq!(seen(&short), seen(&long));
    let tilt = short.parameters.iter().next().expect("tilt");
    assert_eq!((tilt.written_unit.0.as_str(), tilt.tunable), ("deg", false));
    assert!((short.parameter_defaults().as_slice()[0] - 45.0_f64.to_radians()).abs() < 1e-15);
    assert_eq!(
        format!("{:?}", short.definitions.iter().next().map(|d| &d.value.kind)),
        format!("{:?}", long.definitions.iter().next().map(|d| &d.value.kind))
    );
    assert!(read("[parameters]\ntilt = 70\n").expect_err("out of range").to_string().contains("60"));
}

/// A number in another unit than its range is rounded otherwise; one with letters is none.
#[test]
fn bounds_hold_in_every_unit_and_numbers_have_no_letters() {
    let read = |value: &str| {
        let range =
            format!("{HEAD}[parameters]\nl = {{ value = {value}, unit = \"mm\", range = [700, 900] }}\n");
        model::parse("m.toml", &range).map(|_| ()).map_err(|found| found.to_string())
    };
    for value in ["700", "\"0.7_m\"", "\"70_cm\"", "\"0.9_m\""] {
        assert_eq!(read(value), Ok(()), "{value}");
    }
    for value in ["699.999", "\"0.9001_m\""] {
        assert!(read(value).expect_err(value).contains("expected a number from"), "{value}");
    }
    for value in ["15_c", "15_cab", "0x1_g"] {
        assert!(read(value).is_err(), "{value}");
    }
    assert!(read("15_cab").expect_err("letters").contains("`15_cab` is no number"));
}

#[test]
fn speeds_may_be_combinations_of_rates() {
    let text = format!(
        "{HEAD}dof = 2\n[coordinates]\na = {{ unit = \"rad\", speed = false }}\nb = {{ unit = \"rad\", speed = \"u2\" }}\n[speeds]\nu1 = {{ value = \"q_dot(a)*cos(b) + q_dot(b)\", unit = \"rad/s\" }}\n"
    );
    let model = model::parse("m.toml", &text).unwrap_or_else(|found| panic!("{found}"));
    let names: Vec<&str> = model.speeds.iter().map(|s| s.name.as_str()).collect();
    assert_eq!(names, ["u2", "u1"]);
}

/// Joints that roll, slide on an edge or use Euler parameters state speeds of their own: another one was left unread.
#[test]
fn speeds_that_a_joint_states_cannot_be_stated_again() {
    let knife = |speed: &str| {
        format!(
            "[joints]\nk = {{ kind = \"knife_edge\", child = \"s\", speed = [{speed}] }}\n[bodies]\nb = {{ centre = \"s\", mass = \"1_kg\" }}\n"
        )
    };
    check(
        &knife("\"vx\", false, \"wz\""),
        r#"
error: the speed of `k_x` cannot be stated here
 --> m.toml:4:50
  |
4 | k = { kind = "knife_edge", child = "s", speed = ["vx", false, "wz"] }
  |                                                  ^^^^ its joint states it
  = help: leave `speed` out, or give false in its place of the list; `check` lists the speeds of the joint
"#,
    );
    let model = model::parse("m.toml", &format!("{HEAD}{}", knife("false, false, \"wz\"")));
    assert!(model.is_ok(), "{}", model.err().map_or_else(String::new, |found| found.to_string()));
}
