//! Commands of plans and policies pass through the code of controller and supervisor.

use smartbed::plan::supervised::Controller;
use smartbed::plan::{Read, checked, parse};
use smartbed_bed::plan::history::{History, RunError};
use smartbed_bed::plan::{Move, Plan};
use smartbed_bed::policy::bounds::Bounds;
use smartbed_bed::policy::run::run;
use smartbed_bed::policy::{Policy, Supervisor, View};

/// A plan of so many tiles under a light plate, on coarse sheets; `more` are its further lines.
fn plan(rows: usize, columns: usize, more: &str) -> Result<Read, String> {
    let text = format!(
        "format = 1\n[bed]\nrows = {rows}\ncolumns = {columns}\nintervals = [6, 8]\n[load]\nshape = \"plate\"\n\
         size = [\"100_mm\", \"100_mm\", 0]\nradius = \"50_mm\"\nmass = 5\n{more}"
    );
    parse("plan.toml", &text, &[]).map_err(|e| e.to_string()).and_then(|read| checked("plan.toml", read))
}

/// A move of some tiles from the tenth second on.
fn told(tiles: &[usize], over: f64) -> Move {
    Move { at: 10.0, over, tiles: tiles.to_vec(), pressure: None, heave: None, slope: None }
}

/// The controller's answer to moves in a whole bed.
fn say(moves: &[Move]) -> Result<(), String> {
    let read = plan(7, 4, "[run]\nseconds = 600\n").expect("a plan");
    Controller.check(&read.plan.with(moves), 0.0).map_err(|refusal| refusal.to_string())
}

#[test]
fn each_limit_is_the_controllers_and_holds_where_it_begins() {
    let all: Vec<usize> = (0..28).collect();
    let press = |pressure: f64| say(&[Move { pressure: Some(pressure), ..told(&all, 10.0) }]);
    assert_eq!(press(10_666.0), Ok(()));
    assert_eq!(
        press(10_700.0).expect_err("too much"),
        "tile 1 at 10.0000 s: its controller refuses: the pressure is outside the allowed range: 0 to 10.666 kPa"
    );
    let lift = |heave: f64, over: f64| say(&[Move { heave: Some(heave), ..told(&[12], over) }]);
    // A way of 15 mm at 3 mm/s takes 5 s and half a second to start and to stop.
    assert_eq!(lift(0.015, 5.6), Ok(()));
    let quick = lift(0.015, 5.4).expect_err("too quick");
    assert_eq!(
        quick,
        "tile 13 at 10.0000 s: its controller needs 5.5 s for a move of 5.4 s; give the move more time (`over`)"
    );
    assert_eq!(lift(0.0199, 20.0), Ok(()));
    let step = lift(0.0201, 20.0).expect_err("a step");
    assert!(
        step.contains("tile 13 at 10.0000 s: the supervisor refuses: the height step to a neighbour")
            && step.contains("20.0 mm"),
        "{step}"
    );
    let high = lift(0.0291, 20.0).expect_err("beyond the stroke");
    assert_eq!(
        high,
        "tile 13 at 10.0000 s: its controller refuses: a height would leave the stroke: 29.0 mm up and down at most"
    );
    // Along y a screw stands at the whole radius of 90 mm, along x at sqrt(3)/2 of it.
    let lean = |slope: [f64; 2]| say(&[Move { slope: Some(slope), ..told(&[12], 100.0) }]);
    assert!(
        lean([0.0, 0.33])
            .expect_err("steep")
            .contains("refuses: the tilt would be too steep: 15.0 deg at most")
    );
    // Sides of 112.5 and 142.857 mm rise by 20 mm at slopes of 0.1778 and 0.1400.
    assert_eq!((lean([0.177, 0.0]), lean([0.0, 0.1395])), (Ok(()), Ok(())));
    assert!(lean([0.1785, 0.0]).expect_err("a step").contains("height step"));
    assert!(lean([0.0, 0.1405]).expect_err("a step").contains("height step"));
    // 0.1 at half a degree a second takes 11.5 s and half a second more.
    let turn = |over: f64| say(&[Move { slope: Some([0.1, 0.0]), ..told(&[12], over) }]);
    assert!(turn(12.0).is_ok() && turn(11.9).expect_err("too quick").contains("needs 12.0 s"));
}

