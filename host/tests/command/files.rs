//! Files and streams: foreign files are not overwritten, no output is lost without a message, no input is read
//! endlessly.

use crate::support::{command, file, finish, smartbed, written};
use std::fs;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// An empty folder of one test.
fn fresh(name: &str) -> PathBuf {
    let folder = file(name);
    let _ = fs::remove_dir_all(&folder);
    let _ = fs::remove_file(&folder);
    folder
}

fn derive(folder: &Path) -> crate::support::Done {
    smartbed(&["derive", "pendulum", "--crate", &folder.display().to_string()])
}

#[test]
fn a_derived_crate_overwrites_only_itself() {
    let folder = fresh("own_crate");
    assert_eq!(derive(&folder).status, 0);
    let root = folder.join("src/lib.rs");
    let text = fs::read_to_string(&root).expect("a crate");
    // The same again, and with other equations.
    assert_eq!(derive(&folder).status, 0);
    let other = smartbed(&["derive", "cart_pole", "--crate", &folder.display().to_string()]);
    assert_eq!(other.status, 0, "{other:?}");
    assert_eq!(derive(&folder).status, 0);
    assert_eq!(fs::read_to_string(&root).expect("a crate"), text);

    fs::write(&root, "// mine\n").expect("a file");
    let refused = derive(&folder);
    assert!(refused.message().contains("src/lib.rs: it was changed since it was derived"), "{refused:?}");
    assert_eq!(fs::read_to_string(&root).expect("kept"), "// mine\n");

    let folder = fresh("own_package");
    fs::create_dir_all(&folder).expect("a folder");
    fs::write(folder.join("Cargo.toml"), "[package]\nname = \"mine\"\n").expect("a file");
    let refused = derive(&folder);
    assert!(refused.message().contains("Cargo.toml: it was written by somebody else"), "{refused:?}");
    assert_eq!(fs::read_dir(&folder).expect("a folder").count(), 1, "nothing is written");
}

#[cfg(unix)]
#[test]
fn a_derived_crate_is_not_written_through_links() {
    use std::os::unix::fs::symlink;
    let (folder, elsewhere) = (fresh("linked_crate"), fresh("elsewhere"));
    fs::create_dir_all(folder.join("src")).expect("a folder");
    fs::create_dir_all(&elsewhere).expect("a folder");
    fs::write(elsewhere.join("lib.rs"), "// mine\n").expect("a file");
    symlink(elsewhere.join("lib.rs"), folder.join("src/lib.rs")).expect("a link");
    assert!(derive(&folder).message().contains("src/lib.rs: it is a link"));
    fs::remove_file(folder.join("src/lib.rs")).expect("the link");
    fs::remove_dir(folder.join("src")).expect("the folder");
    symlink(&elsewhere, folder.join("src")).expect("a link");
    assert!(derive(&folder).message().contains("src: it is a link"));
    fs::remove_file(folder.join("src")).expect("the link");
    // A second name of a file that was derived keeps what it had.
    assert_eq!(derive(&folder).status, 0);
    let kept = elsewhere.join("kept.rs");
    fs::hard_link(folder.join("src/equations.rs"), &kept).expect("a second name");
    let before = fs::read(&kept).expect("a file");
    let other = smartbed(&["derive", "cart_pole", "--crate", &folder.display().to_string()]);
    assert_eq!(other.status, 0, "{other:?}");
    assert_eq!(fs::read(&kept).expect("kept"), before);
    assert_eq!(fs::read_to_string(elsewhere.join("lib.rs")).expect("kept"), "// mine\n");
}

