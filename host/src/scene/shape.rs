//! The bodies of the thesis (chapters 3 and 5) as lists: lowest point at z = 0, springs at rest length, unit masses.

use std::f64::consts::PI;

use super::lists::{Lists, Table};

/// Vertical chain of `links` springs of one length.
#[must_use]
pub fn chain(links: usize, length: f64) -> Lists {
    let mut body = Lists::default();
    for i in 0..=links {
        body.point([0.0, 0.0, i as f64 * length]);
        if i > 0 {
            body.spring(i - 1, i);
        }
    }
    body
}

/// Regular polygon of `corners` springs of length `side` in the plane y = 0, with one corner lowest; 3 is the closed
/// loop of section 3.4.
#[must_use]
pub fn polygon(corners: usize, side: f64) -> Lists {
    let mut body = Lists::default();
    let radius = side / (2.0 * (PI / corners as f64).sin());
    for i in 0..corners {
        let angle = 2.0 * PI * i as f64 / corners as f64;
        body.point([radius * angle.sin(), 0.0, radius * (1.0 - angle.cos())]);
    }
    for i in 0..corners {
        body.spring(i, (i + 1) % corners);
    }
    body
}

/// Planar truss of equilateral triangles on `bays` lower bars (Fig. 5.4): bays + 1 points below, bays above.
#[must_use]
pub fn truss(bays: usize, side: f64) -> Lists {
    let mut body = Lists::default();
    let height = side * 3.0_f64.sqrt() / 2.0;
    let lower: Vec<usize> = (0..=bays).map(|i| body.point([i as f64 * side, 0.0, 0.0])).collect();
    let upper: Vec<usize> = (0..bays).map(|i| body.point([(i as f64 + 0.5) * side, 0.0, height])).collect();
    lower.windows(2).for_each(|w| body.spring(w[0], w[1]));
    upper.windows(2).for_each(|w| body.spring(w[0], w[1]));
    for i in 0..bays {
        body.spring(lower[i], upper[i]);
        body.spring(lower[i + 1], upper[i]);
    }
    body
}

/// Triangular prism standing on a triangle: all 15 pairs of corners connected.
#[must_use]
pub fn prism(side: f64, height: f64) -> Lists {
    let mut body = Lists::default();
    let triangle = [[0.0, 0.0], [side, 0.0], [side / 2.0, side * 3.0_f64.sqrt() / 2.0]];
    for z in [0.0, height] {
        triangle.iter().for_each(|p| {
            body.point([p[0], p[1], z]);
        });
    }
    body.join_all(&[0, 1, 2, 3, 4, 5]);
    body.facets = vec![[0, 2, 1, 1], [3, 4, 5, 5], [0, 1, 4, 3], [1, 2, 5, 4], [2, 0, 3, 5]];
    body
}

