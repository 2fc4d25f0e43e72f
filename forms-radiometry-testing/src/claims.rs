//! Known answers of scenes that are path traced. Each claim is a scene and the answers of its
//! receivers: by a closed form, by an integral that is evaluated here, or by a number of the
//! project's table of references.
//!
//! ```text
//! name, tables of a scene file ─▶ scene ─ seed, tolerance ─▶ answers, compared with true values
//! ```

mod absorption;
mod boundaries;
pub mod coverage;
mod emitters;
mod fog;
mod forced;
mod furnaces;
mod images;
mod integral;
mod mirrored_lamps;
mod mirrors;
mod slabs;
mod spectra;
mod times;

pub use furnaces::furnace_of;
pub use images::floor_in_haze;

use forms_radiometry::scene::{Scene, read};
use forms_radiometry::simulation::{
    Answer, Budget, ErrorKind, Job, Plan, Quantity, Unwatched, plan, simulate, simulate_job,
};

/// Scene whose answers are known.
pub struct Claim {
    /// Name of the claim.
    pub name: &'static str,
    text: String,
    expected: Vec<Expected>,
    /// Tolerance of the tests.
    pub tolerance: f64,
}

/// Known answer of a receiver.
struct Expected {
    receiver: &'static str,
    quantity: Quantity,
    band: Option<usize>,
    bin: Option<usize>,
    value: f64,
}

/// An answer, its true value, and the largest true value of its receiver in its band.
#[derive(Debug)]
pub struct Compared {
    /// The answer.
    pub answer: Answer,
    /// The true value.
    pub truth: f64,
    /// Largest true value of its receiver in its band.
    pub largest: f64,
}

impl Claim {
    fn new(name: &'static str, tables: &[String]) -> Self {
        Self { name, text: tables.concat(), expected: Vec::new(), tolerance: 5e-2 }
    }

    /// Returns the same claim with another tolerance of its tests.
    fn within(mut self, tolerance: f64) -> Self {
        self.tolerance = tolerance;
        self
    }

    fn expects(
        mut self,
        receiver: &'static str,
        quantity: Quantity,
        [band, bin]: [Option<usize>; 2],
        value: f64,
    ) -> Self {
        self.expected.push(Expected { receiver, quantity, band, bin, value });
        self
    }

    fn radiance(self, receiver: &'static str, value: f64) -> Self {
        self.expects(receiver, Quantity::Radiance, [None; 2], value)
    }

    fn irradiance(self, receiver: &'static str, value: f64) -> Self {
        self.expects(receiver, Quantity::Irradiance, [None; 2], value)
    }

    fn flux(self, receiver: &'static str, value: f64) -> Self {
        self.expects(receiver, Quantity::Flux, [None; 2], value)
    }

    /// Claims the fluence rate and the components of vector irradiance.
    fn fluence(self, receiver: &'static str, value: f64, vector: [f64; 3]) -> Self {
        let rate = self.expects(receiver, Quantity::FluenceRate, [None; 2], value);
        let component = |claim: Self, (axis, &value): (usize, &f64)| {
            claim.expects(receiver, Quantity::VectorIrradiance(axis), [None; 2], value)
        };
        vector.iter().enumerate().fold(rate, component)
    }

    /// Claims one value for each band.
    fn bands(self, receiver: &'static str, quantity: Quantity, values: &[f64]) -> Self {
        let of_band = |claim: Self, (band, &value): (usize, &f64)| {
            claim.expects(receiver, quantity, [Some(band), None], value)
        };
        values.iter().enumerate().fold(self, of_band)
    }

    /// Claims one value for each time bin.
    fn bins(self, receiver: &'static str, quantity: Quantity, values: &[f64]) -> Self {
        let of_bin = |claim: Self, (bin, &value): (usize, &f64)| {
            claim.expects(receiver, quantity, [None, Some(bin)], value)
        };
        values.iter().enumerate().fold(self, of_bin)
    }

