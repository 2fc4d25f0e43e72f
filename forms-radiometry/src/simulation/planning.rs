//! The plan: what a scene contains and what is asked of it decide which effects are simulated.
//!
//! ```text
//! forced by the file ─▶ as it says
//! no trigger         ─▶ off, and nothing is lost
//! a bound            ─▶ off, while the sum of what is dropped stays within half the tolerance of every answer
//! else               ─▶ on
//! ```
//! ‖L − L̃‖ ≤ ‖(T − T̃) L̃ + (Lₑ − L̃ₑ)‖/(1 − k): what is left out once is passed on by all reflections.

use super::answer::{Plan, PlannedEffect};
use super::effects::{Effects, forced};
use super::survey::Survey;
use crate::radiosity::orders;
use crate::scene::{Effect, Force, Scene, SceneError, not_simulated};

/// The part of the tolerance that what is dropped may take.
const DROPPED: f64 = 0.5;

/// Decides which effects of a scene are simulated.
///
/// # Errors
/// All that the scene asks for and that is not simulated, and light that could never leave.
pub fn plan(scene: &Scene) -> Result<Plan, Vec<SceneError>> {
    let refused = not_simulated(scene);
    if !refused.is_empty() {
        return Err(refused);
    }
    let survey = Survey::of(&scene.in_working_units());
    if let Some(surface) = survey.trap(scene) {
        let surface = &scene.surfaces[surface];
        let message =
            format!("light that meets the surface `{}` never leaves and is never absorbed", surface.name);
        let expected = "a reflectance below 1 on one of the surfaces around it, or an opening";
        return Err(vec![SceneError::new(&surface.place, message, expected)]);
    }
    let mut planning = Planning { scene, survey, left: DROPPED * scene.solve.tolerance };
    let effects: Vec<PlannedEffect> =
        Effect::ALL.iter().map(|&(_, effect)| planning.decide(effect)).collect();
    let kernels = Effects::of(&effects).kernels(scene);
    Ok(Plan { effects, kernels })
}

struct Planning<'s> {
    scene: &'s Scene,
    survey: Survey,
    /// What may still be dropped, relative to every answer.
    left: f64,
}

/// What was found of an effect.
struct Finding {
    /// Whether there is anything of it.
    present: bool,
    why: String,
    /// What dropping it can change at most, as the largest in the units of the answers, and relative to the answer it matters
    /// most to.
    bound: Option<[f64; 2]>,
}

impl Planning<'_> {
    fn decide(&mut self, effect: Effect) -> PlannedEffect {
        let finding = self.find(effect);
        let Finding { present, why, bound } = finding;
        let absolute = bound.map(|[absolute, _]| absolute);
        let planned = |on, orders, why, bound| PlannedEffect { effect, on, orders, why, bound };
        match forced(self.scene, effect) {
            Some(Force::Off) => planned(false, None, format!("the file turns it off; {why}"), absolute),
            Some(Force::On) => planned(true, None, format!("the file turns it on; {why}"), Some(0.0)),
            Some(Force::Orders(count)) => {
                let rest = self.survey.after_orders(count);
                planned(true, Some(count), format!("the file asks for {count}; {why}"), rest)
            }
            None if !present => planned(false, None, why, Some(0.0)),
            None => match bound {
                Some([absolute, relative]) if relative <= self.left => {
                    self.left -= relative;
                    planned(false, None, format!("it matters less than the tolerance; {why}"), Some(absolute))
                }
                _ => planned(true, None, why, Some(0.0)),
            },
        }
    }

    fn find(&self, effect: Effect) -> Finding {
        let absent = |why: &str| Finding { present: false, why: why.to_string(), bound: Some([0.0; 2]) };
        let present = |why: String, bound| Finding { present: true, why, bound };
        let survey = &self.survey;
        match effect {
            Effect::Direct if survey.emits => present("there are lights".to_string(), None),
            Effect::Direct => absent("nothing emits light"),
            Effect::Occlusion => match &survey.in_between {
                Some(why) => present(why.clone(), None),
                None => absent("nothing stands between surfaces or receivers"),
            },
            Effect::Interreflection if !survey.reflects => absent("no surface reflects"),
            Effect::Interreflection => present(self.interreflection(), survey.interreflection),
            Effect::Bands if self.scene.band_count() == 1 => absent("there is a single band"),
            Effect::Bands => match survey.band_spread {
                None => absent("every optical number is the same in all bands"),
                Some(bound) => present("optical numbers differ between bands".to_string(), Some(bound)),
            },
            Effect::Mirror => absent("no surface is a mirror, a conductor or a dielectric"),
            Effect::Absorption => absent("no medium absorbs"),
            Effect::Scattering => absent("no medium scatters"),
            Effect::Refraction => absent("the refractive index is 1 everywhere"),
            Effect::Dispersion => absent("nothing refracts"),
            Effect::Time => absent("no receiver asks for it"),
        }
    }

    fn interreflection(&self) -> String {
        let k = self.survey.contraction;
        let tolerance = self.scene.solve.tolerance;
        let Some(count) = orders(k, tolerance) else {
            return "surfaces that reflect see each other, and hardly any light is lost".to_string();
        };
        let plural = if count == 1 { "reflection" } else { "reflections" };
        format!("a reflection leaves at most {k:.2} of the light: {count} {plural} to {tolerance:e}")
    }
}
