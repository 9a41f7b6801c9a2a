//! Parses the macro's argument: the model's path and choices.
//!
//! In: the tokens between the parentheses. Out: the path and the options of a build script, or an error at the word
//! that was not expected.

use smartbed_codegen::rust::Core;
use smartbed_codegen::{Effort, Options, ScalarType};
use std::collections::BTreeMap;
use syn::parse::{Parse, ParseStream};
use syn::{Ident, LitBool, LitFloat, LitInt, LitStr, Token, braced, bracketed};

/// The arguments of the macro.
pub struct Choices {
    /// Path of the model, relative to the folder of the package.
    pub path: String,
    /// The options, the same as in a build script.
    pub options: Options,
}

impl Parse for Choices {
    fn parse(input: ParseStream) -> syn::Result<Self> {
        let path: LitStr = input.parse()?;
        let mut chosen = Self { path: path.value(), options: Options::default() };
        let mut read: Vec<Ident> = Vec::new();
        while !input.is_empty() {
            input.parse::<Token![,]>()?;
            if input.is_empty() {
                break;
            }
            let choice: Ident = input.parse()?;
            if read.contains(&choice) {
                return Err(twice(&choice));
            }
            input.parse::<Token![=]>()?;
            let options = &mut chosen.options;
            match choice.to_string().as_str() {
                "scalar" => options.emit.scalar = scalar(input)?,
                "effort" => options.settings.effort = effort(input)?,
                "core" => options.emit.core = Some(core(input)?),
                "shared_work" => options.emit.shared_work = input.parse::<LitBool>()?.value,
                "answers" => options.answers = list(input)?,
                "keep" => options.parameters.keep = list(input)?,
                "set" => options.parameters.values = values(input)?,
                _ => return Err(syn::Error::new(choice.span(), expected(&choice))),
            }
            read.push(choice);
        }
        Ok(chosen)
    }
}

fn expected(choice: &Ident) -> String {
    format!("unknown choice `{choice}`; expected scalar, answers, keep, set, effort, core or shared_work")
}

fn twice(name: &Ident) -> syn::Error {
    syn::Error::new(name.span(), format!("`{name}` is there twice; keep one of them"))
}

/// `f32`, `f64` or a type's path in quotes.
fn scalar(input: ParseStream) -> syn::Result<ScalarType> {
    if input.peek(LitStr) {
        return Ok(ScalarType::Path(input.parse::<LitStr>()?.value()));
    }
    let word: Ident = input.parse()?;
    match word.to_string().as_str() {
        "f32" => Ok(ScalarType::F32),
        "f64" => Ok(ScalarType::F64),
        _ => Err(syn::Error::new(word.span(), "scalar: expected f32, f64 or a type's path in quotes")),
    }
}

fn effort(input: ParseStream) -> syn::Result<Effort> {
    let word: Ident = input.parse()?;
    match word.to_string().as_str() {
        "none" => Ok(Effort::None),
        "default" => Ok(Effort::Default),
        "all" => Ok(Effort::All),
        _ => Err(syn::Error::new(word.span(), "effort: expected none, default or all")),
    }
}

fn core(input: ParseStream) -> syn::Result<Core> {
    let word: Ident = input.parse()?;
    match word.to_string().as_str() {
        "cortex_m4" => Ok(Core::CortexM4),
        "host" => Ok(Core::Host),
        _ => Err(syn::Error::new(word.span(), "core: expected cortex_m4 or host")),
    }
}

/// `["a", "b"]`.
fn list(input: ParseStream) -> syn::Result<Vec<String>> {
    let inside;
    bracketed!(inside in input);
    let entries = inside.parse_terminated(|input| input.parse::<LitStr>(), Token![,])?;
    Ok(entries.iter().map(LitStr::value).collect())
}

/// `{ M = 8.0, z_payload = -0.1 }`.
fn values(input: ParseStream) -> syn::Result<BTreeMap<String, f64>> {
    let inside;
    braced!(inside in input);
    let mut values = BTreeMap::new();
    for (name, value) in inside.parse_terminated(value, Token![,])? {
        if values.insert(name.to_string(), value).is_some() {
            return Err(twice(&name));
        }
    }
    Ok(values)
}

fn value(input: ParseStream) -> syn::Result<(Ident, f64)> {
    let name: Ident = input.parse()?;
    input.parse::<Token![=]>()?;
    let sign = if input.parse::<Option<Token![-]>>()?.is_some() { -1.0 } else { 1.0 };
    let (size, suffix, span) = if input.peek(LitInt) {
        let number: LitInt = input.parse()?;
        (number.base10_parse::<f64>()?, number.suffix().to_owned(), number.span())
    } else {
        let number: LitFloat = input.parse()?;
        (number.base10_parse()?, number.suffix().to_owned(), number.span())
    };
    if suffix.is_empty() {
        return Ok((name, sign * size));
    }
    let message = format!(
        "set: `{name}` ends in `{suffix}`; expected a number without suffix, in SI units as for `derive --set`: 0.3 for \
         300 mm"
    );
    Err(syn::Error::new(span, message))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_choice_is_read() {
        let text = r#""models/press.toml", scalar = f32, answers = ["law", "rates,bias"], keep = ["m"],
            set = { M = 8, z = -0.5 }, effort = all, core = cortex_m4, shared_work = true,"#;
        let Choices { path, options } = syn::parse_str(text).expect("it reads");
        assert_eq!(path, "models/press.toml");
        assert_eq!(options.emit.scalar, ScalarType::F32);
        assert_eq!(options.answers, ["law", "rates,bias"]);
        assert_eq!(options.parameters.keep, ["m"]);
        let values: Vec<(String, f64)> = options.parameters.values.into_iter().collect();
        assert_eq!(values, [("M".to_owned(), 8.0), ("z".to_owned(), -0.5)]);
        assert_eq!(options.settings.effort, Effort::All);
        assert_eq!(options.emit.core, Some(Core::CortexM4));
        assert!(options.emit.shared_work);
    }

    #[test]
    fn what_is_not_known_is_named() {
        for (text, message) in [
            ("press", "expected string literal"),
            ("\"p.toml\", speed = 3", "unknown choice `speed`"),
            ("\"p.toml\", scalar = i32", "scalar: expected f32"),
            ("\"p.toml\", effort = most", "effort: expected none"),
            ("\"p.toml\", core = z80", "core: expected cortex_m4"),
            ("\"p.toml\", shared_work = 1", "expected boolean literal"),
            ("\"p.toml\" scalar = f32", "expected `,`"),
            ("\"p.toml\", scalar = f32, scalar = f64", "`scalar` is there twice; keep one of them"),
            ("\"p.toml\", keep = [], effort = all, keep = []", "`keep` is there twice"),
            ("\"p.toml\", set = { m = 1.0, M = 1.0, m = 2.0 }", "`m` is there twice"),
            ("\"p.toml\", set = { l = 300_mm }", "`l` ends in `mm`; expected a number without suffix, in SI"),
            ("\"p.toml\", set = { l = -2i64 }", "`l` ends in `i64`"),
            ("\"p.toml\", set = { l = 1e3f32 }", "`l` ends in `f32`"),
            ("\"p.toml\", set = { l = true }", "expected floating point literal"),
        ] {
            let said = syn::parse_str::<Choices>(text).err().map(|e| e.to_string()).unwrap_or_default();
            assert!(said.contains(message), "{text}: {said}");
        }
    }
}
