//! `smartbed view`: serves the page on this machine and follows the model's file.
//!
//! The page asks for `/state` a few times a second. If a text in the model's folder has changed since the last run, the
//! model is run again, and the page then fetches `/data`. Errors in an edit are shown on the page, which keeps the last
//! motion. Requests are answered one after the other: there is only one reader.

use super::arguments::Arguments;
use super::page::page;
use crate::failure::Failure;
use crate::number::json_string;
use crate::{model_argument, output, run};
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

/// A connection without any data for so long is closed.
const PATIENCE: Duration = Duration::from_secs(2);
/// Most bytes of a request's head.
const HEAD: u64 = 16 * 1024;

/// Serves until the process is ended.
///
/// # Errors
/// Status 1 if the model is wrong at the start; status 2 if the port is taken.
pub fn serve(arguments: &Arguments) -> Result<(), Failure> {
    let mut subject = Subject::new(arguments)?;
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, arguments.port));
    let listener = listener.map_err(|e| {
        Failure::Lacking(format!("--port {}: {e}; take another, or 0 for any that is free", arguments.port))
    })?;
    let address = listener.local_addr().map_err(|e| Failure::Lacking(e.to_string()))?;
    output::print(&match arguments.json {
        true => format!("{{\"address\": \"http://{address}/\"}}\n"),
        false => format!(
            "open http://{address}/ in a browser; the page is updated when {} changes; end with Ctrl-C\n",
            subject.path.display()
        ),
    })?;
    for stream in listener.incoming() {
        // A connection that the browser closed is no failure.
        let _ = stream.and_then(|stream| answer(stream, &mut subject));
    }
    Ok(())
}

/// The model that is followed, and its last good motion.
struct Subject {
    arguments: run::Arguments,
    path: PathBuf,
    stamps: Vec<(PathBuf, SystemTime)>,
    version: usize,
    fault: String,
    data: String,
}

impl Subject {
    fn new(arguments: &Arguments) -> Result<Self, Failure> {
        let path = model_argument::find(&arguments.model)?;
        let stamps = stamps(&path);
        let arguments = arguments.run(None);
        let data = run::film(&arguments)?;
        Ok(Self { arguments, path, stamps, version: 0, fault: String::new(), data })
    }

    /// Runs again if a file has changed.
    fn follow(&mut self) {
        let stamps = stamps(&self.path);
        if stamps == self.stamps {
            return;
        }
        self.stamps = stamps;
        match run::film(&self.arguments) {
            Ok(data) => (self.version, self.fault, self.data) = (self.version + 1, String::new(), data),
            Err(failure) => self.fault = failure.to_string(),
        }
    }
}

/// Time of the last change of each text in the model's folder: a model may extend its neighbours.
fn stamps(path: &Path) -> Vec<(PathBuf, SystemTime)> {
    let folder = path.parent().filter(|f| !f.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let files = std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    let texts = files.filter(|f| f == path || f.extension().is_some_and(|e| e == "toml" || e == "json"));
    let mut stamps: Vec<_> =
        texts.filter_map(|f| Some((f.clone(), f.metadata().ok()?.modified().ok()?))).collect();
    stamps.sort();
    stamps
}

/// Answers one request.
fn answer(mut stream: TcpStream, subject: &mut Subject) -> std::io::Result<()> {
    stream.set_read_timeout(Some(PATIENCE))?;
    stream.set_write_timeout(Some(PATIENCE))?;
    let mut lines = BufReader::new(stream.try_clone()?.take(HEAD)).lines();
    let request = lines.next().transpose()?.unwrap_or_default();
    // The rest of the head must be read, but is not used.
    for line in lines {
        if line?.is_empty() {
            break;
        }
    }
    let (status, kind, body) = match request.strip_prefix("GET ").and_then(|r| r.split(' ').next()) {
        Some("/") => ("200 OK", "text/html; charset=utf-8", page(&subject.data)),
        Some("/data") => ("200 OK", "application/json", subject.data.clone()),
        Some("/state") => {
            subject.follow();
            let (version, fault) = (subject.version, json_string(&subject.fault));
            ("200 OK", "application/json", format!("{{\"version\": {version}, \"fault\": {fault}}}"))
        }
        _ => ("404 Not Found", "text/plain", "there are /, /data and /state\n".to_owned()),
    };
    let head = format!(
        "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {}\r\nCache-Control: no-store\r\n\
         Connection: close\r\n\r\n",
        body.len()
    );
    stream.write_all(head.as_bytes())?;
    stream.write_all(body.as_bytes())
}
