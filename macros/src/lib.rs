//! A model's equations of motion where the macro stands, without a build script.
//!
//! In: `mechanism!("press.toml")` and choices. Out: the items that a build script would write into `OUT_DIR`.
//! Everything else is `smartbed-codegen`'s; this crate reads the choices and carries errors to the macro's place.
//!
//! ```ignore
//! mod press {
//!     smartbed_macros::mechanism!("models/press.toml", scalar = f32, answers = ["inverse_dynamics"]);
//! }
//! ```
//!
//! The path counts from the folder of the package's `Cargo.toml`, as it does in a build script. The crate that uses the
//! macro depends on `smartbed-runtime`, whose numbers and traits the items name. It is compiled again when the model
//! changes or a file that it extends.

mod choices;
mod expand;

use proc_macro::{Group, Span, TokenStream, TokenTree};

/// The equations of motion of the model at a path: types, constants and functions as `smartbed-codegen` emits them.
///
/// Behind the path may stand, in any order: `scalar = f32` or `f64` (default), or a type's path in quotes;
/// `answers = [..]`, functions besides those that every mechanism has; `keep = [..]`, fixed parameters that stay
/// fields; `set = { M = 8.0 }`, other values of parameters; `effort = none`, `default` or `all`; `core = cortex_m4` or
/// `host`, what runs the code; `shared_work = true`, two functions more for `ode::rk4_shared`.
///
/// What is wrong with the model is an error at the path, with file, line and column of the model in its text. Warnings
/// of a model are not shown, because stable Rust lets no macro warn: `cargo smartbed check` and build scripts show
/// them.
#[proc_macro]
pub fn mechanism(input: TokenStream) -> TokenStream {
    let place = input.clone().into_iter().next().map_or_else(Span::call_site, |token| token.span());
    let text = input.to_string();
    // Choices are parsed by proc-macro2, which decides once, at its first use, whether it speaks to the compiler:
    // on a thread of its own it does not, so that they are read as in a test.
    let expanded = std::thread::scope(|scope| scope.spawn(|| expand::expand(&text)).join());
    let items = match expanded {
        Ok(Ok(items)) => items,
        Ok(Err(message)) => return error(&message, place),
        Err(_) => return error("the derivation has panicked; please report the model", place),
    };
    match items.parse() {
        Ok(items) => items,
        Err(unread) => {
            error(&format!("the generated code is not valid Rust; please report the model: {unread}"), place)
        }
    }
}

/// `compile_error!` at a place.
fn error(message: &str, place: Span) -> TokenStream {
    let text = format!("::core::compile_error!({message:?});");
    text.parse::<TokenStream>().map(|tokens| at(tokens, place)).unwrap_or_default()
}

/// The same tokens, all of this place.
fn at(tokens: TokenStream, place: Span) -> TokenStream {
    let moved = tokens.into_iter().map(|token| {
        let mut token = match token {
            TokenTree::Group(group) => {
                TokenTree::Group(Group::new(group.delimiter(), at(group.stream(), place)))
            }
            other => other,
        };
        token.set_span(place);
        token
    });
    moved.collect()
}