#[test]
fn tiles_are_judged_by_where_all_of_them_are_and_go() {
    let lift = |tiles: &[usize], at: f64, heave: f64| Move { at, heave: Some(heave), ..told(tiles, 10.0) };
    // Eight at once, not nine; the ninth when the first have come to rest.
    let eight: Vec<usize> = (0..8).collect();
    assert_eq!(say(&[lift(&eight, 10.0, 0.01)]), Ok(()));
    let nine = say(&[lift(&eight, 10.0, 0.01), lift(&[27], 12.0, 0.01)]).expect_err("too many");
    assert_eq!(
        nine,
        "tile 28 at 12.0000 s: the supervisor refuses: as many tiles are moving as may: 8 at once at most"
    );
    assert_eq!(say(&[lift(&eight, 10.0, 0.01), lift(&[27], 20.0, 0.01)]), Ok(()));
    // One order at a time; a pressure may change meanwhile.
    let twice = say(&[lift(&[5], 10.0, 0.01), lift(&[5], 15.0, 0.0)]).expect_err("it moves");
    assert_eq!(twice, "tile 6 at 15.0000 s: its controller refuses: a motion is in progress");
    assert_eq!(
        say(&[lift(&[5], 10.0, 0.01), Move { pressure: Some(2000.0), at: 15.0, ..told(&[5], 5.0) }]),
        Ok(())
    );
    // A neighbour that goes down counts by where it goes, though both ends are within 20 mm of where it is.
    let apart = [lift(&[5], 10.0, -0.012), lift(&[6], 15.0, 0.012)];
    assert!(
        say(&apart)
            .expect_err("24 mm in the end")
            .contains("tile 7 at 15.0000 s: the supervisor refuses: the height step to a neighbour")
    );
    // Rows run from the head, y runs to it: edges meet where the lower tile leans up to the raised one.
    let slope = 0.012 / 0.142_857;
    let meet = |sign: f64| {
        let lean = Move { at: 30.0, slope: Some([0.0, sign * slope]), ..told(&[8], 20.0) };
        say(&[lift(&[4], 10.0, 0.012), lean])
    };
    assert_eq!(meet(-1.0), Ok(()));
    assert!(
        meet(1.0)
            .expect_err("24 mm")
            .contains("tile 9 at 30.0000 s: the supervisor refuses: the height step to a neighbour")
    );
}

/// Tells one move.
struct Once(Option<Move>);

impl Policy for Once {
    fn decide(&mut self, _: &View<'_>) -> Vec<Move> {
        self.0.take().into_iter().collect()
    }
}

/// A run under a policy that commands one move.
fn under(plan: &Plan, told: Move) -> Result<History, RunError> {
    let bounds = Bounds { most_low: 28, support: 0.0, ..Bounds::default() };
    run(plan, &mut Once(Some(told)), &bounds, Some(&Controller), None, |_| true)
}

#[test]
fn a_policy_that_is_denied_ends_by_name() {
    let read = plan(3, 3, "[run]\nseconds = 40\nevery = 10\n").expect("a plan");
    let high = Move { heave: Some(0.01), ..told(&(0..9).collect::<Vec<_>>(), 20.0) };
    let RunError::Refused(refusal) = under(&read.plan, high).expect_err("nine at once") else {
        panic!("not refused")
    };
    assert_eq!((refusal.tile, refusal.time), (Some(9), 10.0));
    assert!(refusal.what.contains("the supervisor refuses: as many tiles are moving"), "{refusal}");
    let some = Move { heave: Some(0.01), ..told(&[0, 1, 2, 3], 20.0) };
    assert_eq!(under(&read.plan, some).expect("let through").moves.len(), 1);
}

#[test]
fn plans_say_whether_orders_go_through_the_controller() {
    let lifted = "[[move]]\nat = 5\nover = 10\ntiles = \"all\"\nheave = \"10_mm\"\n[run]\nseconds = 20\n";
    assert!(!plan(3, 3, &format!("{lifted}supervised = false\n")).expect("a plan").is_supervised);
    for asked in ["", "supervised = true\n"] {
        let said = plan(3, 3, &format!("{lifted}{asked}")).expect_err("nine at once");
        assert!(
            said.contains("plan.toml: tile 9 at 5.0000 s: the supervisor refuses: as many tiles are moving"),
            "{said}"
        );
    }
    assert!(plan(2, 4, &format!("{lifted}supervised = true\n")).expect("eight").is_supervised);
    let policy = "[policy]\nkind = \"alternating\"\n";
    assert!(plan(3, 3, policy).expect("a plan").is_supervised);
    assert!(!plan(3, 3, &format!("{policy}[run]\nsupervised = false\n")).expect("a plan").is_supervised);
    // Another tile than the controller's.
    let other = |lines: &str| {
        let text = format!(
            "format = 1\n[bed]\nrows = 1\ncolumns = 1\ncircle = \"100_mm\"\n[load]\nshape = \"ball\"\nradius = 0.1\nmass = 1\n[run]\n{lines}"
        );
        parse("plan.toml", &text, &[]).map(drop).map_err(|e| e.to_string())
    };
    assert!(other("supervised = true\n").expect_err("another radius").contains("a `circle` of 90.0 mm"));
    assert_eq!(other("seconds = 0\n"), Ok(()));
}

#[test]
fn the_planner_finds_ways_that_are_let_through() {
    let text = "format = 1\n[bed]\nintervals = [6, 8]\npressure = \"5.5_kPa\"\n[patient]\nposture = \"side_lying\"\nmass = 85\n\
                [policy]\nkind = \"planner\"\n[run]\nseconds = 600\nevery = 10\n";
    let read = parse("plan.toml", text, &[]).expect("a plan");
    assert!(read.is_supervised);
    let history = read.run(|_| true).expect("let through");
    let goes = |told: &Move| told.heave.is_some() || told.slope.is_some();
    assert!(history.moves.iter().any(goes) && history.moves.iter().any(|told| !goes(told)));
    assert_eq!(Controller.check(&read.plan.with(&history.moves), 0.0), Ok(()));
}
