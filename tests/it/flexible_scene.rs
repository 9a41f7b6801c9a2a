//! Reading scenes: every scene of the repository, the reference files, and messages that say where and what.

use smartbed::file_kind::FileKind;
use smartbed::scene::{parse, shape};

fn refused(text: &str) -> String {
    parse("cube.toml", text, &[]).expect_err("refused")
}

#[test]
fn every_scene_reads_damped_and_undamped() {
    let folder = format!("{}/../models/scenes", env!("CARGO_MANIFEST_DIR"));
    let mut names = Vec::new();
    for entry in std::fs::read_dir(folder).expect("scenes") {
        let path = entry.expect("entry").path();
        let text = std::fs::read_to_string(&path).expect("text");
        // Worlds have a format, and tests, of their own.
        if FileKind::of_text(&text) == FileKind::World {
            continue;
        }
        let name = path.display().to_string();
        for settings in [vec![], vec!["C=10".to_string()]] {
            let scene = parse(&name, &text, &settings).unwrap_or_else(|e| panic!("{e}"));
            assert!(scene.largest_step.is_some_and(|h| scene.step <= h), "{name}");
        }
        names.push(name);
    }
    assert!(names.len() >= 13, "{names:?}");
}

#[test]
fn a_mistake_is_named_with_its_line() {
    let message = refused("format = 1\nshape = \"cube\"\nK = \"stiff\"\n");
    assert!(message.starts_with("cube.toml:3: `K`: expected a number"), "{message}");
    let message = refused("format = 1\nshape = \"cube\"\nstifness = 3.0\n");
    assert!(message.starts_with("cube.toml:3: `stifness`: unknown key"), "{message}");
    let message = refused("format = 1\nshape = \"cubus\"\n");
    assert!(
        message.contains("cube.toml:2: `shape`: unknown shape `cubus`; did you mean `cubes`?"),
        "{message}"
    );
    let message = refused("format = 1\nshape = \n");
    assert!(message.starts_with("cube.toml:2: "), "{message}");
    let message = refused("format = 1\npoints = [[0,0,0]]\nsprings = [[0,7]]\n");
    assert!(message.contains("cube.toml:3: `springs`: spring 0 joins 0 and 7"), "{message}");
    let message = parse("cube.toml", "format = 1\nshape = \"cube\"\n", &["D=3".to_string()]).expect_err("D");
    assert!(message.starts_with("--set D=3: unknown key"), "{message}");
}

#[test]
fn a_step_beyond_the_stable_one_is_refused_with_the_formula() {
    // Two unit masses and one spring: A = K, so K stands for K/2 and h_max = sqrt(2 m/K).
    let text = "format = 1\nshape = \"chain\"\nstep = 0.021\nT = 0.1\n";
    let message = refused(text);
    assert!(
        message.contains("cube.toml:3: `step`") && message.contains("(sqrt(C^2 + K m) - C)/K"),
        "{message}"
    );
    assert!(message.contains("2.000000e-2"), "{message}");
    assert!(parse("chain", &format!("{text}allow_unstable = true\n"), &[]).is_ok());
    // The square grid: (sqrt(C^2 + K m) - C)/K to the last digit that matters.
    let sheet = "format = 1\nshape = \"sheet\"\nlaw = \"none\"\nK = 5000.0\nC = 10.0\n";
    let scene = parse("sheet", sheet, &[]).expect("scene");
    let formula = ((100.0_f64 + 5000.0).sqrt() - 10.0) / 5000.0;
    assert!((scene.largest_step.expect("springs") / formula - 1.0).abs() <= 1e-9);
}

#[test]
fn shapes_have_the_counts_of_the_thesis() {
    let counts = |body: &smartbed::scene::Lists| (body.points.len(), body.springs.len());
    assert_eq!(counts(&shape::cube(1.0)), (8, 28));
    assert_eq!(counts(&shape::truss(2, 1.0)), (5, 7));
    let sheet = shape::sheet(27, 27, 1.4, 1.4);
    assert_eq!(sheet.fixed.iter().filter(|f| !**f).count(), 729);
    assert_eq!(sheet.fixed.iter().filter(|f| **f).count(), 4 * 27);
    assert_eq!(sheet.springs.len(), 1512);
    // One cube with a centre: 28 pairs and 8 spokes; two of them share a face of 6 pairs.
    assert_eq!(counts(&shape::cubes(1, 1, 1, 1.0)), (9, 36));
    assert_eq!(counts(&shape::cubes(2, 1, 1, 1.0)), (14, 66));
}

/// A sheet's forces are computed row by row and equal those of its lists; a body that is not a sheet is not taken for
/// one.
#[test]
fn a_sheet_is_a_grid() {
    use smartbed::scene::grid::Woven;
    use smartbed::scene::simulation::Simulation;
    let scene = |rows: usize, columns: usize| {
        let text = format!(
            "format = 1\nshape = \"sheet\"\nlaw = \"none\"\nrows = {rows}\ncolumns = {columns}\nK = 5000.0\npressure = 4000.0\n"
        );
        parse("sheet", &text, &[]).expect("scene")
    };
    for (rows, columns) in [(1, 10), (5, 13), (27, 27), (3, 70)] {
        let scene = scene(rows, columns);
        assert!(Woven::<f64>::new(&scene.lists, [0; 3]).is_some(), "{rows} x {columns}");
        let mut listed = scene.lists.clone();
        listed.table = None;
        let run = |lists: &smartbed::scene::Lists| {
            let mut motion = Simulation::<f64>::new(lists, &scene.around, scene.method).expect("body");
            motion.begin(1e-3, &mut ()).expect("a start");
            (0..50).for_each(|_| {
                motion.step(1e-3, &mut ()).expect("a step");
            });
            motion.pos().to_vec()
        };
        assert_eq!(run(&scene.lists), run(&listed), "{rows} x {columns}");
        let mut crossed = scene.lists.clone();
        let last = crossed.points.len() - 1;
        crossed.spring(0, last);
        crossed.stiffness.push(1.0);
        crossed.damping.push(0.0);
        assert!(Woven::<f64>::new(&crossed, [0; 3]).is_none());
    }
    // Rows of 11 nodes, their frame among them, are faster as lists.
    assert!(Woven::<f64>::new(&scene(20, 9).lists, [0; 3]).is_none());
    assert!(Woven::<f64>::new(&shape::cube(1.0), [0; 3]).is_none());
}
