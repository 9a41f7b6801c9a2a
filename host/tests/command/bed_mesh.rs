//! Meshes as loads of a plan: the same solid in every format, refused meshes, corrupted files without a panic.

use crate::support::{file, smartbed};
use smartbed::plan::parse;
use smartbed_bed::body::Surface;
use smartbed_bed::body::mesh::MeshFault;
use std::fmt::Write as _;

/// Corners of a box of 200 x 120 x 80 mm in millimetres, and its twelve triangles.
fn cuboid() -> (Vec<[f32; 3]>, Vec<[usize; 3]>) {
    let corner = |n: usize| [0, 1, 2].map(|k| [[-100.0, -60.0, -40.0], [100.0, 60.0, 40.0]][n >> k & 1][k]);
    let quads = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    let triangles = quads.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]).collect();
    ((0..8).map(corner).collect(), triangles)
}

fn obj() -> String {
    let (corners, triangles) = cuboid();
    let mut text = String::from("mtllib none.mtl\no box\n");
    corners.iter().for_each(|[x, y, z]| text += &format!("v {x} {y} {z}\n"));
    triangles.iter().for_each(|t| text += &format!("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1));
    text
}

/// The box twice, the second one shifted by less than it is wide.
fn crossed() -> String {
    let (corners, triangles) = cuboid();
    let mut text = obj();
    corners.iter().for_each(|[x, y, z]| text += &format!("v {} {} {}\n", x + 150.0, y + 10.0, z - 10.0));
    triangles.iter().for_each(|t| text += &format!("f {} {} {}\n", t[0] + 9, t[1] + 9, t[2] + 9));
    text
}

fn stl_text() -> String {
    let (corners, triangles) = cuboid();
    let mut text = String::from("solid box\n");
    for triangle in triangles {
        text += "facet normal 0 0 0\nouter loop\n";
        triangle.map(|c| corners[c]).iter().for_each(|[x, y, z]| text += &format!("vertex {x} {y} {z}\n"));
        text += "endloop\nendfacet\n";
    }
    text + "endsolid box\n"
}

/// A binary file whose head begins as texts do.
fn stl_bytes() -> Vec<u8> {
    let (corners, triangles) = cuboid();
    let mut bytes = b"solid but binary".to_vec();
    bytes.resize(80, b' ');
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for triangle in triangles {
        let numbers = [[0.0; 3]].into_iter().chain(triangle.map(|c| corners[c])).flatten();
        bytes.extend(numbers.flat_map(f32::to_le_bytes));
        bytes.extend([0, 0]);
    }
    bytes
}

/// MSH 2.2, with a point and a line among the elements.
fn gmsh_old() -> String {
    let (corners, triangles) = cuboid();
    let mut text = String::from("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n8\n");
    corners.iter().enumerate().for_each(|(n, [x, y, z])| text += &format!("{} {x} {y} {z}\n", n + 11));
    let _ = writeln!(text, "$EndNodes\n$Elements\n{}\n1 15 2 0 1 11\n2 1 2 0 1 11 12", triangles.len() + 2);
    for (n, [a, b, c]) in triangles.iter().enumerate() {
        let _ = writeln!(text, "{} 2 2 0 1 {} {} {}", n + 3, a + 11, b + 11, c + 11);
    }
    text + "$EndElements\n"
}

/// MSH 4.1 in two blocks of nodes, one with a parameter, and one of points.
fn gmsh_new() -> String {
    let (corners, triangles) = cuboid();
    let mut text = String::from("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n2 8 1 8\n");
    for (from, parameter) in [(0, ""), (4, " 0.5")] {
        let _ = writeln!(text, "2 1 {} 4", u8::from(!parameter.is_empty()));
        (from..from + 4).for_each(|n| text += &format!("{}\n", n + 1));
        for [x, y, z] in &corners[from..from + 4] {
            let _ = writeln!(text, "{x} {y} {z}{parameter}");
        }
    }
    text += "$EndNodes\n$Elements\n2 13 1 13\n0 1 15 1\n1 1\n2 1 2 12\n";
    for (n, [a, b, c]) in triangles.iter().enumerate() {
        let _ = writeln!(text, "{} {} {} {}", n + 2, a + 1, b + 1, c + 1);
    }
    text + "$EndElements\n"
}

/// Writes a file of one test and returns its path.
fn written(name: &str, bytes: &[u8]) -> String {
    let path = file(name);
    std::fs::write(&path, bytes).expect("the test folder can be written");
    path.display().to_string()
}

/// A plan of one tile under a mesh.
fn plan(name: &str) -> String {
    format!(
        "format = 1\n[bed]\nrows = 1\ncolumns = 1\n[load]\nshape = \"mesh\"\nfile = {name:?}\nunit = \"1_mm\"\nmass = 4\n"
    )
}

/// Output for such a file.
fn said(name: &str, bytes: &[u8]) -> String {
    let path = written(name, bytes);
    let said = parse("plan.toml", &plan(&path), &[]).expect_err(name).to_string();
    let line = said.lines().next().and_then(|line| line.strip_prefix("error: ")).expect("an error");
    line.to_owned()
}

#[test]
fn a_box_is_the_same_solid_in_every_format() {
    let files: [(&str, Vec<u8>); 7] = [
        ("box.obj", obj().into_bytes()),
        ("box_joined.obj", format!("# C:\\meshes\\\n{}", obj().replace("f ", "f \\\n")).into_bytes()),
        ("box_joined_crlf.obj", obj().replace(" -", " \\\n -").replace('\n', "\r\n").into_bytes()),
        ("box_text.stl", stl_text().into_bytes()),
        ("box.stl", stl_bytes()),
        ("box_old.msh", gmsh_old().into_bytes()),
        ("box_new.msh", gmsh_new().into_bytes()),
    ];
    for (name, bytes) in files {
        let path = written(name, &bytes);
        let read = parse("plan.toml", &plan(&path), &[]).unwrap_or_else(|e| panic!("{e}"));
        let Surface::Mesh(solid) = &read.plan.load.body.segments[0].shape else { panic!("no mesh") };
        assert!((solid.volume() / 1.92e-3 - 1.0).abs() < 1e-6, "{name}: {}", solid.volume());
        for (found, half) in solid.gyration().into_iter().zip([0.1, 0.06, 0.04]) {
            assert!((found - half).abs() < 1e-7, "{name}: {found} {half}");
        }
        assert_eq!(solid.mesh().corners.len(), 8);
    }
}

#[test]
fn a_plan_with_a_mesh_runs_on_both_clocks_and_a_turned_one_lies_as_told() {
    let run = |settings: &[&str]| {
        let set: Vec<&str> = settings.iter().flat_map(|s| ["--set", s]).collect();
        let done = smartbed(&[&["bed", "run", "mesh_on_bed", "--json"], &set[..]].concat());
        assert_eq!(done.status, 0, "{done:?}");
        done.json()
    };
    let still = run(&["run.seconds=0"]);
    assert!(still["imbalance"].as_f64().expect("a number") < 1e-6 && still["valid"] == true, "{still}");
    let motion =
        run(&["run.clock=\"dynamics\"", "run.seconds=0.2", "run.every=0.1", "move=[]", "dynamics.step=4e-3"]);
    assert!(motion["imbalance"].as_f64().expect("a number") < 1e-6, "{motion}");
    // On its edge the ring touches less.
    let edge = run(&["run.seconds=0", "load.turn=[\"90_deg\", 0, 0]", "load.mass=4"]);
    let area = |json: &serde_json::Value| {
        let rows = json["sensels"].as_array().expect("rows").iter();
        let own = rows.into_iter().find(|row| row["metric"] == "contact area").expect("a row");
        own["value"].as_f64().expect("a number")
    };
    assert!(area(&edge) < 0.6 * area(&still), "{} {}", area(&edge), area(&still));
    // The page shows it.
    let page = file("mesh_page.html").display().to_string();
    let done = smartbed(&["bed", "report", "mesh_on_bed", "--set", "run.seconds=0", "-o", &page]);
    assert_eq!(done.status, 0, "{done:?}");
    assert!(std::fs::read_to_string(page).expect("a page").contains("\"segments\":[{\"corners\":["));
}

#[test]
fn a_file_whose_surface_runs_through_itself_is_refused() {
    let said = said("through.obj", crossed().as_bytes());
    assert!(said.contains("through.obj: the mesh intersects itself at ("), "{said}");
}

#[test]
fn a_broken_file_is_read_or_refused_without_a_panic() {
    let files: [(&str, Vec<u8>); 5] = [
        ("broken.obj", obj().into_bytes()),
        ("broken_text.stl", stl_text().into_bytes()),
        ("broken.stl", stl_bytes()),
        ("broken_old.msh", gmsh_old().into_bytes()),
        ("broken_new.msh", gmsh_new().into_bytes()),
    ];
    let mut state = 1_u64;
    let mut next = |most: usize| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) as usize % most
    };
    let mut refused = 0;
    for (name, bytes) in &files {
        for _ in 0..200 {
            let mut broken = bytes.clone();
            match next(3) {
                0 => broken.truncate(next(bytes.len())),
                1 => {
                    let from = next(bytes.len());
                    broken.drain(from..(from + 1 + next(40)).min(bytes.len()));
                }
                _ => (0..4).for_each(|_| broken[next(bytes.len())] = b"0123456789 -.enf\n$\xff"[next(19)]),
            }
            let path = written(name, &broken);
            refused += usize::from(parse("plan.toml", &plan(&path), &[]).is_err());
        }
    }
    assert!(refused > 300, "{refused}");
}

