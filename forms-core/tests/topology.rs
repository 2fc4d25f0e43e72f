//! Closed forms with and without a potential: every statement of a report is proved again.

use forms_core::check::{decide_all, read_theory};
use forms_core::decide::Verdict;
use forms_core::syntax::Source;
use forms_core::topology::{Line, Report, topology};

const SPACES: &str = "
    chart R3(x, y, z) where x**2 + y**2 + z**2 > 0;
    chart P2(u, v) where u**2 + v**2 > 0;
    chart Strip(a, b) where 0 < a < 1, b > 0;
    chart Half(p, q) where p > 0, p**2 + q**2 > 0;
    chart Line3(e, f, g) where (e - 1)**2 + (f - 2)**2 > 0, 1 < g < 2;
    chart Q4(w1, w2, w3, w4) where w1**2 + w2**2 + w3**2 + w4**2 > 0;
    chart Two(s, t) where s**2 + t**2 > 0, (s - 3)**2 + t**2 > 0;
    chart Plain(l, m, n);
    param R where R > 0;
    chart Shell(h, i, j) where h**2 + i**2 + j**2 > R**2;
    form beta = (x*dy^dz + y*dz^dx + z*dx^dy)/sqrt(x**2 + y**2 + z**2)**3;
    form more = beta*3 + d(x*y*dz);
    form inverse_square = (x*dx + y*dy + z*dz)/sqrt(x**2 + y**2 + z**2)**3;
    form angle = (u*dv - v*du)/(u**2 + v**2);
    form turned = -5*angle + d(u*v);
    form growth = (u*du + v*dv)/(u**2 + v**2);
    form open = u*dv;
    form product = b*da + a*db;
    form sector = (p*dq - q*dp)/(p**2 + q**2);
    form shifted = ((e - 1)*df - (f - 2)*de)/((e - 1)**2 + (f - 2)**2) + g*dg;
    form three = (w1*dw2^dw3^dw4 - w2*dw1^dw3^dw4 + w3*dw1^dw2^dw4 - w4*dw1^dw2^dw3)
        /(w1**2 + w2**2 + w3**2 + w4**2)**2;
    form twice = (s*dt - t*ds)/(s**2 + t**2);
    form unstated = (l*dm^dn + m*dn^dl + n*dl^dm)/sqrt(l**2 + m**2 + n**2)**3;
    form outside = (h*di^dj + i*dj^dh + j*dh^di)/sqrt(h**2 + i**2 + j**2)**3;
    let scalar = u*v;";

fn report(name: &str) -> Report {
    topology(&Source::new("spaces", SPACES), name).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// Returns the period stated in a report.
fn period(report: &Report) -> Option<String> {
    report.lines.iter().find_map(|line| match line {
        Line::Proved { statement, .. } => {
            statement.strip_prefix("integral")?.split_once(" == ").map(|(_, value)| value.to_owned())
        }
        _ => None,
    })
}

#[test]
fn forms_with_a_period_have_no_potential_on_the_whole_domain() {
    let cases = [
        ("beta", "4*pi"),
        ("more", "12*pi"),
        ("angle", "2*pi"),
        ("turned", "-10*pi"),
        ("shifted", "2*pi"),
        ("unstated", "4*pi"),
        ("outside", "4*pi"),
        ("three", "-2*pi**2"),
    ];
    for (name, value) in cases {
        let report = report(name);
        assert_eq!(period(&report).as_deref(), Some(value), "{name}:\n{report}");
        assert!(report.to_string().contains("none exists on the whole domain"), "{name}:\n{report}");
    }
}

#[test]
fn forms_without_a_period_have_one() {
    for (name, potential) in [
        ("inverse_square", "-1/sqrt(x**2 + y**2 + z**2)"),
        ("growth", "1/2*log(u**2 + v**2)"),
        ("product", "a*b"),
    ] {
        let report = report(name).to_string();
        assert!(report.contains(&format!("// A = {potential}\n")), "{name}:\n{report}");
        assert!(report.contains("== ") && !report.contains("none exists"), "{name}:\n{report}");
    }
}

#[test]
fn off_a_cut_a_form_with_a_period_has_a_potential() {
    for (name, cut) in [
        ("beta", "the half line x = y = 0, z <= 0 (a Dirac string)"),
        ("more", "a Dirac string"),
        ("angle", "the cut v = 0, u <= 0"),
        ("turned", "the cut v = 0, u <= 0"),
        ("outside", "the half line h = i = 0, j <= 0"),
    ] {
        let report = report(name).to_string();
        assert!(report.contains(cut) && report.contains("> 0    (proved)"), "{name}:\n{report}");
    }
}

#[test]
fn what_is_not_recognised_is_said() {
    assert!(report("open").to_string().contains("the form is not closed"), "{}", report("open"));
    assert!(report("twice").to_string().contains("more than one hole"), "{}", report("twice"));
    assert!(report("sector").to_string().contains("contracts to a point"), "{}", report("sector"));
    let refused = |name| topology(&Source::new("spaces", SPACES), name).map(|report| report.to_string());
    assert_eq!(refused("scalar"), Err("`scalar` is a scalar; only forms have periods and potentials".into()));
    assert_eq!(refused("nothing"), Err("`nothing` is not declared".into()));
}

#[test]
fn every_statement_of_a_report_is_proved_behind_its_items() {
    for name in ["beta", "more", "inverse_square", "angle", "turned", "growth", "product", "three", "shifted"]
    {
        let (mut text, mut count) = (SPACES.to_owned(), 0);
        for line in report(name).lines {
            match line {
                Line::Words(_) => {}
                Line::Item(item) => text.push_str(&format!("\n{item}")),
                Line::Proved { statement, .. } => {
                    count += 1;
                    text.push_str(&format!("\nprove told{count}: {statement};"));
                }
            }
        }
        let (mut theory, errors) = read_theory(&text);
        assert!(errors.is_empty() && count >= 2, "{name}: {errors:?}");
        let verdicts = decide_all(&mut theory);
        assert!(verdicts.iter().all(|verdict| matches!(verdict, Verdict::Proved(_))), "{name}: {verdicts:?}");
    }
}
