#![deny(deprecated)]

forms::forms! {
    kernel mean_transmittance(sigma, length) = (1 - exp(-sigma*length))/sigma where sigma >= 0, length > 0;
}

fn main() {
    mean_transmittance(1.0, 2.0);
}
