//! Nodes and corners that pass behind a facet from outside, and bodies that slide over facets while these bend.

use super::support::{json, number, rows, scene};

/// A free plate of one facet that looks up, and a part that flies below its free edge.
fn plate_and(part: &str, law: &str, run: &str) -> String {
    format!(
        "format = 2\ngravity = [0, 0, 0]\n[parts.plate]\npoints = [[0, 0, 0], [0.3, 0, 0], [0.1, 0.25, 0]]\n\
         springs = [[0, 1], [1, 2], [2, 0]]\nfacets = [[0, 1, 2, 2]]\nmass = 1\nK = 1000\n[parts.flier]\n{part}\n\
         [[contacts]]\nbetween = [\"flier\", \"plate\"]\nimpact = {law}\n[run]\nseconds = 0.06\nstep = 1e-4\n{run}\n"
    )
}

/// Runs it and says by how much the part is off a straight line, and how many events there were.
fn off_line(name: &str, text: &str, ends: [(&str, f64); 3]) -> (f64, usize) {
    let done = json(&[&scene(name, text)]);
    let off = ends.iter().map(|(column, end)| (number(&done["last"][column]) - end).abs());
    (off.fold(0.0, f64::max), done["events"].as_array().expect("a list").len())
}

/// It was caught from behind, up to 12 mm below the facet, by an impulse that turned a free pair.
#[test]
fn what_passes_behind_a_free_edge_flies_on() {
    let laws = [
        ("\"plastic\"\nfriction = 0.3", ""),
        ("\"stronge\"\nrestitution = 0.5\nfriction = 0.3", "method = \"verlet\""),
        ("\"newton\"\nrestitution = 0.5", ""),
        ("\"compensation\"\nfriction = 0.3", ""),
        ("\"moreau\"\nfriction = 0.3", ""),
        ("\"moreau\"\nrestitution = 0.5", "method = \"energy_momentum\""),
    ];
    for (law, run) in laws {
        for (sinks, depth) in [(-0.3, 0.005), (-0.3, 0.012), (-0.05, 0.002), (0.3, 0.02), (0.3, 0.005)] {
            // At t = 0.025 s it is below the edge.
            let z = -depth - 0.025 * sinks;
            let ends = [0.12, -0.05 + 2.0 * 0.06, z + sinks * 0.06];
            let start = format!("start = {{ velocity = [0, 2, {sinks}] }}");
            let node = format!("points = [[0.12, -0.05, {z}]]\nsprings = []\nmass = 0.1\n{start}");
            let (off, events) = off_line(
                "node",
                &plate_and(&node, law, run),
                [("flier.x0", ends[0]), ("flier.y0", ends[1]), ("flier.z0", ends[2])],
            );
            assert!(off < 1e-12 && events == 0, "{law}, {sinks}, {depth}: {off:e}, {events} events");
        }
        // The upper front edge of a box, below that of the plate.
        let corner = "rigid = \"box\"\nsize = [0.02, 0.02, 0.02]\nmass = 0.1\n\
                      start = { position = [0.12, -0.06, -0.01], velocity = [0, 2, -0.3] }";
        let (off, events) = off_line(
            "corner",
            &plate_and(corner, law, run),
            [("flier.x", 0.12), ("flier.y", 0.06), ("flier.z", -0.028)],
        );
        assert!(off < 1e-12 && events == 0, "{law}, corner: {off:e}, {events} events");
    }
}

/// From in front, at the same speeds, it strikes the facet however near to the free edge.
#[test]
fn what_comes_from_in_front_strikes_near_a_free_edge() {
    for law in ["\"plastic\"", "\"newton\"\nrestitution = 0.5", "\"moreau\""] {
        for past in [0.001, 0.01, 0.1] {
            let (y, z) = (past - 0.025 * 2.0, 0.025 * 0.3);
            let node = format!(
                "points = [[0.12, {y}, {z}]]\nsprings = []\nmass = 0.1\nstart = {{ velocity = [0, 2, -0.3] }}"
            );
            let done = json(&[&scene("in_front", &plate_and(&node, law, ""))]);
            let times: Vec<f64> =
                done["events"].as_array().expect("a list").iter().map(|e| number(&e["time"])).collect();
            let found = times.first().is_some_and(|time| (time - 0.025).abs() < 2e-4);
            assert!(found, "{law}, {past} m past the edge: {times:?}");
        }
    }
}

/// Numbers between -1 and 1 (SplitMix64).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let x = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let x = (x ^ (x >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((x ^ (x >> 31)) >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn vector(&mut self) -> [f64; 3] {
        [(); 3].map(|()| self.next())
    }

    /// A prism with three sides, or a tetrahedron, turned at random about its middle: points, springs, facets.
    fn body(&mut self, sides: usize, at: [f64; 3]) -> String {
        let (points, facets): (&[[f64; 3]], &str) = if sides == 3 {
            let prism = &[
                [-0.1, -0.06, -0.08],
                [0.1, -0.06, -0.08],
                [0.0, 0.11, -0.08],
                [-0.1, -0.06, 0.07],
                [0.1, -0.06, 0.07],
                [0.0, 0.11, 0.07],
            ];
            (prism, "[[0, 2, 1, 1], [3, 4, 5, 5], [0, 1, 4, 3], [1, 2, 5, 4], [2, 0, 3, 5]]")
        } else {
            let tetrahedron =
                &[[-0.1, -0.06, -0.04], [0.1, -0.06, -0.04], [0.0, 0.11, -0.04], [0.0, 0.0, 0.12]];
            (tetrahedron, "[[0, 2, 1, 1], [0, 1, 3, 3], [1, 2, 3, 3], [2, 0, 3, 3]]")
        };
        let [[w, x], [y, z]] = [(); 2].map(|()| [self.next(), self.next()]);
        let square = w * w + x * x + y * y + z * z;
        let turned = |p: &[f64; 3]| {
            let a = [
                y * p[2] - z * p[1] + w * p[0],
                z * p[0] - x * p[2] + w * p[1],
                x * p[1] - y * p[0] + w * p[2],
            ];
            let b = [y * a[2] - z * a[1], z * a[0] - x * a[2], x * a[1] - y * a[0]];
            [0, 1, 2].map(|i| at[i] + p[i] + 2.0 * b[i] / square)
        };
        let places: Vec<[f64; 3]> = points.iter().map(turned).collect();
        let springs: Vec<[usize; 2]> = (0..places.len()).flat_map(|i| (0..i).map(move |j| [i, j])).collect();
        format!("points = {places:?}\nsprings = {springs:?}\nfacets = {facets}\n")
    }
}