#[test]
fn a_report_of_a_path_stays_in_its_folder() {
    let folder = fresh("subjects");
    fs::create_dir_all(folder.join("sub")).expect("a folder");
    let text = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/pendulum.toml"));
    let model = folder.join("sub/swing.toml");
    fs::write(&model, text.expect("a model")).expect("a file");
    let out = folder.join("out");
    let line =
        ["report", &model.display().to_string(), "--seconds=0.1", "--method=rk4", "--step=1e-2", "--out"];
    let done = smartbed(&[&line[..], &[&out.display().to_string()]].concat());
    assert_eq!(done.status, 0, "{done:?}");
    assert!(out.join("plots/swing.svg").is_file(), "{done:?}");
    let beside: Vec<_> = fs::read_dir(folder.join("sub")).expect("a folder").collect();
    assert_eq!(beside.len(), 1, "{beside:?}");
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_standard_output_is_a_failure() {
    let states = written("full.json", "{\"states\": [{\"q\": {\"q\": 0.1}}]}");
    let lines: [&[&str]; 7] = [
        &["check", "pendulum"],
        &["derive", "pendulum"],
        &["eval", "pendulum", "--states", &states],
        &["run", "pendulum", "--seconds", "0.1"],
        &["run", "pendulum", "--seconds", "0.1", "--csv", "-"],
        &["run", "single_spring", "--seconds", "0.1", "--csv", "-"],
        &["run", "--help"],
    ];
    for line in lines {
        let full = || fs::OpenOptions::new().write(true).open("/dev/full").expect("Linux has it");
        let mut program = command(line);
        program.stdout(full());
        let done = finish_with(program, Stdio::piped());
        assert_eq!(done.0, Some(1), "{line:?}: {done:?}");
        assert!(
            line == ["run", "--help"] || done.1.contains("cannot write standard output"),
            "{line:?}: {done:?}"
        );
        // Standard error is full too: what cannot be said is left unsaid.
        let mut program = command(line);
        program.stdout(full()).stderr(full());
        assert_eq!(program.status().expect("it runs").code(), Some(1), "{line:?}");
        let mut program = command(line);
        program.stdout(Stdio::null()).stderr(full());
        assert_eq!(program.status().expect("it runs").code(), Some(0), "{line:?}");
    }
}

/// A file name in the tests' folder, with `text` repeated between head and tail up to a size.
#[cfg(target_os = "linux")]
fn filled(name: &str, [head, part, tail]: [&str; 3], size: usize) -> String {
    let parts = (size - head.len() - tail.len()) / part.len();
    written(name, &[head, &part.repeat(parts), tail].concat())
}

/// The largest memory (bytes) that a command has taken, looked up all the while; its status and its messages.
#[cfg(target_os = "linux")]
fn peak_memory(mut command: Command) -> (u64, Option<i32>, String) {
    let log = fresh("peak.err");
    let mut child = command.stderr(fs::File::create(&log).expect("a file")).spawn().expect("it runs");
    let status = format!("/proc/{}/status", child.id());
    let mut peak = 0;
    let code = loop {
        let text = fs::read_to_string(&status).unwrap_or_default();
        let line = text.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let kilobytes = line.and_then(|l| l.trim().strip_suffix(" kB")?.parse::<u64>().ok());
        peak = peak.max(1024 * kilobytes.unwrap_or(0));
        std::thread::sleep(Duration::from_millis(1));
        if child.try_wait().expect("a child").is_some() {
            break child.wait().expect("its status").code();
        }
    };
    (peak, code, fs::read_to_string(&log).expect("messages"))
}

/// Texts as large as they may be, of little but commas and brackets, take at most 20 times the largest text's memory
/// beside the program's own; a larger one is refused by its size.
#[cfg(target_os = "linux")]
#[test]
fn the_largest_texts_stay_within_twenty_times_their_size() {
    const MODEL: usize = 1 << 20;
    const SCENE: usize = 8 << 20;
    let model = "format = 1\nname = \"case\"\n[coordinates]\nq = { unit = \"m\" }\n[points]\nP = \"q*N.x\"\n[bodies]\n\
                 b = { centre = \"P\", mass = \"1_kg\" }\n";
    let outputs: String = (0..330).map(|n| format!("o{n} = \"{}q\"\n", "q*q+".repeat(700))).collect();
    let run = |file: String| format!("run {file} --seconds 0");
    let states = |file: String| format!("eval pendulum -o /dev/null --states {file}");
    let check = |file: String| format!("check {file}");
    let (large, many) = ("larger than 1048576 bytes", "values, keys and lines; at most");
    let lines = [
        (MODEL, "", check(written("terms.toml", &format!("{model}[outputs]\n{outputs}")))),
        (MODEL, many, check(filled("list.toml", [&format!("{model}[run]\nx = ["), "1,", "]\n"], MODEL))),
        (
            MODEL,
            "no field",
            check(filled("fewer.toml", [&format!("{model}[run]\nx = ["), "1,", "]\n"], 158_000)),
        ),
        (MODEL, large, check(filled("large.toml", [model, "#", "\n"], MODEL + 9))),
        (SCENE, many, run(filled("points.toml", ["format = 1\npoints = [", "[0,0,1],", "]\n"], SCENE))),
        (
            SCENE,
            many,
            run(filled("numbers.toml", ["format = 1\nshape = \"cube\"\nx = [", "1,", "]\n"], SCENE)),
        ),
        (
            SCENE,
            "`x`",
            run(filled("listed.toml", ["format = 1\nshape = \"cube\"\nx = [", "1,", "]\n"], 1_790_000)),
        ),
        (
            SCENE,
            "at most",
            run(filled("rows.toml", ["format = 1\npoints = [", "[0,0,1],", "]\n"], 1_790_000)),
        ),
        (SCENE, many, run(filled("points.json", ["{\"points\": [", "[0,0,1],", "[0,0,1]]}"], SCENE))),
        (
            SCENE,
            "more than 8 MiB",
            run(filled("large.json", ["{\"points\": [", "[0,0,1],", "[0,0,1]]}"], SCENE + 99)),
        ),
        (SCENE, "at most 250000", states(filled("some.json", ["{\"states\": [", "{},", "{}]}"], SCENE))),
        (SCENE, "", states(filled("q.json", ["{\"states\": [", "{\"q\":{\"q\":1}},", "{}]}"], 250_000 * 14))),
    ];
    let program = |line: &str| {
        let mut command = command(&line.split(' ').collect::<Vec<_>>());
        command.stdout(Stdio::null());
        command
    };
    let (own, ..) = peak_memory(program("check pendulum"));
    for (size, said, line) in lines {
        let (peak, status, errors) = peak_memory(program(&line));
        println!("{line}: {:.1} times {size} bytes", peak.saturating_sub(own) as f64 / size as f64);
        assert!(
            matches!(status, Some(0 | 1)) && !errors.contains("panicked"),
            "{line}: {status:?} {errors:.300}"
        );
        assert!(errors.contains(said), "{line}: {errors:.300}");
        assert!(
            own > 0 && peak <= own + 20 * size as u64,
            "{line}: {peak} bytes, {own} of them the program's own"
        );
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_closed_standard_output_is_a_failure() {
    let program = env!("CARGO_BIN_EXE_smartbed");
    let lines = [
        "check pendulum",
        "run pendulum --seconds 0.1",
        "run single_spring --seconds 0.1 --csv -",
        "run --help",
    ];
    for line in lines {
        let mut shell = Command::new("sh");
        shell
            .args(["-c", &format!("{program} {line} >&-")])
            .current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
        let done = finish_with(shell, Stdio::piped());
        assert_eq!(done.0, Some(1), "{line}: {done:?}");
        assert!(line == "run --help" || done.1.contains("standard output: it is closed"), "{line}: {done:?}");
        // The null device was asked for: that is no failure, however it was opened.
        let mut shell = Command::new("sh");
        shell.args(["-c", &format!("{program} {line} 1<>/dev/null")]);
        shell.current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
        let done = finish_with(shell, Stdio::piped());
        assert_eq!(done.0, Some(0), "{line}: {done:?}");
    }
}

/// Status and standard error.
fn finish_with(mut program: Command, errors: Stdio) -> (Option<i32>, String) {
    let mut child = program.stderr(errors).spawn().expect("the program runs");
    let mut text = String::new();
    if let Some(mut stream) = child.stderr.take() {
        stream.read_to_string(&mut text).expect("text");
    }
    (child.wait().expect("it ends").code(), text)
}

#[test]
fn readers_that_went_away_are_no_failure() {
    for (out, err) in [(true, false), (false, true), (true, true)] {
        let mut program = command(&["run", "pendulum", "--seconds", "10", "--every", "1", "--csv", "-"]);
        program.stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = program.spawn().expect("the program runs");
        // The end of a pipe that is dropped is closed; the other one is read.
        let (stdout, stderr) = (child.stdout.take(), child.stderr.take());
        let (stdout, stderr) = (stdout.filter(|_| !out), stderr.filter(|_| !err));
        stdout.map(|mut rest| std::io::copy(&mut rest, &mut std::io::sink()).expect("read"));
        stderr.map(|mut rest| std::io::copy(&mut rest, &mut std::io::sink()).expect("read"));
        assert_eq!(child.wait().expect("it ends").code(), Some(0), "{out} {err}");
    }
}

#[cfg(unix)]
#[test]
fn an_interrupted_run_leaves_whole_rows_and_says_so() {
    for (model, name) in [("pendulum", "mechanism.csv"), ("cube", "scene.csv")] {
        let rows = fresh(name);
        let path = rows.display().to_string();
        let mut program = command(&["run", model, "--seconds", "5e4", "--every", "1", "--csv", &path]);
        let mut child = program.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it runs");
        let begin = Instant::now();
        while fs::metadata(&rows).map_or(0, |m| m.len()) < 100_000
            && begin.elapsed() < Duration::from_secs(300)
        {
            std::thread::sleep(Duration::from_millis(5));
        }
        let killed = Command::new("kill").args(["-INT", &child.id().to_string()]).status();
        assert!(killed.expect("kill").success());
        let mut said = String::new();
        child.stderr.take().expect("piped").read_to_string(&mut said).expect("text");
        assert_eq!(child.wait().expect("it ends").code(), Some(1), "{said}");
        assert!(said.contains("error: interrupted at t = "), "{said}");
        let text = fs::read_to_string(&rows).expect("rows");
        let columns = text.lines().next().expect("a header").split(',').count();
        assert!(text.ends_with('\n') && text.lines().all(|line| line.split(',').count() == columns));
        let count = format!("; {} rows up to there in {path}", text.lines().count() - 1);
        assert!(said.contains(&count), "{count}: {said}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn special_files_are_refused_at_once() {
    let pipe = fresh("pipe.toml");
    assert!(Command::new("mkfifo").arg(&pipe).status().expect("mkfifo").success());
    let pipe = pipe.display().to_string();
    let folder = env!("CARGO_TARGET_TMPDIR");
    let extends = |what: &str| {
        let name = format!("extends{}.toml", what.replace('/', "_"));
        written(&name, &format!("format = 1\nname = \"e\"\nextends = \"{what}\"\n"))
    };
    let (zero, piped) = (extends("/dev/zero"), extends(&pipe));
    let lines: [&[&str]; 9] = [
        &["eval", "pendulum", "--states", "/dev/zero"],
        &["eval", "pendulum", "--states", &pipe],
        &["eval", "pendulum", "--states", folder],
        &["run", &pipe],
        &["check", "/dev/zero"],
        &["check", folder],
        &["check", &zero],
        &["check", &piped],
        &["report", "pendulum", "--quick", "--points", "/dev/zero"],
    ];
    for line in lines {
        // Longer than any machine is busy: one that waits for its input has status 124.
        let mut program = Command::new("timeout");
        program.arg("300").arg(env!("CARGO_BIN_EXE_smartbed")).args(line).stdin(Stdio::null());
        program.current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(".."));
        let done = finish(program);
        assert_eq!(done.status, 1, "{line:?}: {done:?}");
        assert!(done.err.contains("expected"), "{line:?}: {done:?}");
    }
    // What a shell hands over is read to its end.
    let mut program = command(&["eval", "pendulum", "--states", "-"]);
    program.stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut child = program.spawn().expect("it runs");
    let states = b"{\"states\": [{\"q\": {\"q\": 0.1}}]}";
    child.stdin.take().expect("piped").write_all(states).expect("written");
    assert!(child.wait_with_output().expect("it ends").status.success());
}

/// Two results would end within one another, or one be left out.
#[test]
fn one_result_of_a_plan_goes_to_standard_output() {
    for asked in [["--csv", "-", "--json"].as_slice(), &["--csv", "-", "--readings", "-"]] {
        let done = smartbed(&[&["bed", "run", "ball_on_four"], asked].concat());
        assert!(done.status == 1 && done.out.is_empty(), "{done:?}");
        assert!(done.err.contains("only one of them can go to standard output"), "{done:?}");
    }
}

/// No result replaces a file that is read, by whatever name, nor another result.
#[test]
fn results_replace_neither_what_is_read_nor_one_another() {
    let text = crate::support::model("pendulum");
    let file = written("not_replaced.toml", &text);
    let stem = file.strip_suffix(".toml").expect("an ending").to_owned();
    let states = written("not_replaced.json", "{\"states\": [{\"q\": {\"q\": 0.1}}]}");
    let twice = fresh("twice.svg").display().to_string();
    let lines: [(&[&str], &str); 6] = [
        (&["run", &file, "--csv", &file], "--csv"),
        (&["run", &stem, "--plot", &file], "--plot"),
        (&["derive", &file, "-o", &file], "--output"),
        (&["eval", &file, "--states", &states, "-o", &states], "--output"),
        (&["import", &file, "-o", &file], "--output"),
        (&["run", &file, "--csv", &twice, "--plot", &twice], "both would write"),
    ];
    for (line, said) in lines {
        let done = smartbed(line);
        assert!(done.status == 1 && done.err.contains(said), "{line:?}: {done:?}");
    }
    assert_eq!(std::fs::read_to_string(&file).expect("it is left"), text);
    assert!(!std::path::Path::new(&twice).exists());
    // What would go to standard output beside the code.
    let done = smartbed(&["derive", &file, "--json"]);
    assert!(done.status == 1 && done.out.is_empty() && done.err.contains("--output"), "{done:?}");
}