/// Cube with all 28 pairs of its corners connected.
#[must_use]
pub fn cube(side: f64) -> Lists {
    let mut body = Lists::default();
    for z in [0.0, side] {
        for (x, y) in [(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)] {
            body.point([x, y, z]);
        }
    }
    body.join_all(&[0, 1, 2, 3, 4, 5, 6, 7]);
    body.facets = vec![[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];
    body
}

/// Upright cylinder: `rings` + 1 rings of `corners` points; springs along rings, upright and crossed.
#[must_use]
pub fn cylinder(corners: usize, rings: usize, radius: f64, height: f64) -> Lists {
    let mut body = Lists::default();
    for ring in 0..=rings {
        for i in 0..corners {
            let angle = 2.0 * PI * i as f64 / corners as f64;
            let z = height * ring as f64 / rings as f64;
            body.point([radius * angle.cos(), radius * angle.sin(), z]);
        }
    }
    let at = |ring: usize, i: usize| ring * corners + i % corners;
    for ring in 0..=rings {
        for i in 0..corners {
            body.spring(at(ring, i), at(ring, i + 1));
            // A spring across the ring keeps it round.
            if corners.is_multiple_of(2) && i < corners / 2 {
                body.spring(at(ring, i), at(ring, i + corners / 2));
            }
            if ring < rings {
                body.spring(at(ring, i), at(ring + 1, i));
                body.spring(at(ring, i), at(ring + 1, i + 1));
                body.spring(at(ring, i + 1), at(ring + 1, i));
                body.facets.push([at(ring, i), at(ring, i + 1), at(ring + 1, i + 1), at(ring + 1, i)]);
            }
        }
    }
    body
}

/// Ball: poles and `bands` - 1 circles of `corners` points; springs along edges, crossed diagonals, and to a point in
/// the centre.
#[must_use]
pub fn ball(corners: usize, bands: usize, radius: f64) -> Lists {
    let mut body = Lists::default();
    let south = body.point([0.0, 0.0, 0.0]);
    for band in 1..bands {
        let latitude = PI * band as f64 / bands as f64;
        for i in 0..corners {
            let angle = 2.0 * PI * i as f64 / corners as f64;
            let r = radius * latitude.sin();
            body.point([r * angle.cos(), r * angle.sin(), radius * (1.0 - latitude.cos())]);
        }
    }
    let north = body.point([0.0, 0.0, 2.0 * radius]);
    let at = |band: usize, i: usize| 1 + (band - 1) * corners + i % corners;
    for i in 0..corners {
        body.spring(south, at(1, i));
        body.facets.push([south, at(1, i + 1), at(1, i), at(1, i)]);
    }
    for band in 1..bands {
        for i in 0..corners {
            body.spring(at(band, i), at(band, i + 1));
            if band + 1 < bands {
                body.spring(at(band, i), at(band + 1, i));
                body.spring(at(band, i), at(band + 1, i + 1));
                body.spring(at(band, i + 1), at(band + 1, i));
                body.facets.push([at(band, i), at(band, i + 1), at(band + 1, i + 1), at(band + 1, i)]);
            }
        }
    }
    for i in 0..corners {
        body.spring(at(bands - 1, i), north);
        body.facets.push([north, at(bands - 1, i), at(bands - 1, i + 1), at(bands - 1, i + 1)]);
    }
    let surface = body.points.len();
    body.first_centre = Some(surface);
    let centre = body.point([0.0, 0.0, radius]);
    (0..surface).for_each(|i| body.spring(i, centre));
    body
}

/// n x m x k cubes sharing corners, each with a mass in its centre connected to its 8 corners (thesis 5.9).
#[must_use]
pub fn cubes(n: usize, m: usize, k: usize, side: f64) -> Lists {
    let mut body = Lists::default();
    let at = |x: usize, y: usize, z: usize| (z * (m + 1) + y) * (n + 1) + x;
    for z in 0..=k {
        for y in 0..=m {
            for x in 0..=n {
                body.point([x as f64 * side, y as f64 * side, z as f64 * side]);
            }
        }
    }
    body.first_centre = Some(body.points.len());
    let mut joined = std::collections::BTreeSet::new();
    for z in 0..k {
        for y in 0..m {
            for x in 0..n {
                let corners: Vec<usize> =
                    (0..8).map(|c| at(x + (c & 1), y + ((c >> 1) & 1), z + (c >> 2))).collect();
                for (i, a) in corners.iter().enumerate() {
                    for b in &corners[i + 1..] {
                        if joined.insert([*a, *b]) {
                            body.spring(*a, *b);
                        }
                    }
                }
                let half = side / 2.0;
                let [cx, cy, cz] = [x, y, z].map(|c| c as f64 * side + half);
                let centre = body.point([cx, cy, cz]);
                corners.iter().for_each(|c| body.spring(*c, centre));
            }
        }
    }
    body
}

/// Sheet of `rows` chains of `columns` points in a frame: both ends of every chain are anchored (thesis 3.6).
///
/// 27 x 27 gives 729 masses, 1512 springs and 4 x 27 anchors. Facets cover the frame, but only the inner half of its
/// four corner cells.
#[must_use]
pub fn sheet(rows: usize, columns: usize, width: f64, depth: f64) -> Lists {
    let mut body = Lists::default();
    let (dx, dy) = (width / (columns + 1) as f64, depth / (rows + 1) as f64);
    // Index by row and column of the frame, whose corners have no points.
    let place = |r: usize, c: usize| r * (columns + 2) + c;
    let mut number = vec![None; (rows + 2) * (columns + 2)];
    for r in 1..=rows {
        for c in 1..=columns {
            number[place(r, c)] = Some(body.point([c as f64 * dx, r as f64 * dy, 0.0]));
        }
    }
    for r in 0..=rows + 1 {
        for c in 0..=columns + 1 {
            let (edge_r, edge_c) = (r == 0 || r > rows, c == 0 || c > columns);
            if edge_r != edge_c {
                let anchor = body.point([c as f64 * dx, r as f64 * dy, 0.0]);
                body.fixed[anchor] = true;
                number[place(r, c)] = Some(anchor);
            }
        }
    }
    let mut join = |one: usize, other: usize| {
        if let (Some(one), Some(other)) = (number[one], number[other]) {
            body.spring(one, other);
        }
    };
    for r in 1..=rows {
        (0..=columns).for_each(|c| join(place(r, c), place(r, c + 1)));
    }
    for c in 1..=columns {
        (0..=rows).for_each(|r| join(place(r, c), place(r + 1, c)));
    }
    let mut corners_of_frame = Vec::new();
    for r in 0..=rows {
        for c in 0..=columns {
            let cell = [(r, c), (r, c + 1), (r + 1, c + 1), (r + 1, c)];
            let mut corners = cell.iter().filter_map(|(r, c)| number[place(*r, *c)]);
            let found = [(); 4].map(|()| corners.next());
            match found {
                [Some(a), Some(b), Some(c), Some(d)] => body.facets.push([a, b, c, d]),
                // A corner cell: the triangle between the anchors, so that the surface's edge does not move.
                [Some(a), Some(b), Some(c), None] => corners_of_frame.push([a, b, c, c]),
                _ => {}
            }
        }
    }
    body.facets.append(&mut corners_of_frame);
    body.table = Some(Table { columns: columns + 2, nodes: number });
    body
}

/// Elastic bar of `elements` springs standing on z = 0, lumped: E A/dx, rho A dx, half of it at the ends.
#[must_use]
pub fn bar(elements: usize, length: f64, modulus: f64, density: f64, area: f64) -> Lists {
    let dx = length / elements as f64;
    let mut body = chain(elements, dx);
    body.masses = vec![density * area * dx; elements + 1];
    body.masses[0] *= 0.5;
    body.masses[elements] *= 0.5;
    body.stiffness = vec![modulus * area / dx; elements];
    body
}
