//! The plan: the contents of a scene and its queries decide which effects are simulated.
//!
//! ```text
//! forced by the file ─▶ as it says
//! no trigger         ─▶ off, and nothing is lost
//! a bound            ─▶ off, while all such effects stay within half the tolerance of every answer
//! else               ─▶ on
//! ```
//! ‖L − L̃‖ ≤ ‖(T − T̃) L̃ + (Lₑ − L̃ₑ)‖/(1 − k): all reflections pass on light that is omitted
//! once.

use super::Plan;
use super::method::{Choice, Solver, reason_for_paths};
use super::reduced_scene::without_forced;
use super::survey::Survey;
use crate::effects::{EffectSet, PlannedEffect, forcing};
use crate::paths::driver::{Computable, all_estimands};
use crate::paths::{Limits, World, endless, has_too_many_images, trap};
use crate::radiosity::orders;
use crate::scene::{Effect, Force, ForcedEffect, Receiver, ReceiverKind, Scene, SceneError, not_simulated};

/// Part of the tolerance left for omitted effects.
const DROPPED: f64 = 0.5;

/// Decides which effects of a scene are simulated.
///
/// # Errors
/// Everything that the scene asks for and that is not simulated, and light that could never leave.
pub fn plan(scene: &Scene) -> Result<Plan, Vec<SceneError>> {
    let refused = not_simulated(scene);
    if !refused.is_empty() {
        return Err(refused);
    }
    if let Some(reason) = reason_for_paths(&without_forced(scene)) {
        return plan_of_paths(scene, reason);
    }
    let survey = Survey::of(&scene.in_working_units());
    if let Some(surface) = survey.trap(scene) {
        let surface = &scene.surfaces[surface];
        let message =
            format!("light that reaches the surface `{}` never leaves and is never absorbed", surface.name);
        let expected = "a reflectance below 1 on one of the surfaces around it, or an opening";
        return Err(vec![SceneError::new(&surface.place, message, expected)]);
    }
    Ok(Plan::new(scene, decided(scene, survey), Choice::Cheaper))
}

/// Returns the plan of a scene that is simulated by path tracing for this reason.
fn plan_of_paths(scene: &Scene, reason: String) -> Result<Plan, Vec<SceneError>> {
    let is_pervious =
        |forced: &&ForcedEffect| forced.effect == Effect::Occlusion && forced.force == Force::Off;
    if let Some(forced) = scene.solve.forced.iter().find(is_pervious) {
        let message = format!("path tracing, which is needed because {reason}, cannot ignore occlusion");
        return Err(vec![SceneError::new(&forced.place, message, "no `occlusion`, or \"on\"")]);
    }
    let effects = decided(scene, Survey::without_bounds(scene));
    let mut plan = Plan::new(scene, effects, Choice::Paths(reason));
    let Solver::Paths { world, computable } = &plan.solver else { return Ok(plan) };
    if let Some(refused) = refused(world, &Limits::of(&plan.simulated.effects)) {
        return Err(vec![refused]);
    }
    tell_computed(&mut plan.effects, &world.scene, *computable);
    Ok(plan)
}

/// Returns the error for a scene that paths cannot simulate: light that never leaves, scattering
/// without an end, and too many image sources.
fn refused(world: &World, limits: &Limits) -> Option<SceneError> {
    let estimands = || all_estimands(&world.scene);
    // a path with a limited number of events ends everywhere
    let is_limited = world.scene.solve.events.is_some();
    let without_end = || trap(world).or_else(|| endless(world, estimands, limits));
    if is_limited { None } else { without_end() }.or_else(|| {
        let light = world.scene.lights.first().filter(|_| has_too_many_images(world))?;
        let message = "flat surfaces have too many image sources of point or distant lights";
        let expected = "fewer mirrors or refracting surfaces, or area lights: surfaces with a radiance";
        Some(SceneError::new(&light.place, message, expected))
    })
}

/// Adds to the reasons of absorption and scattering where these need no samples.
fn tell_computed(effects: &mut [PlannedEffect], scene: &Scene, computable: Computable) {
    let computed: Vec<&Receiver> =
        scene.receivers.iter().filter(|receiver| computable.has(receiver)).collect();
    let is_along = |receiver: &&&Receiver| matches!(receiver.kind, ReceiverKind::Ray { .. });
    let rays = computed.iter().filter(is_along).count();
    for planned in effects.iter_mut() {
        match planned.effect {
            Effect::Absorption if rays < computed.len() => {
                planned.why.push_str("; without samples at points");
            }
            Effect::Scattering if rays > 0 => planned.why.push_str("; without samples along rays"),
            _ => {}
        }
    }
}

/// Decides about every effect in turn. Returns the decisions, and the largest change by all omitted
/// effects, relative to an answer.
fn decided(scene: &Scene, survey: Survey) -> (Vec<PlannedEffect>, f64) {
    let contains = EffectSet::of_scene(scene);
    let most = DROPPED * scene.solve.tolerance;
    let mut planning = Planning { scene, survey, contains, left: most, dropped: 0.0 };
    let effects = Effect::ALL.iter().map(|&(_, effect)| planning.decide(effect)).collect();
    (effects, planning.dropped)
}

