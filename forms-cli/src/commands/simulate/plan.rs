//! Output of the plan before the work: a table, or a JSON object for each effect and one for the
//! methods.

use crate::json::write_record;
use crate::layout::{WIDTH, columns, filled, wrap};
use crate::palette::Palette;
use forms_radiometry::output::rough;
use forms_radiometry::scene::{Receiver, ReceiverKind, Scene};
use forms_radiometry::simulation::{Method, Plan, PlannedEffect, Quantity, ReceiverMethod, UsedKernel};
use std::io::{self, Write};

/// Smallest width of the reasons in columns, even if the names before them are long.
const NARROWEST_REASON: usize = 30;

/// Explanation of the column of bounds.
const MEANING: &str = "bound: largest possible change of an answer by the omitted part of the effect";

/// JSON record of an effect.
#[derive(serde::Serialize)]
struct Record<'a> {
    effect: &'a str,
    on: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    orders: Option<u32>,
    why: &'a str,
    bound: Option<f64>,
}

/// JSON record of the methods.
#[derive(serde::Serialize)]
struct MethodRecord<'a> {
    method: Vec<&'static str>,
    receivers: Vec<ReceiverRecord<'a>>,
}

/// Methods of a receiver in the record of the methods.
#[derive(serde::Serialize)]
struct ReceiverRecord<'a> {
    receiver: &'a str,
    method: Vec<&'static str>,
    why: &'a str,
}

impl<'a> ReceiverRecord<'a> {
    fn of(ReceiverMethod { receiver, methods, why }: &'a ReceiverMethod) -> Self {
        Self { receiver, method: names(methods), why }
    }
}

/// Writes the plan as a table or as lines of JSON.
pub(super) fn show(plan: &Plan, scene: &Scene, json: bool, output: &mut dyn Write) -> io::Result<()> {
    if json {
        lines(plan, output)?;
        let receivers = plan.receiver_methods().iter().map(ReceiverRecord::of).collect();
        return write_record(output, &MethodRecord { method: names(&plan.methods()), receivers });
    }
    table(plan, scene, output)
}

fn names(methods: &[Method]) -> Vec<&'static str> {
    methods.iter().map(|method| method.name()).collect()
}

fn lines(plan: &Plan, output: &mut dyn Write) -> io::Result<()> {
    plan.effects().iter().try_for_each(|planned| {
        let PlannedEffect { effect, on, orders, why, bound } = planned;
        write_record(output, &Record { effect: effect.name(), on: *on, orders: *orders, why, bound: *bound })
    })
}

/// Writes a line for each effect: whether it is simulated, the bound on omitting it or its higher
/// orders, and the reason.
fn table(plan: &Plan, scene: &Scene, output: &mut dyn Write) -> io::Result<()> {
    let palette = Palette::of_output();
    let title = if scene.name.is_empty() { "Plan".to_owned() } else { format!("Plan of {}", scene.name) };
    writeln!(output, "{}", palette.heading(&title))?;
    let head = ["effect".to_owned(), "simulated".to_owned(), format!("bound [{}]", units(scene))];
    let rows = plan.effects().iter().map(|planned| {
        [planned.effect.name().to_owned(), extent(planned), rough(planned.bound.unwrap_or(f64::INFINITY))]
    });
    let rows: Vec<[String; 3]> = std::iter::once(head).chain(rows).collect();
    let lines = columns(&rows, [false, false, false]);
    let indent = lines.iter().map(|line| line.chars().count()).max().unwrap_or(0) + 2;
    let whys = std::iter::once("why").chain(plan.effects().iter().map(|planned| planned.why.as_str()));
    for (place, (line, why)) in lines.iter().zip(whys).enumerate() {
        for line in beside(line, indent, why) {
            writeln!(output, "{}", if place == 0 { palette.quiet(&line) } else { line })?;
        }
    }
    for line in wrap(MEANING, 2) {
        writeln!(output, "{}", palette.quiet(&line))?;
    }
    methods(plan, output)?;
    writeln!(output)?;
    kernels(plan.kernels(), palette, output)
}

