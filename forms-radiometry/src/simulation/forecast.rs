//! Forecasts: ends of the work that are foreseen one after the other become the time that is left,
//! if they agree for long enough.
//!
//! ```text
//! agree   all ends since then are within a third of the time that is left of the last one
//! enough  they have agreed for a third of the time that is left
//! ```

/// By how much ends may differ, relative to the time that is left.
const AGREEING: f64 = 1.0 / 3.0;
/// How long they have to agree, likewise.
const LONG: f64 = 1.0 / 3.0;
/// Ends that are foreseen after less than this part of the time are not kept.
const SOON: f64 = 0.01;

/// The ends that were foreseen.
#[derive(Clone, Debug, Default)]
pub(super) struct Forecast(Vec<Foreseen>);

/// An end that was foreseen at some time.
#[derive(Clone, Copy, Debug)]
struct Foreseen {
    at: f64,
    end: f64,
}

impl Forecast {
    /// Takes the end that is foreseen now; gives the time that is left, if it can be trusted.
    pub(super) fn note(&mut self, now: f64, end: f64) -> Option<f64> {
        let left = (end - now).max(0.0);
        let agrees = |foreseen: &&Foreseen| (foreseen.end - end).abs() <= AGREEING * left;
        let since = self.0.iter().rev().take_while(agrees).last().map_or(now, |foreseen| foreseen.at);
        self.keep(Foreseen { at: now, end });
        (now - since >= LONG * left).then_some(left)
    }

    /// Keeps an end, in the place of the last one if that was foreseen just before.
    fn keep(&mut self, foreseen: Foreseen) {
        if let [.., before, _] = self.0[..]
            && foreseen.at - before.at < SOON * foreseen.at
        {
            self.0.pop();
        }
        self.0.push(foreseen);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steady_work_has_a_time_left_after_a_quarter() {
        let mut forecast = Forecast::default();
        let told: Vec<Option<f64>> = (0..=1000).map(|i| forecast.note(f64::from(i) / 10.0, 100.0)).collect();
        assert!(told[..=249].iter().all(Option::is_none), "{told:?}");
        assert!(told[251..].iter().enumerate().all(|(i, left)| {
            let true_left = 100.0 - (251 + i) as f64 / 10.0;
            left.is_some_and(|left| (left - true_left).abs() < 1e-9)
        }));
        assert!(forecast.0.len() < 500, "{}", forecast.0.len());
    }

    #[test]
    fn an_end_that_moves_away_is_not_told() {
        // there is always as much left as was done
        let mut forecast = Forecast::default();
        let told = (1..1000).filter_map(|i| forecast.note(f64::from(i), 2.0 * f64::from(i))).count();
        assert_eq!(told, 0);
        // it moves once, and is trusted again later
        let mut forecast = Forecast::default();
        let ends = |i: u32| if i < 50 { 100.0 } else { 200.0 };
        let told: Vec<Option<f64>> = (0..200).map(|i| forecast.note(f64::from(i), ends(i))).collect();
        assert!(told[49].is_some() && told[50].is_none() && told[80].is_none() && told[90] == Some(110.0));
    }
}