struct Planning<'s> {
    scene: &'s Scene,
    survey: Survey,
    contains: EffectSet,
    /// Remaining error budget for omitted effects, relative to every answer.
    left: f64,
    /// Error budget spent on omitted effects so far, relative to every answer.
    dropped: f64,
}

/// Finding about an effect.
struct Finding {
    /// Whether the scene contains the effect.
    present: bool,
    why: String,
    /// Largest change by omitting it: the largest in the units of the answers, and the change
    /// relative to the answer that it matters most to.
    bound: Option<[f64; 2]>,
}

impl Planning<'_> {
    fn decide(&mut self, effect: Effect) -> PlannedEffect {
        let finding = self.find(effect);
        let Finding { present, why, bound } = finding;
        let absolute = bound.map(|[absolute, _]| absolute);
        let planned = |on, orders, why, bound| PlannedEffect { effect, on, orders, why, bound };
        let forced = forcing(self.scene, effect);
        let who =
            if forced.is_some_and(|forced| forced.place.is_option()) { "--effects" } else { "the file" };
        match forced.map(|forced| forced.force) {
            Some(Force::Off) => planned(false, None, format!("{who} turns it off; {why}"), absolute),
            Some(Force::On) => planned(true, None, format!("{who} turns it on; {why}"), Some(0.0)),
            Some(Force::Orders(count)) => {
                let rest = self.survey.after_orders(count);
                planned(true, Some(count), format!("{who} limits it to order {count}; {why}"), rest)
            }
            None if !present => planned(false, None, why, Some(0.0)),
            None => match bound {
                Some([absolute, relative]) if relative <= self.left => {
                    self.left -= relative;
                    self.dropped += relative;
                    planned(false, None, format!("its bound is within the tolerance; {why}"), Some(absolute))
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
                Some(why) => present(why.clone(), survey.occlusion),
                None => absent("there are no occluders between surfaces or receivers"),
            },
            Effect::Interreflection if !survey.reflects => absent("no surface reflects"),
            Effect::Interreflection => present(self.interreflection(), survey.interreflection),
            Effect::Bands if self.scene.band_count() == 1 => absent("there is a single band"),
            Effect::Bands => match survey.band_spread {
                None => absent("all optical properties are the same in every band"),
                Some(bound) => present("optical properties differ between bands".to_string(), Some(bound)),
            },
            Effect::Mirror if self.contains.has(Effect::Mirror) => {
                present("there are mirrors or metals".to_string(), None)
            }
            Effect::Mirror => absent("no surface is a mirror or a metal"),
            Effect::Absorption if self.contains.has(Effect::Absorption) => {
                present("a medium absorbs".to_string(), None)
            }
            Effect::Absorption => absent("no medium absorbs"),
            Effect::Scattering if self.contains.has(Effect::Scattering) => {
                present("a medium scatters".to_string(), None)
            }
            Effect::Scattering => absent("no medium scatters"),
            Effect::Refraction if self.contains.has(Effect::Refraction) => {
                present("the refractive index differs between media".to_string(), None)
            }
            Effect::Refraction => absent("the refractive index is the same everywhere"),
            Effect::Dispersion if self.contains.has(Effect::Dispersion) => {
                present("a refractive index differs between bands".to_string(), None)
            }
            Effect::Dispersion => absent("no refractive index differs between bands"),
            Effect::Time if self.contains.has(Effect::Time) => {
                present("a receiver is time-resolved".to_string(), None)
            }
            Effect::Time => absent("no receiver is time-resolved"),
        }
    }

    fn interreflection(&self) -> String {
        if self.survey.interreflection.is_none() && self.survey.contraction >= 1.0 {
            return "diffuse surfaces reflect".to_string();
        }
        let k = self.survey.contraction;
        let tolerance = self.scene.solve.tolerance;
        let Some(count) = orders(k, tolerance) else {
            return "reflecting surfaces see each other, and hardly any light is lost".to_string();
        };
        let plural = if count == 1 { "reflection" } else { "reflections" };
        let most = at_most(k);
        format!(
            "each reflection keeps at most {most} of the light: {count} {plural} for tolerance {tolerance:e}"
        )
    }
}

/// Formats a number below 1, rounded up: to hundredths, or to one digit where hundredths would hide
/// it.
fn at_most(number: f64) -> String {
    if number > 0.0 && number < 0.01 {
        let unit = 10_f64.powf(number.log10().floor());
        return format!("{:.0e}", (number / unit).ceil() * unit);
    }
    // a rounding error on top of 0.9 does not make it 0.91
    format!("{:.2}", (100.0 * number * (1.0 - 1e-9)).ceil() / 100.0)
}

#[cfg(test)]
mod tests {
    use super::at_most;

    #[test]
    fn a_bound_is_rounded_up() {
        let cases = [
            (0.0, "0.00"),
            (0.0021, "3e-3"),
            (0.5, "0.50"),
            (0.501, "0.51"),
            (0.9 + 1e-15, "0.90"),
            (1.2e-7, "2e-7"),
        ];
        cases.into_iter().for_each(|(number, text)| assert_eq!(at_most(number), text, "{number}"));
    }
}
