//! A bounding volume hierarchy (boxes) over the triangles of a mesh.
//!
//! In: a mesh. Out: the tree, bisected down to a few triangles per leaf, and the triangles whose boxes overlap a box.

use super::triangles::Mesh;
use smartbed_runtime::vec3::{Vec3, dot};

/// Largest number of triangles in a leaf.
const LEAF: usize = 4;

/// Boxes; the first one is that of the whole mesh.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Tree {
    pub nodes: Vec<Node>,
    /// Triangles in the order of the leaves.
    order: Vec<usize>,
}

/// A box and its contents.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Node {
    low: Vec3<f64>,
    high: Vec3<f64>,
    /// Index of its first triangle in `order`.
    first: usize,
    count: usize,
    /// Index of the second half (the first half follows the node itself); 0 for a leaf.
    second: usize,
}

impl Tree {
    /// The tree of a mesh with at least one triangle.
    pub fn new(mesh: &Mesh) -> Tree {
        let mut order: Vec<usize> = (0..mesh.triangles.len()).collect();
        let mut nodes = Vec::new();
        grow(mesh, &mut order, 0, &mut nodes);
        Tree { nodes, order }
    }

    /// The two halves of a box; `None` for a leaf.
    pub fn halves(&self, node: usize) -> Option<[usize; 2]> {
        let second = self.nodes[node].second;
        (second > 0).then_some([node + 1, second])
    }

    /// Triangles in a box.
    pub fn triangles(&self, node: usize) -> &[usize] {
        let Node { first, count, .. } = self.nodes[node];
        &self.order[first..first + count]
    }

    /// Triangles in leaves that overlap a box.
    pub fn overlapping(&self, [low, high]: [Vec3<f64>; 2]) -> impl Iterator<Item = usize> {
        let (mut waiting, mut leaf) = (vec![0], &[][..]);
        std::iter::from_fn(move || {
            while leaf.is_empty() {
                let node = waiting.pop()?;
                let own = &self.nodes[node];
                if (0..3).any(|k| own.low[k] > high[k] || own.high[k] < low[k]) {
                    continue;
                }
                match self.halves(node) {
                    Some(halves) => waiting.extend(halves),
                    None => leaf = self.triangles(node),
                }
            }
            let (first, rest) = leaf.split_first()?;
            leaf = rest;
            Some(*first)
        })
    }
}

impl Node {
    /// Squared distance of a point from the box.
    pub fn square(&self, point: Vec3<f64>) -> f64 {
        let beyond = [0, 1, 2].map(|k| point[k] - point[k].clamp(self.low[k], self.high[k]));
        dot(beyond, beyond)
    }
}

/// Adds the tree of these triangles, bisected along the longest side of the box around their centroids.
fn grow(mesh: &Mesh, order: &mut [usize], first: usize, nodes: &mut Vec<Node>) {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    let (mut least, mut most) = (low, high);
    let middle = |triangle: usize, k: usize| mesh.places(triangle).iter().map(|p| p[k]).sum::<f64>();
    for triangle in order.iter() {
        for k in 0..3 {
            for place in mesh.places(*triangle) {
                (low[k], high[k]) = (low[k].min(place[k]), high[k].max(place[k]));
            }
            let own = middle(*triangle, k);
            (least[k], most[k]) = (least[k].min(own), most[k].max(own));
        }
    }
    let index = nodes.len();
    nodes.push(Node { low, high, first, count: order.len(), second: 0 });
    if order.len() <= LEAF {
        return;
    }
    let side = |k: usize| most[k] - least[k];
    let axis = (1..3).fold(0, |best, k| if side(k) > side(best) { k } else { best });
    let half = order.len() / 2;
    order.select_nth_unstable_by(half, |a, b| middle(*a, axis).total_cmp(&middle(*b, axis)).then(a.cmp(b)));
    let (one, other) = order.split_at_mut(half);
    grow(mesh, one, first, nodes);
    nodes[index].second = nodes.len();
    grow(mesh, other, first + half, nodes);
}
