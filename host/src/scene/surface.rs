//! Surfaces of facets: where they are open.
//!
//! In: the facets of a body. Out: its boundary edges; a closed surface has none, and only such a one encloses a volume
//! that does not depend on where the body stands.

use std::collections::BTreeMap;

/// Boundary edges: edges of facets that no other facet has in the opposite direction, from each node to the next.
#[must_use]
pub fn open_edges(facets: &[[usize; 4]]) -> BTreeMap<usize, usize> {
    let edges = || {
        let around = facets.iter().flat_map(|[a, b, c, d]| [(*a, *b), (*b, *c), (*c, *d), (*d, *a)]);
        around.filter(|(from, to)| from != to)
    };
    // The edges of each node to higher ones, one node after the other: sorted by counting, in linear time. An edge is
    // its higher node with a bit that says whether it rises to that; few bytes, because most of the time goes to memory.
    let packed = |(from, to): (usize, usize)| (from.max(to) as u64) << 1 | u64::from(from < to);
    let nodes = facets.iter().flatten().max().map_or(0, |last| last + 1);
    let mut ends = vec![0; nodes + 1];
    edges().for_each(|(from, to)| ends[from.min(to) + 1] += 1);
    for node in 0..nodes {
        ends[node + 1] += ends[node];
    }
    let mut upwards = vec![0; ends[nodes]];
    for (from, to) in edges() {
        let place = &mut ends[from.min(to)];
        upwards[*place] = packed((from, to));
        *place += 1;
    }
    let (mut open, mut first) = (BTreeMap::new(), 0);
    for (low, end) in ends.iter().copied().enumerate().take(nodes) {
        let of_node = &mut upwards[first..end];
        of_node.sort_unstable();
        for alike in of_node.chunk_by(|one, other| one >> 1 == other >> 1) {
            let high = (alike[0] >> 1) as usize;
            let rising = alike.iter().filter(|edge| *edge & 1 == 1).count();
            let falling = alike.len() - rising;
            if rising != falling {
                open.extend((rising > 0).then_some((low, high)));
                open.extend((falling > 0).then_some((high, low)));
            }
        }
        first = end;
    }
    open
}
