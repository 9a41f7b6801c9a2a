//! Band matrices against the full matrices they represent.

use smartbed_bed::band::Band;

/// A symmetric matrix of a size and a width with a diagonal that outweighs the rest.
fn entry(width: usize, i: usize, j: usize) -> f64 {
    let (low, high) = (i.min(j), i.max(j));
    match high - low {
        0 => 2.0 + width as f64,
        away if away <= width => ((7 * low + 13 * high) % 11) as f64 / 5.0 - 1.0,
        _ => 0.0,
    }
}

#[test]
fn solutions_satisfy_their_matrices() {
    for (size, width) in [(1, 0), (2, 1), (7, 3), (8, 7), (40, 17), (41, 40), (100, 8), (203, 26)] {
        let mut band = Band::new(size, width);
        (0..size).for_each(|i| (0..size).for_each(|j| band.add(i, j, entry(width, i, j))));
        let factor = band.factor().expect("positive");
        let right = |i: usize| (i % 5) as f64 - 1.5;
        let mut one: Vec<f64> = (0..size).map(right).collect();
        factor.solve(&mut one);
        let mut several: Vec<[f64; 2]> = (0..size).map(|i| [right(i), 2.0]).collect();
        factor.solve_all(&mut several);
        for i in 0..size {
            let sum = |x: &dyn Fn(usize) -> f64| (0..size).map(|j| entry(width, i, j) * x(j)).sum::<f64>();
            let off = [
                sum(&|j| one[j]) - right(i),
                sum(&|j| several[j][0]) - right(i),
                sum(&|j| several[j][1]) - 2.0,
            ];
            assert!(off.iter().all(|x| x.abs() < 1e-12 * size as f64), "{size} {width} row {i}: {off:?}");
        }
    }
    let mut band = Band::new(9, 2);
    (0..9).for_each(|i| band.add(i, i, if i == 8 { -1.0 } else { 1.0 }));
    assert!(band.factor().is_none());
}
