//! Finds a subject by name: a mechanism, a scene or a world.

use super::body::Body;
use super::mechanism::Mechanism;
use super::subject::Subject;
use super::world::World;
use crate::engine::EngineKind;
use crate::failure::Failure;
use crate::model_argument;
use crate::scene::read::is_scene;

/// The subject of this name or path.
///
/// # Errors
/// [`Failure::Wrong`] if there is none, or with what is wrong in it.
pub fn open(name: &str, engine: EngineKind) -> Result<Box<dyn Subject>, Failure> {
    let path = model_argument::find(name)?;
    Ok(if model_argument::is_world(&path) {
        Box::new(World::open(name, &path, &[])?)
    } else if is_scene(&path) {
        Box::new(Body::open(name, &path.display().to_string(), &[])?)
    } else {
        Box::new(Mechanism::open(name, engine)?)
    })
}
