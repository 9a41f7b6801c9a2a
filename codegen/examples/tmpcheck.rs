//! x
fn main() {
    for p in std::env::args().skip(1) {
        match smartbed_codegen::model::read(std::path::Path::new(&p)) {
            Ok(m) => println!("ok {} {:?}", m.name, m.order.len()),
            Err(e) => println!("{e}"),
        }
    }
}
