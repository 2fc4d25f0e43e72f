//! Effects that are off are not in the code: checked for members of a kernel by their operations,
//! and for scenes by the instructions that they execute.

use forms_kernels::gathered_light::{self, Effects};
use forms_radiometry::scene::{Effect, ReceiverKind, Scene, read};
use forms_radiometry::simulation::{Plan, PlannedEffect, Unwatched, UsedKernel, plan, simulate};
use forms_radiometry_testing::effects_code::callgrind::Counts;
use forms_radiometry_testing::effects_code::{callgrind, parts};
use rayon::prelude::*;
use std::collections::BTreeSet;

/// Environment variable that names the scene which this program simulates under callgrind.
const COUNTED: &str = "FORMS_COUNTED_SCENE";

/// Least number of operations at which a kernel is sure to be found. A kernel of fewer operations
/// can leave no line of its own where it is inlined: its operations have the lines of the
/// arithmetic. The members of `gathered_light` are found by the function that calls them.
const SEEN: usize = 10;

/// Kernels whose unguarded formulas the optimiser inlines whole, so that nothing but lines of the
/// arithmetic is left.
const INLINED: [&str; 2] = ["equiangular_pdf", "fresnel_dielectric"];

/// Returns all sets of effects of the kernel.
fn sets() -> impl Iterator<Item = Effects> {
    (0..16).map(|bits| {
        let is_on = |bit: u32| bits >> bit & 1 == 1;
        Effects { luminaires: is_on(0), surroundings: is_on(1), beams: is_on(2), interreflection: is_on(3) }
    })
}

#[test]
fn a_member_takes_the_operations_of_its_effects_and_no_others() {
    for effects in sets() {
        let Effects { luminaires, surroundings, beams, interreflection } = effects;
        let kinds =
            [luminaires, surroundings, beams, interreflection].into_iter().filter(|&is_on| is_on).count();
        // the sum over the kinds; the projected hemisphere times the kinds that are radiances; open
        // times outside
        let expected =
            kinds.saturating_sub(1) + usize::from(luminaires || surroundings) + usize::from(surroundings);
        assert_eq!(effects.operations(), expected, "{effects:?}");
    }
}

#[test]
fn a_member_gathers_what_the_whole_kernel_does_where_its_other_effects_vanish() {
    let light = [0.75, 0.5, 3.0, 2.5, 7.0];
    for effects in sets() {
        let Effects { luminaires, surroundings, beams, interreflection } = effects;
        let on = [luminaires, true, surroundings, beams, interreflection];
        let columns: Vec<[f64; 3]> =
            light.iter().zip(on).map(|(&x, is_on)| [if is_on { x } else { 0.0 }; 3]).collect();
        let [emitted, open, outside, beams, reflected] = [0, 1, 2, 3, 4].map(|place| &columns[place]);
        let (mut member, mut whole) = ([0.0; 3], [0.0; 3]);
        let columns = gathered_light::batch_with(effects);
        columns(emitted, open, outside, beams, reflected, &mut member).expect("one length");
        gathered_light::batch(emitted, open, outside, beams, reflected, &mut whole).expect("one length");
        let close = |(a, b): (&f64, &f64)| (a - b).abs() <= 4.0 * f64::EPSILON * b;
        assert!(member.iter().zip(&whole).all(close), "{effects:?}: {member:?}, {whole:?}");
    }
}

/// Returns a lamp above a floor of this reflectance, and the rest of the scene.
fn lamp(reflectance: f64, rest: &str) -> String {
    format!(
        "[[material]]\nname = \"grey\"\nkind = \"diffuse\"\nreflectance = {reflectance}\n\
         [[surface]]\nname = \"floor\"\nmaterial = \"grey\"\npolygon = [[0,0,0], [1,0,0], [1,1,0], [0,1,0]]\n\
         [[surface]]\nname = \"lamp\"\nmaterial = \"grey\"\nradiance = 1\n\
         polygon = [[0,0,1], [0,1,1], [1,1,1], [1,0,1]]\n{rest}[solve]\ntolerance = 0.2\n"
    )
}

