//! SHA-256 hashes of inputs, which are stored with results.

use sha2::{Digest, Sha256};

/// The hash in hexadecimal digits.
#[must_use]
pub fn hash(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}
