//! Known digits, containment laws and the edges of domains.

use super::{Enclosure, Precision};

#[test]
fn pi_has_its_forty_digits() {
    assert!(Enclosure::pi(Precision(140)).digits().starts_with("3.1415926535897932384626433832795028841971"));
}
