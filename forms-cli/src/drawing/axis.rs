//! A logarithmic axis, which maps values to positions on the paper.

/// Superscript digits for exponents.
const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];

/// Logarithmic axis along a length of paper.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Axis {
    /// Decimal logarithms of the values at both ends.
    pub(crate) powers: [f64; 2],
    /// Positions of both ends.
    pub(crate) paper: [f64; 2],
}

impl Axis {
    pub(crate) fn place(&self, value: f64) -> f64 {
        let part = (value.log10() - self.powers[0]) / (self.powers[1] - self.powers[0]);
        self.paper[0] + part * (self.paper[1] - self.paper[0])
    }

    /// Returns round values with their positions, at least this distance apart: 1, 2 and 5 of each
    /// decade, or only the first value of each decade, or of every second one, and so on.
    pub(crate) fn ticks(&self, apart: f64) -> Vec<(f64, String)> {
        let decade = ((self.paper[1] - self.paper[0]) / (self.powers[1] - self.powers[0])).abs();
        let is_wide = decade * 2_f64.log10() >= apart;
        let steps: &[f64] = if is_wide { &[1.0, 2.0, 5.0] } else { &[1.0] };
        let every = (apart / decade).ceil().max(1.0) as i32;
        let powers = self.powers[0].floor() as i32..=self.powers[1].ceil() as i32;
        let powers = powers.filter(|power| power.rem_euclid(every) == 0);
        let all = powers.flat_map(|power| steps.iter().map(move |&step| (step, power)));
        let placed = all.map(|(step, power)| (self.place(step * 10f64.powi(power)), tick(step, power)));
        let [least, most] = [self.paper[0].min(self.paper[1]) - 0.5, self.paper[0].max(self.paper[1]) + 0.5];
        placed.filter(|(place, _)| (least..=most).contains(place)).collect()
    }
}

/// Formats step · 10^power for an axis; long numbers are written as powers of ten.
fn tick(step: f64, power: i32) -> String {
    match power {
        -3..=3 => ((step * 10f64.powi(power + 3)).round() / 1e3).to_string(),
        4 if step == 1.0 => "10000".to_owned(),
        _ if step == 1.0 => format!("10{}", raised(power)),
        _ => format!("{step}·10{}", raised(power)),
    }
}

fn raised(power: i32) -> String {
    let digit = |c: char| c.to_digit(10).map_or('⁻', |digit| RAISED[digit as usize]);
    power.to_string().chars().map(digit).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_short() {
        let cases = [(1.0, -2), (5.0, -1), (2.0, 3), (1.0, 4), (5.0, 4), (1.0, 6), (1.0, -4), (2.0, -12)];
        let found = cases.map(|(step, power)| tick(step, power));
        assert_eq!(found, ["0.01", "0.5", "2000", "10000", "5·10⁴", "10⁶", "10⁻⁴", "2·10⁻¹²"]);
    }

    #[test]
    fn ticks_are_as_far_apart_as_asked_and_on_the_paper_in_either_direction() {
        for (powers, paper) in
            [([-1.3, 0.4], [50.0, 400.0]), ([-16.0, 2.0], [300.0, 40.0]), ([-3.0, 3.0], [0.0, 90.0])]
        {
            let ticks = Axis { powers, paper }.ticks(20.0);
            assert!(ticks.len() >= 3, "{ticks:?}");
            let (low, high) = (paper[0].min(paper[1]), paper[0].max(paper[1]));
            assert!(ticks.iter().all(|(place, _)| (low - 0.5..=high + 0.5).contains(place)), "{ticks:?}");
            assert!(ticks.windows(2).all(|two| (two[1].0 - two[0].0).abs() >= 20.0), "{ticks:?}");
        }
    }
}
