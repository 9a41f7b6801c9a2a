//! SHA-256 of what a result is made from.

use sha2::{Digest, Sha256};

/// In letters.
#[must_use]
pub fn hash(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}
