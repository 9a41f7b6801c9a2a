//! Dimensions of the tile: lengths, limits, rates. For another bed only this file changes.
//!
//! SI units. Limits are of three kinds, each wider than the one before: what may be commanded, where the end
//! switches are, and what is a fault.

/// Radius of the circle of screws (m).
pub const RADIUS: f32 = 0.09;
/// Most height that may be commanded, up and down from the middle (m).
pub const STROKE: f32 = 0.029;
/// Where the end switches open, up and down from the middle (m).
pub const SWITCH: f32 = 0.0295;
/// Steepest slope that may be commanded (1): 15 degrees.
pub const SLOPE: f32 = 0.268;
/// Steepest slope before it is a fault (1): 17 degrees.
pub const SLOPE_FAULT: f32 = 0.3057;
/// Largest rate of the slope (1/s): half a degree per second. A slope's rate is never below that of its angle.
pub const SLOPE_RATE: f32 = 8.726_646e-3;
/// Fault limit of the slope's rate (1/s): three degrees per second.
pub const SLOPE_RATE_FAULT: f32 = 5.235_988e-2;
/// Speed of a leg (m/s).
pub const LEG_SPEED: f32 = 3e-3;
/// Factor on the speed of legs and slopes when the tile is flattened for resuscitation.
pub const FLATTEN_FACTOR: f32 = 2.0;
/// Factor on the speed until the switches have been found.
pub const UNHOMED_FACTOR: f32 = 0.5;
/// Speed of the search for the switches (m/s).
pub const SEEK_SPEED: f32 = 5e-4;
/// Height below the middle at which the search starts (m).
pub const SEEK_START: f32 = 0.0285;
/// Tolerance of the height at which a switch opens (m): play, and the error of the displacement sensor.
pub const SWITCH_PLAY: f32 = 1e-3;
/// Displacement back from an obstruction (m).
pub const RETREAT: f32 = 5e-3;

/// Largest difference of encoder and displacement sensor (m).
pub const DISAGREEMENT: f32 = 5e-4;
/// Largest distance of a leg from its command (m).
pub const FOLLOWING: f32 = 5e-4;
/// Largest creep of a leg at rest (m).
pub const CREEP: f32 = 3e-4;
/// Largest difference of a leg's speed from its command (m/s).
pub const RUNAWAY_SPEED: f32 = 3.5e-3;
/// A faster leg is impossible (m/s): the encoder is wrong.
pub const FASTEST: f32 = 2e-2;
/// A leg within this distance has arrived (m).
pub const ARRIVED: f32 = 1e-5;
/// A leg still farther away than this after [`SETTLING`] is a fault (m).
pub const NOT_ARRIVED: f32 = 4e-5;
/// Time for a leg to arrive (ticks).
pub const SETTLING: u32 = 400;

/// Shortest displacement of a leg for its effort to be judged by this motion alone (m): see `super::effort`.
pub const SHORT_WAY: f32 = 9.5e-4;
/// Displacement back after which a leg is free of whatever it leaned on (m).
pub const RELEASE: f32 = 2.5e-3;
/// Rise of the current of a rising leg over its least level that counts as an obstruction (A): 50 to 110 N, depending
/// on friction.
pub const CURRENT_RISE: f32 = 0.12;
/// Rise of the current of a falling leg that counts as an obstruction: share of the level, and least rise (A).
/// A fall counts too: an obstacle carries the load, and the motor need not push it down.
pub const RISE_DOWN: (f32, f32) = (2.0, 0.03);
/// See [`RISE_DOWN`].
pub const FALL_DOWN: (f32, f32) = (0.5, 5e-3);
/// Factor on the change of current that the model predicts: the position of the patient is not known.
pub const LOAD_MARGIN: f32 = 1.3;
/// A leg that carries less than this when it is learnt does not predict later loads (N).
pub const LEAST_LOAD: f32 = 10.0;
/// Most current of a motor (A).
pub const CURRENT: f32 = 1.2;
/// Largest current while drives are disabled (A).
pub const CURRENT_OFF: f32 = 0.05;
/// Supply (V), least and most.
pub const SUPPLY: (f32, f32) = (18.0, 30.0);

/// Weight that the legs carry without a patient (N): platform and connectors.
pub const OWN_WEIGHT: f32 = 6.3 * 9.81;
/// Working load (kg).
pub const PAYLOAD: f32 = 30.0;
/// Largest weight with a patient (N): 30 kg, and a third more for the uncertainty of friction.
pub const MOST_WEIGHT: f32 = (6.3 + 40.0) * 9.81;
/// Half the sides of a tile along x and y (m): four in a row of 0.9 m, seven in 2 m.
pub const HALF_SIDES: (f32, f32) = (0.1125, 0.142_857);
/// Largest step between the edges of neighbours (m).
pub const STEP_LIMIT: f32 = 0.02;
/// Area of the bladder (m^2): pitch 285.7 mm x 225 mm.
pub const AREA: f32 = 0.0643;
/// Standard gravity (m/s^2).
pub const GRAVITY: f32 = 9.81;
/// Highest pressure over ambient that may be commanded (Pa): 80 mmHg.
pub const PRESSURE: f32 = 10_666.0;
/// Pressure that is a fault (Pa).
pub const OVERPRESSURE: f32 = 11.5e3;
/// Largest difference of the two pressures: an offset (Pa), and a share of either.
pub const PRESSURE_DISAGREEMENT: (f32, f32) = (150.0, 0.08);
/// Largest offset of a sound sensor: height (m), pressure (Pa).
pub const TRIM: (f32, f32) = (2e-3, 500.0);
