//! Sensors and controllers of parts that `grid` repeats: one for each copy, the same as if they were written out.

use super::support::{fails, json, number, run, scene};

const ARMS: &str =
    "format = 2\n[parts.arm]\nmechanism = \"double_pendulum\"\ngrid = { count = [1, 2], pitch = [3, 3] }\n";
const RUN: &str = "[run]\nseconds = 0.05\n";

fn controller(name: &str, reads: &str, drives: &str) -> String {
    format!(
        "[controllers.{name}]\nreads = \"{reads}\"\ndrives = \"{drives}\"\ntarget = 0.5\ngain = 3\nperiod = \"5_ms\"\n"
    )
}

fn sensor(name: &str, of: &str, more: &str) -> String {
    format!("[sensors.{name}]\nof = \"{of}\"\nperiod = \"5_ms\"\n{more}")
}

#[test]
fn copies_are_held_as_if_each_were_written_out() {
    let resolution = "resolution = 0.01\n";
    let short =
        [sensor("angle", "arm.q1", resolution), controller("hold", "sensors.angle", "arm.T")].concat();
    let long: String = (0..2)
        .map(|copy| {
            sensor(&format!("angle{copy}"), &format!("arm[0,{copy}].q1"), resolution)
                + &controller(
                    &format!("hold{copy}"),
                    &format!("sensors.angle{copy}"),
                    &format!("arm[0,{copy}].T"),
                )
        })
        .collect();
    let plain = controller("hold", "arm.q1", "arm.T");
    let [short, long, plain] = [("short", short), ("long", long), ("plain", plain)]
        .map(|(name, text)| json(&[&scene(name, &format!("{ARMS}{text}{RUN}"))]));
    for copy in 0..2 {
        let column = format!("arm[0,{copy}].q2");
        assert_eq!(short["last"][&column], long["last"][&column]);
        assert_eq!(
            short["last"][format!("sensors.angle[0,{copy}]")],
            long["last"][format!("sensors.angle{copy}")]
        );
        assert!(number(&plain["last"][&column]) != number(&short["last"][&column]), "a rounded reading");
    }
    let free = json(&[&scene("free", &format!("{ARMS}{RUN}"))]);
    assert!(number(&free["last"]["arm[0,1].q1"]) != number(&short["last"]["arm[0,1].q1"]), "it is driven");
}

#[test]
fn copies_of_a_sensor_have_noise_of_their_own_and_a_run_goes_on_with_it() {
    let text = sensor("angle", "arm.q1", "noise = 0.1\nseed = 7\n");
    let path = scene("noisy", &format!("{ARMS}{text}{RUN}"));
    let whole = json(&[&path]);
    let reading =
        |output: &serde_json::Value, copy: usize| number(&output["last"][format!("sensors.angle[0,{copy}]")]);
    assert!((reading(&whole, 0) - reading(&whole, 1)).abs() > 1e-3, "{whole}");
    let state = format!("{path}.state");
    run(&["run", &path, "--seconds", "0.02", "--save", &state]);
    let resumed = json(&[&path, "--resume", &state]);
    for copy in 0..2 {
        assert!(reading(&whole, copy) == reading(&resumed, copy), "copy {copy}");
    }
}

#[test]
fn errors_of_copies_stand_where_the_repeated_one_does() {
    let said = |text: &str| fails(&["run", &scene("wrong", &format!("{ARMS}{text}{RUN}"))]);
    let column = said(&sensor("angle", "arm.q3", ""));
    assert!(column.contains("arm[0,0].q3") && column.contains("wrong.toml:6:6"), "{column}");
    let input = said(&controller("hold", "arm.q1", "arm.S"));
    assert!(input.contains("arm[0,0].S") && input.contains("wrong.toml:7:10"), "{input}");
    let given = ARMS.replace("grid", "command = { q1 = \"1_rad*t/1_s\", q2 = \"1_rad*t/1_s\" }\ngrid");
    let idle =
        fails(&["run", &scene("idle", &format!("{given}{}{RUN}", controller("hold", "arm.q1", "arm.T")))]);
    assert!(idle.contains("arm") && idle.contains("`T`") && idle.contains("idle.toml:8:10"), "{idle}");
}