const POINT: &str =
    "[[receiver]]\nname = \"here\"\nkind = \"point\"\nposition = [0.5, 0.5, 0]\nnormal = [0, 0, 1]\n";
const FLOOR: &str =
    "[[receiver]]\nname = \"floor\"\nkind = \"surface\"\nsurface = \"floor\"\ngrid = [2, 2]\n";
const BALL: &str = "[[receiver]]\nname = \"ball\"\nkind = \"sphere\"\nposition = [0.5, 0.4, 0.3]\n";
const RAY: &str =
    "[[receiver]]\nname = \"ray\"\nkind = \"ray\"\norigin = [0.5, 0.4, 0.5]\ndirection = [0.1, 0, -1]\n";
const PLATE: &str = "[[surface]]\nname = \"plate\"\nmaterial = \"grey\"\n\
                     polygon = [[0,0,0.5], [0.5,0,0.5], [0.5,0.5,0.5], [0,0.5,0.5]]\n";
const POINT_LIGHT: &str =
    "[[light]]\nname = \"bulb\"\nkind = \"point\"\nposition = [0.3, 0.3, 0.7]\nintensity = 1\n";
const SKY: &str = "[ambient]\nradiance = 1\n";

const MIRROR: &str = "[[material]]\nname = \"silver\"\nkind = \"mirror\"\nreflectance = 0.9\n\
                      [[surface]]\nname = \"wall\"\nmaterial = \"silver\"\npolygon = [[0,0,0], [0,1,0], [0,1,1], [0,0,1]]\n";
const GLASS: &str = "[[medium]]\nname = \"glass\"\nn = 1.5\n\
                     [[material]]\nname = \"glass\"\nkind = \"dielectric\"\ninside = \"glass\"\n\
                     [[surface]]\nname = \"ball of glass\"\nmaterial = \"glass\"\n\
                     sphere = { center = [0.5, 0.5, 0.4], radius = 0.2 }\n";
const MIST: &str =
    "[[medium]]\nname = \"mist\"\nsigma_s = 0.5\nsigma_a = 0.1\n[ambient]\nmedium = \"mist\"\n";
const ROUND_LAMPS: &str = "[[surface]]\nname = \"disk\"\nmaterial = \"grey\"\nradiance = 1\n\
                           disk = { center = [0.2, 0.2, 0.8], normal = [0, 0, -1], radius = 0.1 }\n\
                           [[surface]]\nname = \"bulb\"\nmaterial = \"grey\"\nradiance = 1\n\
                           sphere = { center = [0.8, 0.8, 0.8], radius = 0.1 }\n";
const PULSE: &str = "time = { start = 0, width = 1e-9, bins = 20 }\n";

/// Returns scenes that are simulated by path tracing.
fn scenes_of_paths() -> Vec<(&'static str, String)> {
    vec![
        ("mirror", lamp(0.5, &format!("{MIRROR}{POINT}"))),
        ("glass", lamp(0.5, &format!("{GLASS}{BALL}"))),
        ("mist", lamp(0.5, &format!("{MIST}{POINT}"))),
        ("round lamps in mist", lamp(0.0, &format!("{ROUND_LAMPS}{MIST}{BALL}"))),
        ("pulse", lamp(0.5, &format!("{POINT}{PULSE}"))),
    ]
}

/// Returns enough points that the light of a lamp at each is summed in `f64`, not in double-double.
fn many_points() -> String {
    (0..300).map(|index| POINT.replace("here", &format!("here {index}"))).collect()
}