/// Masses of the nodes of both bodies, and a scene in which the second flies at the first.
fn pair(numbers: &mut Numbers, sides: usize, law: &str) -> ([f64; 2], String) {
    let way = numbers.vector();
    let far = way.iter().map(|x| x * x).sum::<f64>().sqrt();
    let way = way.map(|x| x / far);
    let shift = numbers.vector().map(|x| 0.03 * x);
    let (a, b) =
        (numbers.body(3, [0.0; 3]), numbers.body(sides, [0, 1, 2].map(|i| 0.33 * way[i] + shift[i])));
    let speed = 1.5 + numbers.next();
    let [m, n] = [(); 2].map(|()| 10_f64.powf(0.75 * numbers.next()));
    let [k, l] = [(); 2].map(|()| 10_f64.powf(2.5 + numbers.next()));
    let velocity = way.map(|x| -speed * x);
    let text = format!(
        "format = 2\ngravity = [0, 0, 0]\n[parts.a]\n{a}mass = {m}\nK = {k}\n[parts.b]\n{b}mass = {n}\nK = {l}\n\
         start = {{ velocity = {velocity:?} }}\n[[contacts]]\nbetween = [\"a\", \"b\"]\nimpact = {law}\n\
         [run]\nseconds = 0.4\nstep = 1e-4\n"
    );
    ([m, n], text)
}

/// Where a facet that is slid over flattened, its contact was moved onto it, step by step, with energy from nothing:
/// up to 1e-3 of it, however small the step.
#[test]
fn bodies_that_slide_over_facets_keep_their_energy() {
    let mut numbers = Numbers(7);
    let mut longest = 0.0_f64;
    for case in 0..24 {
        let law = ["\"plastic\"", "\"newton\"", "\"compensation\""][case % 3];
        let (_, text) = pair(&mut numbers, 3 + case % 2, law);
        let done = json(&[&scene(&format!("pair_{case}"), &text), "--every", "20"]);
        let (imbalance, energy) = (number(&done["imbalance"]), number(&done["last"]["total"]));
        assert!(imbalance.abs() < 3e-6 * energy, "{case}, {law}: {imbalance:e} of {energy} J\n{text}");
        longest = longest.max(imbalance.abs() / energy);
    }
    println!("largest imbalance, relative to the energy: {longest:e}");
}

/// sum m x_k x x_k+1 / h, which the leapfrog with central forces keeps exactly, and sum |m x v|.
fn angular_momentum(names: &[String], [now, next]: [&[f64]; 2], masses: [f64; 2]) -> ([f64; 3], f64) {
    let (mut sum, mut size) = ([0.0; 3], 0.0);
    let h = next[0] - now[0];
    for (body, mass) in ["a", "b"].iter().zip(masses) {
        for node in 0.. {
            let column = |axis| names.iter().position(|name| *name == format!("{body}.{axis}{node}"));
            let Some(columns) = column("x").zip(column("y")).zip(column("z")) else { break };
            let ((x, y), z) = columns;
            let [p, q] = [now, next].map(|row| [row[x], row[y], row[z]]);
            let cross = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
            for (sum, one) in sum.iter_mut().zip(cross) {
                *sum += mass * one / h;
            }
            size += mass * cross.iter().map(|x| x * x).sum::<f64>().sqrt() / h;
        }
    }
    (sum, size)
}

/// A contact may be off its facet by the facet's bulge; friction had that distance as its arm: up to 1 % of the angular
/// momentum came from nothing, however small the step.
#[test]
fn friction_over_facets_leaves_no_moment() {
    let mut numbers = Numbers(11);
    let (mut largest, mut rubbed) = (0.0_f64, 0);
    for case in 0..16 {
        let law = ["\"plastic\"", "\"stronge\"\nrestitution = 0.5", "\"compensation\""][case % 3];
        let (masses, text) = pair(&mut numbers, 3 + case % 2, &format!("{law}\nfriction = 0.3"));
        let (names, rows) = rows(&[&scene(&format!("rubbed_{case}"), &text), "--method", "verlet"]);
        let [start, second, .., last_but_one, end] = &rows[..] else { panic!("four rows") };
        let ends = [[&start[..], second], [&last_but_one[..], end]];
        let [(before, size), (after, _)] = ends.map(|pair| angular_momentum(&names, pair, masses));
        let change = (0..3).map(|i| (after[i] - before[i]).abs()).fold(0.0, f64::max) / size;
        assert!(change < 3e-8, "{case}, {law}: {change:e}\n{text}");
        let friction = names.iter().position(|name| name == "friction").expect("a column");
        (largest, rubbed) = (largest.max(change), rubbed + usize::from(end[friction] > 1e-3 * end[1]));
    }
    assert!(rubbed >= 8, "friction took something in {rubbed} of 16");
    println!("largest change of angular momentum, relative to its parts: {largest:e}");
}
