//! A radiance where an irradiance is expected.

forms::forms! {
    param irradiance: W/m**2, radiance: W/m**2/sr;
    prove lambert: irradiance == pi*radiance;
    /// Twice a length, in seconds.
    pub kernel twice(length: m): s = 2*length;
}

fn main() {
    let _ = twice(1.0);
}
