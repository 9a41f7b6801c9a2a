//! A supine patient's map compared with published ones: which parts of the body carry load, and in what range.
//!
//! Garfin, Pye, Hargens and Akeson, Arch Phys Med Rehabil 61(9), 1980, four beds: soft ones bear a supine body on
//! occiput, shoulders, buttocks, calves and heels, with more than 30 mmHg over bony prominences. Clin Phys Physiol Meas
//! 10(4), 1989: on water, most pressure at sacrum and heels. `docs/bed.md` says what agrees and what does not.

use smartbed_bed::body::anthropometry::Table;
use smartbed_bed::body::figure::{Figure, Posture};
use smartbed_bed::map::{MMHG, Region};
use smartbed_bed::plan::run::run;
use smartbed_bed::plan::{Clock, Laying, Layout, Load, Plan};

#[test]
fn a_supine_patient_bears_on_what_published_maps_say() {
    let figure = Figure::new(Table::DeLevaMale, 75.0, 1.75, Posture::Supine, &[]).expect("a figure");
    let load = Load { body: figure.body.clone(), poses: figure.poses.clone(), figure: Some(figure) };
    let plan = Plan {
        title: "supine".to_owned(),
        layout: Layout::default(),
        pressure: 4000.0,
        load: load.placed([0.0; 2]),
        moves: Vec::new(),
        seconds: 0.0,
        every: 10.0,
        cycle: 600.0,
        clock: Clock::QuasiStatic,
        laying: Laying::AtOnce,
    };
    let history = run(&plan, |_| true).expect("rests");
    let skin = &history.skin.frames()[0].pressure;
    let peak = |region: Region| {
        let of = history.skin.sites().iter().zip(skin).filter(|(site, _)| site.region == Some(region));
        of.map(|(_, p)| p / MMHG).fold(0.0, f64::max)
    };
    let [occiput, shoulders, sacrum, heels] =
        [Region::Occiput, Region::Scapulae, Region::Sacrum, Region::Heels].map(peak);
    println!("occiput {occiput:.0}, scapulae {shoulders:.0}, sacrum {sacrum:.0}, heels {heels:.0} mmHg");
    // Agrees: these bear, prominences of trunk and heels with more than 30 mmHg, elbows and sides of the hips do not.
    assert!([shoulders, sacrum, heels].iter().all(|p| (30.0..80.0).contains(p)));
    assert!(peak(Region::Elbows) < 5.0 && peak(Region::Trochanters) < 5.0);
    // Less than published: the head, which rests on a bladder by its whole back. Differs in order: the shoulder blades
    // bear more than the sacrum, since the trunk is three slabs whose edges are rounder than a back.
    assert!((20.0..32.0).contains(&occiput) && shoulders > sacrum && sacrum > heels);
}
