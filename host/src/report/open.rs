//! Finds a subject by name: a mechanism, a scene or a world.

use super::body::Body;
use super::mechanism::Mechanism;
use super::subject::Subject;
use super::world::World;
use crate::engine::EngineKind;
use crate::failure::Failure;
use crate::file_kind::FileKind;
use crate::model_argument;

/// The subject of this name or path.
///
/// # Errors
/// [`Failure::Wrong`] if there is none, or with what is wrong in it.
pub fn open(name: &str, engine: EngineKind) -> Result<Box<dyn Subject>, Failure> {
    let path = model_argument::find(name)?;
    Ok(match FileKind::of(&path) {
        FileKind::World => Box::new(World::open(name, &path, &[])?),
        FileKind::Body => Box::new(Body::open(name, &path.display().to_string(), &[])?),
        _ => Box::new(Mechanism::open(name, engine)?),
    })
}