    /// Returns the scene.
    pub fn scene(&self) -> Scene {
        read(&self.text, "claim.toml")
            .unwrap_or_else(|errors| panic!("{}: {}\n{}", self.name, errors[0], self.text))
    }

    /// Compares the answers for a seed and a tolerance with the known ones.
    pub fn compared(&self, seed: u64, tolerance: f64) -> Vec<Compared> {
        let mut scene = self.scene();
        (scene.solve.seed, scene.solve.tolerance) = (seed, tolerance);
        self.beside(&answers(self.name, &scene))
    }

    /// Compares the answers for a seed and a fixed number of samples with the known ones.
    pub fn sampled(&self, seed: u64, budget: Budget) -> Vec<Compared> {
        let mut scene = self.scene();
        scene.solve.seed = seed;
        let plan = planned(self.name, &scene);
        let job = Job { budget: Some(budget), ..Job::default() };
        let found = simulate_job(&plan, job, &Unwatched);
        self.beside(&found.unwrap_or_else(|error| panic!("{}: {error}", self.name)).answers)
    }

    /// Compares answers with the known ones.
    pub fn beside(&self, answers: &[Answer]) -> Vec<Compared> {
        self.expected.iter().map(|expected| self.one_beside(answers, expected)).collect()
    }

    fn one_beside(&self, answers: &[Answer], expected: &Expected) -> Compared {
        let is_meant = |answer: &&Answer| {
            answer.receiver == expected.receiver
                && answer.quantity == expected.quantity
                && answer.band == expected.band
                && answer.bin == expected.bin
        };
        let answer = answers.iter().find(is_meant);
        let answer = answer.unwrap_or_else(|| panic!("{}: {} is answered", self.name, expected.receiver));
        let is_beside =
            |other: &&Expected| other.receiver == expected.receiver && other.band == expected.band;
        let values = self.expected.iter().filter(is_beside).map(|other| other.value.abs());
        let largest = values.fold(0.0, f64::max);
        Compared { answer: answer.clone(), truth: expected.value, largest }
    }
}

impl Compared {
    /// Returns the deviation of the answer in its standard errors. `None` where it is exact except
    /// for this rounding error, relative to the largest value of its receiver; for a bound that
    /// holds; or where no sample found anything and the error covers the difference.
    pub fn deviations(&self, rounding: f64) -> Option<f64> {
        let off = (self.answer.value - self.truth).abs();
        let least = rounding * self.largest;
        let is_exact = match self.answer.kind {
            ErrorKind::Bound | ErrorKind::Estimate => off <= self.answer.error + least,
            ErrorKind::Sigma if self.answer.value == 0.0 => off <= self.answer.error,
            ErrorKind::Sigma => self.answer.error <= least && off <= least,
        };
        (!is_exact).then(|| off / self.answer.error)
    }
}

/// Simulates a scene as planned and returns the answers of its receivers.
pub fn answers(name: &str, scene: &Scene) -> Vec<Answer> {
    simulate(&planned(name, scene), &Unwatched).answers
}

fn planned(name: &str, scene: &Scene) -> Plan {
    plan(scene).unwrap_or_else(|errors| panic!("{name}: {}", errors[0]))
}

/// Returns a claim about a floor in haze that is wrong by a factor.
pub fn off_by(factor: f64) -> Claim {
    let mut claim = floor_in_haze();
    claim.expected.iter_mut().for_each(|expected| expected.value *= factor);
    claim
}

/// Returns all claims, including those that take long.
pub fn all_and_long() -> Vec<Claim> {
    let mut claims = all();
    claims.push(furnace_of(0.99));
    claims
}

/// Returns all claims, except those that take long.
pub fn all() -> Vec<Claim> {
    let families = [
        furnaces::claims(),
        slabs::claims(),
        absorption::claims(),
        boundaries::claims(),
        mirrors::claims(),
        mirrored_lamps::claims(),
        fog::claims(),
        emitters::claims(),
        spectra::claims(),
        forced::claims(),
        times::claims(),
        images::claims(),
    ];
    families.into_iter().flatten().collect()
}