/// Returns scenes by name, each with the kernels that it runs and the effects that their members do
/// not have.
fn scenes() -> Vec<(&'static str, String, String)> {
    let straight = "gathered_light - surroundings beams interreflection, edge_form_factor";
    let exchange = "exchange_density, edge_potential, irradiance";
    // closed forms of few points are added up in double-double, without `gathered_light`
    let precise = "edge_form_factor";
    vec![
        ("point", lamp(0.0, POINT), precise.to_owned()),
        ("many points", lamp(0.0, &many_points()), straight.to_owned()),
        ("ray", lamp(0.0, RAY), straight.to_owned()),
        ("plate", lamp(0.0, &format!("{PLATE}{POINT}")), precise.to_owned()),
        ("ball", lamp(0.0, BALL), format!("{precise}, solid_angle_triangle")),
        ("floor", lamp(0.0, FLOOR), format!("{straight}, {exchange}")),
        (
            "reflected",
            lamp(0.5, POINT),
            format!("gathered_light - surroundings beams, {straight}, exchange_density"),
        ),
        (
            "all kinds of light",
            // at a tolerance at which exact visibility is expected to take less than rays
            lamp(0.5, &format!("{POINT_LIGHT}{SKY}{POINT}{BALL}")).replace("= 0.2", "= 0.05"),
            "gathered_light, gathered_light - interreflection, edge_form_factor, solid_angle_triangle, \
             exchange_density"
                .to_owned(),
        ),
    ]
}

fn scene(name: &str) -> Scene {
    let pieces = scenes().into_iter().map(|(name, text, _)| (name, text));
    let mut all = pieces.chain(scenes_of_paths());
    let (_, text) = all.find(|(other, _)| *other == name).expect("a scene of this name");
    read(&text, name).unwrap_or_else(|errors| panic!("{}", errors[0]))
}

fn planned(scene: &Scene) -> Plan {
    plan(scene).unwrap_or_else(|errors| panic!("{}", errors[0]))
}

#[test]
fn the_plan_lists_the_kernels_of_a_scene_with_the_members_that_it_calls_for() {
    for (name, _, expected) in scenes() {
        let plan = planned(&scene(name));
        let kernels = plan.kernels();
        let found = kernels.iter().map(|kernel| match kernel.without.as_slice() {
            [] => kernel.name.to_owned(),
            without => format!("{} - {}", kernel.name, without.join(" ")),
        });
        assert_eq!(found.collect::<Vec<_>>().join(", "), expected, "{name}");
        for kernel in kernels {
            assert_eq!(
                kernel.operations < kernel.operations_of_all,
                !kernel.without.is_empty(),
                "{kernel:?}"
            );
        }
    }
}

/// Program whose instructions are counted: simulates a scene with some effects,
/// `SCENE:direct,occlusion`, without planning.
#[test]
fn the_counted_scene_has_answers() {
    let Ok(words) = std::env::var(COUNTED) else { return };
    let (name, on) = words.split_once(':').expect("a scene and its effects");
    let is_on = |name: &str| on.split(',').any(|other| other == name);
    let effect = |(name, effect)| PlannedEffect {
        effect,
        on: is_on(name),
        orders: None,
        why: String::new(),
        bound: None,
    };
    let plan = Plan::with_effects(&scene(name), Effect::ALL.into_iter().map(effect).collect(), false);
    let found = simulate(&plan, &Unwatched);
    assert!(found.answers.iter().all(|answer| answer.value.is_finite()), "{name}");
}

/// Returns the instructions of this program where it simulates a scene with some effects.
fn counted(scene: &str) -> Counts {
    let program = std::env::current_exe().expect("this program");
    let arguments = ["--exact", "the_counted_scene_has_answers", "--test-threads=1"];
    callgrind::counted(&program, &arguments, &[(COUNTED, scene)]).expect("valgrind runs")
}

