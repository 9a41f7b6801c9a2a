//! Requests for answers, by name.
//!
//! In: text such as `rates`, `pose:platform` or `jacobian:arm@tip`. Out: [`Request`]s, and [`Function`]s of requests
//! that are answered together and share sub-expressions.

use crate::diagnostic::Diagnostic;
use crate::model::Model;
use std::fmt;
use std::str::FromStr;

/// The name of an answer and, after a colon, its subject.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Request {
    /// Name of the answer.
    pub answer: String,
    /// A port, a point, a frame, or `frame@point`; `None` if the answer is about the mechanism.
    pub of: Option<String>,
}

/// Requests that are answered by one function.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Function {
    /// Name of the function; for a single request that of the request.
    pub name: String,
    /// What it answers, in order.
    pub requests: Vec<Request>,
}

/// Everything that a derivation is asked for.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Asked {
    /// Functions besides those that every mechanism has.
    pub functions: Vec<Function>,
    /// If true, nothing but these functions is derived.
    pub only: bool,
}

impl Request {
    /// A request about the mechanism.
    #[must_use]
    pub fn new(answer: &str) -> Self {
        Self { answer: answer.to_owned(), of: None }
    }

    /// A request about a port, a point or a frame.
    #[must_use]
    pub fn of(answer: &str, of: &str) -> Self {
        Self { answer: answer.to_owned(), of: Some(of.to_owned()) }
    }
}

impl FromStr for Request {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (answer, of) = match text.split_once(':') {
            Some((answer, of)) => (answer, Some(of.trim().to_owned())),
            None => (text, None),
        };
        if answer.trim().is_empty() || of.as_deref() == Some("") {
            return Err(format!(
                "`{text}` asks for nothing; expected the name of an answer, such as `rates`, or \
                                `pose:platform`"
            ));
        }
        Ok(Self { answer: answer.trim().to_owned(), of })
    }
}

impl fmt::Display for Request {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.of {
            Some(of) => write!(f, "{}:{of}", self.answer),
            None => f.write_str(&self.answer),
        }
    }
}

impl Function {
    /// A function with one answer, named after it.
    #[must_use]
    pub fn single(request: Request) -> Self {
        Self { name: request.to_string(), requests: vec![request] }
    }

    /// One function with several answers; with a single one it is named after that.
    #[must_use]
    pub fn together(name: &str, requests: Vec<Request>) -> Self {
        match <[Request; 1]>::try_from(requests) {
            Ok([request]) => Self::single(request),
            Err(requests) => Self { name: name.to_owned(), requests },
        }
    }

    /// Parses `rates, pose:platform`, or with a name for the function `flight = rates, pose:platform`. Several answers
    /// without a name give a function `answers`; if `place` is not 0 it is `answers_2` and so on.
    ///
    /// # Errors
    /// The part that cannot be parsed.
    pub fn parse(text: &str, place: usize) -> Result<Self, String> {
        let (name, list) = match text.split_once('=') {
            Some((name, list)) => (Some(name.trim().to_owned()), list),
            None => (None, text),
        };
        let requests = list.split(',').map(str::parse).collect::<Result<Vec<Request>, String>>()?;
        let usual = if place == 0 { "answers".to_owned() } else { format!("answers_{}", place + 1) };
        let function = Self::together(name.as_deref().unwrap_or(&usual), requests);
        Ok(Self { name: name.unwrap_or(function.name), requests: function.requests })
    }

    /// Checks that it asks for nothing twice.
    ///
    /// # Errors
    /// The first request that is there twice.
    pub fn distinct(&self) -> Result<(), Diagnostic> {
        let Self { name, requests } = self;
        let twice = requests.iter().enumerate().find(|(n, request)| requests[..*n].contains(request));
        twice.map_or(Ok(()), |(_, request)| {
            Err(Diagnostic::error(format!("`{name}` asks for `{request}` twice")).help("once is enough"))
        })
    }

    /// A function for each of these answers about the mechanism.
    #[must_use]
    pub fn each(answers: &[&str]) -> Vec<Self> {
        answers.iter().map(|answer| Self::single(Request::new(answer))).collect()
    }
}

impl Asked {
    /// These functions and nothing else.
    #[must_use]
    pub fn only(functions: Vec<Function>) -> Self {
        Self { functions, only: true }
    }

    /// The contents of a complete file: these functions, the model's law if it has one, and what every mechanism has.
    #[must_use]
    pub fn complete(model: &Model, functions: Vec<Function>) -> Self {
        let law = Request::new("law");
        let mut asked = Self::besides(functions);
        if !model.laws.is_empty() && !asked.requests().contains(&law) {
            asked.functions.push(Function::single(law));
        }
        asked
    }

    /// These functions in addition to those that every mechanism has.
    #[must_use]
    pub fn besides(functions: Vec<Function>) -> Self {
        Self { functions, only: false }
    }

    /// Every request, without repetitions, in order.
    #[must_use]
    pub fn requests(&self) -> Vec<Request> {
        let mut all: Vec<Request> = Vec::new();
        for request in self.functions.iter().flat_map(|function| &function.requests) {
            if !all.contains(request) {
                all.push(request.clone());
            }
        }
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn requests_are_read_as_they_are_written() {
        for text in ["rates", "pose:platform", "jacobian:arm@tip"] {
            assert_eq!(text.parse::<Request>().expect(text).to_string(), text);
        }
        assert!("pose:".parse::<Request>().is_err() && "".parse::<Request>().is_err());
    }

    #[test]
    fn a_function_of_one_answer_is_named_after_it() {
        let pose = Request::of("pose", "platform");
        assert_eq!(Function::together("answers", vec![pose.clone()]).name, "pose:platform");
        let asked = Asked::only(vec![Function::together("both", vec![pose.clone(), pose.clone()])]);
        assert_eq!((asked.functions[0].name.as_str(), asked.requests()), ("both", vec![pose]));
    }
}
