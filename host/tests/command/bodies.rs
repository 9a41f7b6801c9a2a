//! What a scene of format 1 says of gas without a volume, of dampers that do not count, and of slips.

use crate::support::{smartbed, written};
use smartbed::scene::parse;
use smartbed_runtime::flexible::Gas;

fn read(text: &str) -> Result<smartbed::scene::Scene, String> {
    parse("s.toml", &format!("format = 1\nlaw = \"none\"\n{text}"), &[])
}

/// The volume at which the pressure of a scene's gas holds (m^3).
fn volume(text: &str) -> f64 {
    match read(text).expect(text).around.inflation.expect("gas").gas {
        Gas::Polytropic { volume, .. } => volume,
        Gas::Constant(_) => panic!("{text}"),
    }
}

/// A cube of side a encloses a^3, wherever it stands.
#[test]
fn gas_fills_the_body_unless_its_volume_is_given() {
    let cube = "shape = \"cube\"\nside = 0.4\npressure = 500\ngas = \"polytropic\"\n";
    for more in ["", "drop_height = 7\n", "drop_height = 7\ntilt = 0.3\n"] {
        let found = volume(&format!("{cube}{more}"));
        assert!((found / 0.064 - 1.0).abs() < 1e-12, "{more}: {found}");
    }
    assert!((volume(&format!("{cube}dead_volume = 1\n")) / 1.064 - 1.0).abs() < 1e-12);
    assert_eq!(volume(&format!("{cube}volume = 0.1\n")), 0.1);
}

#[test]
fn gas_needs_a_surface_that_has_a_volume() {
    let gas = "pressure = 500\ngas = \"polytropic\"\ndead_volume = 0.1\n";
    for shape in ["shape = \"cylinder\"\n", "shape = \"sheet\"\nrows = 3\ncolumns = 3\ndrop_height = 1\n"] {
        let found = read(&format!("{shape}{gas}")).expect_err(shape);
        assert!(found.contains("`gas`: gas needs a closed surface"), "{found}");
    }
    // The plane of its frame closes a sheet that stands on the origin, at every tilt.
    for tilt in [0.0, 0.4] {
        let sheet = format!("shape = \"sheet\"\nrows = 3\ncolumns = 3\ntilt = {tilt}\n{gas}");
        assert!((volume(&sheet) - 0.1).abs() < 1e-15, "{tilt}");
    }
}

#[test]
fn a_pressure_below_a_vacuum_is_refused() {
    let cube = "shape = \"cube\"\n";
    for (lines, is_taken) in [
        ("pressure = -101324", true),
        ("pressure = -101326", false),
        ("pressure = -101324\ngas = \"polytropic\"", true),
        ("pressure = -2001\ngas = \"polytropic\"\nambient = 2000", false),
    ] {
        let found = read(&format!("{cube}{lines}\n"));
        assert_eq!(found.is_ok(), is_taken, "{lines}: {found:?}");
        assert!(
            is_taken || found.is_err_and(|e| e.contains("`pressure`") && e.contains("less than a vacuum"))
        );
    }
}

/// The load of an open surface with a free rim has no potential: said once. A fixed rim, and a closed surface, have
/// one.
#[test]
fn a_pressure_on_an_open_surface_is_told() {
    for (shape, is_told) in [("cylinder", true), ("cube", false), ("ball", false), ("sheet", false)] {
        let scene = read(&format!("shape = \"{shape}\"\npressure = 100\nstep = 1e-4\n")).expect(shape);
        let told = scene.warnings.iter().filter(|w| w.contains("its work has no potential")).count();
        assert_eq!(told, usize::from(is_told), "{shape}: {:?}", scene.warnings);
    }
}

/// The lower bars of a truss touch: six of its seven springs end at a massless point.
#[test]
fn dampers_that_do_not_count_are_told() {
    let read = |more: &str| {
        let text = format!("format = 1\nshape = \"truss\"\nlaw = \"massless_point\"\n{more}");
        parse("s.toml", &text, &[]).expect("a scene").warnings
    };
    assert_eq!(read(""), Vec::<String>::new());
    let told = read("C = 5\n").join("\n");
    assert!(told.contains("s.toml:4: `C`: 6 of 7 dampers left out"), "{told}");
}

