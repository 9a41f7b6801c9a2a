//! Encodes the frames of a run as bytes for its page: sheets, maps, tiles and segments, thinned out to nine by nine
//! nodes per sheet.
//!
//! In: plan and history. Out: base64 of a deflate stream (zlib) of frames of fixed length, each byte as the difference
//! to the frame before, so that parts at rest are zeros. A node has a byte each for height (mm + 128), pressure (mmHg)
//! and shear (tenths of kPa); a tile has pressure (0.05 kPa), heave (mm/2 + 128) and two slopes (1/500 + 128); a
//! segment has seven words of 16 bits for position (0.1 mm) and attitude (1/30000).

use crate::view::film::base64;
use smartbed_bed::map::{Frame, MMHG};
use smartbed_bed::plan::Plan;
use smartbed_bed::plan::history::{History, Moment};
use smartbed_bed::plan::maps::sensel;

/// Compression level, 0 to 10.
const EFFORT: u8 = 9;

/// All frames.
pub(super) fn bytes(plan: &Plan, history: &History) -> String {
    let (mut all, mut before) = (Vec::new(), Vec::new());
    for (frame, moment) in history.sensels.frames().iter().zip(&history.moments) {
        let now = one(plan, frame, moment);
        before.resize(now.len(), 0_u8);
        all.extend(now.iter().zip(&before).map(|(now, before)| now.wrapping_sub(*before)));
        before = now;
    }
    base64(&miniz_oxide::deflate::compress_to_vec_zlib(&all, EFFORT))
}

/// One frame.
fn one(plan: &Plan, frame: &Frame, moment: &Moment) -> Vec<u8> {
    let byte = |x: f64| x.round().clamp(0.0, 255.0) as u8;
    let mut bytes: Vec<u8> =
        moment.heights.iter().flatten().map(|z| byte(1e3 * f64::from(*z) + 128.0)).collect();
    let [across, along] = plan.layout.shown();
    let width = plan.layout.intervals[0] + 1;
    let mut sites = Vec::new();
    for tile in 0..plan.layout.count() {
        for j in &along {
            sites.extend(across.iter().map(|i| sensel(&plan.layout, tile, j * width + i)));
        }
    }
    bytes.extend(sites.iter().map(|site| site.map_or(0, |s| byte(frame.pressure[s] / MMHG))));
    bytes.extend(
        sites.iter().map(|site| site.map_or(0, |s| byte(frame.shear[s][0].hypot(frame.shear[s][1]) / 100.0))),
    );
    for (order, gauge) in moment.orders.iter().zip(&moment.gauges) {
        let [x, y] = order.command.slope;
        bytes.extend(
            [gauge / 50.0, 2e3 * order.command.heave + 128.0, 500.0 * x + 128.0, 500.0 * y + 128.0].map(byte),
        );
    }
    for pose in &moment.segments {
        let words =
            pose.place.map(|x| 1e4 * x).into_iter().chain(pose.attitude.parameters().map(|e| 3e4 * e));
        bytes.extend(words.flat_map(|x| (x.round() as i16).to_le_bytes()));
    }
    bytes
}
