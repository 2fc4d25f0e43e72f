//! Metals: their refractive indices by name, as means in the bands of red, green and blue.
//!
//! Source: the tables over wavelength of Mitsuba's data files (<https://github.com/mitsuba-renderer/mitsuba-data>,
//! folder `ior`), which are linear between their entries. They stem from luxpop.com and SOPRA.

/// Refractive index of a metal.
pub(super) struct Metal {
    pub(super) name: &'static str,
    /// Real part in each band.
    pub(super) eta: [f64; 3],
    /// Imaginary part in each band.
    pub(super) k: [f64; 3],
}

const fn metal(name: &'static str, eta: [f64; 3], k: [f64; 3]) -> Metal {
    Metal { name, eta, k }
}

#[expect(clippy::approx_constant, reason = "an index that is near π by chance")]
pub(super) const METALS: [Metal; 18] = [
    metal("Ag", [0.136_29, 0.125_14, 0.150_1], [4.127_2, 3.336_8, 2.462]),
    metal("Al", [1.486_9, 0.967_19, 0.621_73], [7.795_4, 6.679_9, 5.470_6]),
    metal("Au", [0.176_07, 0.411_78, 1.418], [3.302, 2.595_5, 1.880_7]),
    metal("Be", [3.461_9, 3.358_4, 3.088_3], [3.203_3, 3.174_5, 3.155_1]),
    metal("Cr", [3.637, 3.084_9, 1.974_8], [4.364_8, 4.419_6, 4.122_6]),
    metal("Cu", [0.242_67, 0.875_74, 1.162_4], [3.604_6, 2.644_7, 2.380_7]),
    metal("Hg", [2.074, 1.552_8, 1.064_7], [5.336_7, 4.649_3, 3.856_8]),
    metal("Ir", [2.559_3, 2.223_9, 1.833_2], [4.674, 4.300_2, 3.673_3]),
    metal("K", [0.050_465, 0.049_3, 0.042_817], [1.799, 1.442_3, 1.042_2]),
    metal("Li", [0.227_71, 0.210_33, 0.243_46], [3.014, 2.470_8, 1.907_1]),
    metal("Mo", [3.739_3, 3.686, 3.14], [3.552_5, 3.566_9, 3.465_5]),
    metal("Na_palik", [0.050_316, 0.058_412, 0.066_81], [2.708_9, 2.255_9, 1.787_6]),
    metal("Nb", [2.755_8, 2.914, 2.662_9], [2.887_8, 2.877_5, 2.819_9]),
    metal("Ni_palik", [2.020_8, 1.773_3, 1.635_7], [3.804_4, 3.250_6, 2.654_6]),
    metal("Rh", [2.197_5, 1.969_4, 1.718_1], [5.736_5, 5.016_7, 4.446_8]),
    metal("Ta", [1.616, 2.436_5, 2.812_9], [2.250_5, 1.865_6, 2.117_3]),
    metal("V_palik", [3.504, 3.651, 3.082_5], [2.987, 3.041_7, 3.363_1]),
    metal("W", [3.696_5, 3.490_2, 3.334_7], [2.913, 2.755_9, 2.529_9]),
];