/// A point that is held in space below the floor was put on the floor when a step had many events.
#[test]
fn fixed_points_below_the_floor_stay_there() {
    let text = "format = 1\npoints = [[0, 0, 0.3], [0.2, 0, 0.5]]\nsprings = [[0, 1]]\nfixed = [0]\nT = 1\n\
                floor = { offset = 0.4 }\n";
    let file = written("fixed_below.toml", text);
    for law in ["compensation", "newton", "moreau"] {
        for method in ["", "verlet", "rk4"].into_iter().filter(|method| law != "moreau" || method.is_empty())
        {
            let set = format!("law={law}");
            let mut arguments = vec!["run", &file, "--set", &set, "--csv", "-"];
            if !method.is_empty() {
                arguments.extend(["--method", method]);
            }
            let rows = smartbed(&arguments);
            assert_eq!(rows.status, 0, "{}", rows.err);
            let mut lines = rows.out.lines();
            let column = lines.next().expect("names").split(',').position(|name| name == "z0").expect("z0");
            let moved =
                lines.filter(|row| row.split(',').nth(column).map(str::parse) != Some(Ok(0.3_f64))).count();
            assert_eq!(moved, 0, "{law}, {method}");
        }
    }
}

#[test]
fn a_fixed_point_needs_no_mass() {
    let text = "format = 1\npoints = [[0, 0, 0], [0, 0, 1]]\nsprings = [[0, 1]]\nfixed = [0]\nT = 0.1\nlaw = \"none\"\n";
    let total = |mass: &str| {
        let file = written("no_mass.toml", &format!("{text}mass = {mass}\n"));
        smartbed(&["run", &file, "--json"]).json()["total"].clone()
    };
    // The potential energy of a fixed point at height 0 is 0 whatever its mass.
    assert_eq!(total("[0, 1]"), total("[1, 1]"));
}

#[test]
fn slips_are_answered_with_what_to_write() {
    let nothing = written("nothing.toml", "format = 1\ntitle = \"nothing\"\n");
    let beyond = written("beyond.toml", "format = 1\npoints = [[0, 0, 1]]\ng = 1e400\n");
    for (arguments, words) in [
        (
            &["run", "truss", "--set", "eta=.5"][..],
            "--set eta=.5: expected a number, found \".5\"; write 0.5",
        ),
        (&["run", "truss", "--set", "bays=1e3"], "expected a whole number >= 1, found 1000.0; write 1000"),
        (&["run", "truss", "--seconds", "-1"], "--seconds -1: expected a number >= 0"),
        (&["run", "pendulum", "--step", "-1"], "--step -1: expected a time above 0"),
        (&["run", "truss", "--error", "-1"], "--error -1: expected a number above 0"),
        (
            &["run", "truss", "--method", "dop853", "--tolerance", "-1"],
            "--tolerance -1: expected a number > 0",
        ),
        (&["report", "truss", "--seconds", "-1"], "--seconds -1: expected a number above 0"),
        (
            &["run", "truss", "--set", "law=moreau", "--error", "1e-3"],
            "law = \"moreau\" takes steps of its own",
        ),
        (
            &["run", "truss", "--set", "C=1e9", "--method", "rk4"],
            "method = \"damped_verlet\", which dampers do not limit",
        ),
        (&["run", &nothing], "a scene needs a `shape` or `points`"),
        (&["run", &beyond], ":3: floating-point number overflowed"),
    ] {
        let done = smartbed(arguments);
        assert!(done.message().contains(words), "{arguments:?}: {}", done.err);
    }
    let done = smartbed(&["run", "truss", "--budget", "1ns"]);
    assert!(done.message().contains("allow more time") && !done.err.contains("--engine"), "{}", done.err);
}