/// Everything that is said of a mesh that is refused.
pub fn refusals() -> Vec<String> {
    let place = [0.0, 0.1, 0.2];
    let faults = [
        MeshFault::Empty,
        MeshFault::TooMany(1_000_000),
        MeshFault::NotFinite(3),
        MeshFault::NoCorner(3),
        MeshFault::Size(200.0),
        MeshFault::Flat(place),
        MeshFault::Open(3, place),
        MeshFault::NotManifold(3, place),
        MeshFault::Turned(place),
        MeshFault::Pinched(place),
        MeshFault::Crossed(place),
        MeshFault::InsideOut(place),
        MeshFault::Hollow(0.0),
    ];
    let mut found: Vec<String> = faults.iter().map(|fault| format!("box.obj: {fault}")).collect();
    let quad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    let [old, new] = [gmsh_old(), gmsh_new()];
    found.extend([
        said("mesh.ply", b"ply"),
        said("quad.obj", quad.as_bytes()),
        said("letters.obj", b"v one two three\n"),
        said("short.stl", &stl_bytes()[..300]),
        said("crossed.obj", crossed().as_bytes()),
        said("hole.obj", obj().replace("f 1 5 7\n", "").as_bytes()),
        said("binary.msh", old.replace("2.2 0 8", "2.2 1 8").as_bytes()),
        said("bytes.msh", &[0xff, 0xfe]),
        said("first.msh", old.replace("2.2 0 8", "1 0 8").as_bytes()),
        said("none.msh", b"$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"),
        said("early.msh", new.replace("2 8 1 8", "3 8 1 8").as_bytes()),
        said("no_node.msh", old.replace("\n18 ", "\n28 ").as_bytes()),
        said("quads.msh", old.replace("3 2 2 0 1", "3 3 2 0 1").as_bytes()),
        said("bent.msh", old.replace("3 2 2 0 1", "3 9 2 0 1").as_bytes()),
    ]);
    let missing = parse("plan.toml", &plan("not_there.stl"), &[]).expect_err("no file").to_string();
    found.push(
        missing.lines().next().and_then(|line| line.strip_prefix("error: ")).expect("an error").to_owned(),
    );
    found
}