/// Writes the methods and their reason; for each receiver where receivers differ.
fn methods(plan: &Plan, output: &mut dyn Write) -> io::Result<()> {
    let of = |methods: &[Method]| names(methods).join(", or ");
    writeln!(output, "  method: {}", of(&plan.methods()))?;
    let Some((first, others)) = plan.receiver_methods().split_first() else { return Ok(()) };
    let is_one_reason = others.iter().all(|own| own.why == first.why);
    if is_one_reason {
        let lines = beside("reason:", "reason: ".len(), &first.why);
        lines.iter().try_for_each(|line| writeln!(output, "{line}"))?;
    }
    if is_one_reason && others.iter().all(|own| own.methods == first.methods) {
        return Ok(());
    }
    let all = || plan.receiver_methods().iter();
    let rows = all().map(|own| [own.receiver.clone(), of(&own.methods)]);
    let rows: Vec<[String; 2]> =
        std::iter::once(["receiver", "method"].map(str::to_owned)).chain(rows).collect();
    let lines = columns(&rows, [false, false]);
    let indent = lines.iter().map(|line| line.chars().count()).max().unwrap_or(0) + 2;
    let whys = std::iter::once("why").chain(all().map(|own| own.why.as_str()));
    for (line, why) in lines.iter().zip(whys) {
        let why = if is_one_reason { "" } else { why };
        beside(line, indent, why).iter().try_for_each(|line| writeln!(output, "{line}"))?;
    }
    Ok(())
}

/// Writes a line for each kernel that runs: the number of operations per value, and its purpose.
fn kernels(used: &[UsedKernel], palette: Palette, output: &mut dyn Write) -> io::Result<()> {
    if used.is_empty() {
        return Ok(());
    }
    let head = ["kernel", "operations"].map(str::to_owned);
    let count = |kernel: &UsedKernel| match kernel.without.as_slice() {
        [] => kernel.operations.to_string(),
        _ => format!("{} of {}", kernel.operations, kernel.operations_of_all),
    };
    let rows = used.iter().map(|kernel| [kernel.name.to_owned(), count(kernel)]);
    let rows: Vec<[String; 2]> = std::iter::once(head).chain(rows).collect();
    let lines = columns(&rows, [false, true]);
    let indent = lines.iter().map(|line| line.chars().count()).max().unwrap_or(0) + 2;
    let purposes = std::iter::once("computes".to_owned()).chain(used.iter().map(purpose));
    for (place, (line, purpose)) in lines.iter().zip(purposes).enumerate() {
        for line in beside(line, indent, &purpose) {
            writeln!(output, "{}", if place == 0 { palette.quiet(&line) } else { line })?;
        }
    }
    writeln!(output)
}

/// Describes the purpose of a kernel, and the effects that its running code omits.
fn purpose(kernel: &UsedKernel) -> String {
    match kernel.without.as_slice() {
        [] => kernel.what.to_owned(),
        without => format!("{}, without {}", kernel.what, without.join(", ")),
    }
}

/// Appends a text to a line; the text continues below in the same column.
fn beside(line: &str, indent: usize, text: &str) -> Vec<String> {
    let room = WIDTH.saturating_sub(indent + 2).max(NARROWEST_REASON);
    let fits = |line: &str, word: &str| line.chars().count() + 1 + word.chars().count() <= room;
    let parts = filled(text, fits);
    let first = parts.first().map_or("", String::as_str);
    let first = std::iter::once(format!("  {line:indent$}{first}").trim_end().to_owned());
    first.chain(parts.iter().skip(1).map(|part| format!("  {:indent$}{part}", ""))).collect()
}

fn extent(planned: &PlannedEffect) -> String {
    match (planned.on, planned.orders) {
        (false, _) => "off".to_owned(),
        (true, None) => "on".to_owned(),
        (true, Some(1)) => "1 order".to_owned(),
        (true, Some(orders)) => format!("{orders} orders"),
    }
}

/// Returns the units of the bounds: the units of the requested quantities.
fn units(scene: &Scene) -> String {
    let of = |receiver: &Receiver| match receiver.kind {
        ReceiverKind::Point { .. } | ReceiverKind::Points(_) | ReceiverKind::Sphere { .. } => {
            vec![Quantity::Irradiance.unit()]
        }
        ReceiverKind::Surface { .. } | ReceiverKind::Faces { .. } => {
            vec![Quantity::Irradiance.unit(), Quantity::Flux.unit()]
        }
        ReceiverKind::Ray { .. } | ReceiverKind::Camera(_) => vec![Quantity::Radiance.unit()],
    };
    let mut units: Vec<&str> = scene.receivers.iter().flat_map(of).collect();
    units.sort_unstable();
    units.dedup();
    units.join(", ")
}
