//! Forecasts: successive predictions of the end of the work become the remaining time, if they
//! agree for long enough.
//!
//! ```text
//! agree   all predictions since then are within a third of the remaining time of the last one
//! enough  they have agreed for a third of the remaining time
//! ```

/// Largest difference between predicted ends, relative to the remaining time.
const AGREEING: f64 = 1.0 / 3.0;
/// Time for which predictions have to agree, relative to the remaining time.
const LONG: f64 = 1.0 / 3.0;
/// Of predictions closer together than this part of the elapsed time, only the latest is kept.
const SOON: f64 = 0.01;

/// Predictions of the end.
#[derive(Clone, Debug, Default)]
pub(crate) struct Forecast(Vec<Foreseen>);

/// Prediction of the end, and the time at which it was made.
#[derive(Clone, Copy, Debug)]
struct Foreseen {
    at: f64,
    end: f64,
}

impl Forecast {
    /// Records the end that is predicted now. Returns the remaining time, if the prediction can be
    /// trusted.
    pub(crate) fn note(&mut self, now: f64, end: f64) -> Option<f64> {
        let left = (end - now).max(0.0);
        let agrees = |foreseen: &&Foreseen| (foreseen.end - end).abs() <= AGREEING * left;
        let since = self.0.iter().rev().take_while(agrees).last().map_or(now, |foreseen| foreseen.at);
        self.keep(Foreseen { at: now, end });
        (now - since >= LONG * left).then_some(left)
    }

    /// Stores a prediction. It replaces the last one if the one before that was made shortly
    /// before.
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
        // the remaining time always equals the elapsed time
        let mut forecast = Forecast::default();
        let told = (1..1000).filter_map(|i| forecast.note(f64::from(i), 2.0 * f64::from(i))).count();
        assert_eq!(told, 0);
        // the end moves once, and is trusted again later
        let mut forecast = Forecast::default();
        let ends = |i: u32| if i < 50 { 100.0 } else { 200.0 };
        let told: Vec<Option<f64>> = (0..200).map(|i| forecast.note(f64::from(i), ends(i))).collect();
        assert!(told[49].is_some() && told[50].is_none() && told[80].is_none() && told[90] == Some(110.0));
    }
}
