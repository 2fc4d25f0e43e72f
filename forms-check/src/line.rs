//! Lines of certificates.

use std::collections::HashMap;

/// Line of a certificate: a keyword and its argument.
pub(crate) type Line = (String, String);

/// Antiderivatives by the place of each range's variable, in the order in which they are needed,
/// each with the lines that prove its derivative.
pub(crate) type Offered = HashMap<usize, Vec<(String, Vec<Line>)>>;
