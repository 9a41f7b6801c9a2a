//! Surfaces of facets: where they are open.
//!
//! In: the facets of a body. Out: its boundary edges; a closed surface has none, and only such a one encloses a volume
//! that does not depend on where the body stands.

use std::collections::BTreeMap;

/// Boundary edges: edges of facets that no other facet has in the opposite direction, from each node to the next.
#[must_use]
pub fn open_edges(facets: &[[usize; 4]]) -> BTreeMap<usize, usize> {
    // Edges by their ends, whatever their direction, so that those of two neighbours are adjacent after sorting. Each
    // edge is one number (lower node, higher node, direction), because numbers are sorted four times as fast as tuples.
    const NODE: u32 = 31;
    let mut edges = Vec::with_capacity(4 * facets.len());
    for [a, b, c, d] in facets.iter().copied() {
        for (from, to) in [(a, b), (b, c), (c, d), (d, a)] {
            if from != to {
                let (low, high) = (from.min(to) as u64, from.max(to) as u64);
                edges.push((low << NODE | high) << 1 | u64::from(from < to));
            }
        }
    }
    edges.sort_unstable();
    let mut open = BTreeMap::new();
    for alike in edges.chunk_by(|one, other| one >> 1 == other >> 1) {
        let ends = alike[0] >> 1;
        let (low, high) = ((ends >> NODE) as usize, (ends & ((1 << NODE) - 1)) as usize);
        let rising = alike.iter().filter(|edge| *edge & 1 == 1).count();
        let falling = alike.len() - rising;
        if rising != falling {
            open.extend((rising > 0).then_some((low, high)));
            open.extend((falling > 0).then_some((high, low)));
        }
    }
    open
}