/// Asserts that a scene executes nothing for the effects that are off, and that the kernels of the
/// plan run. Returns whether kernels that are inlined could be found.
fn assert_counted(name: &str, by_paths: bool) -> bool {
    let scene = scene(name);
    let plan = planned(&scene);
    let is_by_paths = plan.is_by_paths();
    assert_eq!(is_by_paths, by_paths, "{name}");
    let on = plan.effects().iter().filter(|planned| planned.on).map(|planned| planned.effect.name());
    // a receiver along a ray asks for the surface that the ray meets
    let looks = scene.receivers.iter().any(|receiver| matches!(receiver.kind, ReceiverKind::Ray { .. }));
    let scene = format!("{name}:{}", on.collect::<Vec<_>>().join(","));
    let counts = counted(&scene);
    assert!(parts::of_solver(&counts) > 1000, "{name}: nothing of the solver was found");
    // where nothing is inlined, functions identify the effects
    let is_sure = cfg!(debug_assertions) || parts::has_lines(&counts);
    let is_told = |planned: &&PlannedEffect| parts::effects(is_by_paths).any(|own| own == planned.effect);
    for planned in plan.effects().iter().filter(is_told) {
        let count = parts::of_effect(&counts, planned.effect);
        let is_right = if planned.on { count > 0 || !is_sure } else { count == 0 };
        assert!(is_right, "{name}: {} takes {count}", planned.effect.name());
    }
    let rays = parts::of_rays(&counts);
    // occluders are found along rays, too
    let hides = plan.effects().iter().any(|planned| planned.effect == Effect::Occlusion && planned.on);
    let has_use = is_by_paths || hides || looks;
    assert!(has_use || rays == 0, "{name}: {rays} instructions for rays without a use");
    let listed: BTreeSet<String> = plan.kernels().iter().map(|kernel| kernel.name.to_owned()).collect();
    let run = parts::kernels(&counts);
    assert!(run.is_subset(&listed), "{name}: {run:?} run, and {listed:?} are in the plan");
    let files: BTreeSet<&str> = listed.iter().filter_map(|kernel| parts::file_of(kernel)).collect();
    let of_lines = parts::kernel_files(&counts);
    assert!(of_lines.is_subset(&files), "{name}: {of_lines:?} run, and {files:?} are in the plan");
    if !parts::has_lines(&counts) {
        return false;
    }
    // the error decides between two methods of integration from surface to surface
    let by_error = ["exchange_density", "edge_potential"];
    let has_run = |kernel: &str| {
        run.contains(kernel) || parts::file_of(kernel).is_some_and(|file| of_lines.contains(file))
    };
    let is_seen = |kernel: &&UsedKernel| {
        kernel.name == "gathered_light" || kernel.operations >= SEEN && !INLINED.contains(&kernel.name)
    };
    let mut seen = plan.kernels().iter().filter(is_seen).map(|kernel| kernel.name);
    let unused = seen.find(|kernel| !by_error.contains(kernel) && !has_run(kernel));
    assert_eq!(unused, None, "{name}: is in the plan and does not run");
    true
}

#[test]
fn what_is_off_executes_nothing_and_the_kernels_that_run_are_those_of_the_plan() {
    const TEST: &str =
        "effects_code::what_is_off_executes_nothing_and_the_kernels_that_run_are_those_of_the_plan";
    if !forms_testing::is_installed("valgrind") {
        forms_testing::skipped(TEST, "valgrind", "no instructions are counted");
        return;
    }
    let paths = scenes_of_paths().into_iter().map(|(name, _)| (name, true));
    let all: Vec<_> = scenes().into_iter().map(|(name, ..)| (name, false)).chain(paths).collect();
    let is_without_lines = |&&(name, by_paths): &&(&'static str, bool)| !assert_counted(name, by_paths);
    let without_lines: Vec<_> = all.par_iter().filter(is_without_lines).collect();
    if !without_lines.is_empty() {
        let why = "kernels that are inlined cannot be found, so nothing says whether those of the plan run";
        forms_testing::skipped(TEST, "debug information", why);
    }
}
