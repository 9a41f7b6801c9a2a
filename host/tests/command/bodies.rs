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

#[test]
fn slips_are_answered_with_what_to_write() {
    let nothing = written("nothing.toml", "format = 1\ntitle = \"nothing\"\n");
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
    ] {
        let done = smartbed(arguments);
        assert!(done.message().contains(words), "{arguments:?}: {}", done.err);
    }
    let done = smartbed(&["run", "truss", "--budget", "1ns"]);
    assert!(done.message().contains("allow more time") && !done.err.contains("--engine"), "{}", done.err);
}
