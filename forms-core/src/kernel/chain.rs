//! Addition chains: several powers of one number with few multiplications.

/// Largest exponent whose chain is searched for; larger exponents are halved instead.
const SEARCHED: u32 = 64;

/// Returns the steps that reach the `wanted` powers from the `given` ones. Each step (i, j)
/// multiplies the i-th and the j-th power into the (i+j)-th; the powers are reached in the order of
/// the steps.
pub(super) fn addition_chain(given: &[u32], wanted: &[u32]) -> Vec<(u32, u32)> {
    let mut known: Vec<u32> = given.to_vec();
    let mut steps = Vec::new();
    let mut wanted = wanted.to_vec();
    wanted.sort_unstable();
    for target in wanted {
        reach(target, &mut known, &mut steps);
    }
    steps
}

fn reach(target: u32, known: &mut Vec<u32>, steps: &mut Vec<(u32, u32)>) {
    if known.contains(&target) {
        return;
    }
    let longest = 2 * (u32::BITS - target.leading_zeros());
    let found = if target <= SEARCHED {
        (1..=longest).find_map(|length| search(target, length, known, &mut Vec::new()))
    } else {
        None
    };
    match found {
        Some(path) => {
            known.extend(path.iter().map(|(i, j)| i + j));
            steps.extend(path);
        }
        None => {
            let half = if target.is_multiple_of(2) { target / 2 } else { target - 1 };
            let rest = target - half;
            reach(half, known, steps);
            reach(rest, known, steps);
            known.push(target);
            steps.push((half, rest));
        }
    }
}

/// Searches for a chain of at most this length that ends in the target, in which each step uses the
/// previous one.
fn search(target: u32, length: u32, known: &[u32], path: &mut Vec<(u32, u32)>) -> Option<Vec<(u32, u32)>> {
    let last = path.last().map(|(i, j)| i + j);
    if last == Some(target) {
        return Some(path.clone());
    }
    let made: Vec<u32> = path.iter().map(|(i, j)| i + j).collect();
    let largest = known.iter().chain(&made).copied().max()?;
    let reachable = u64::from(largest) << length.min(32);
    if length == 0 || reachable < u64::from(target) {
        return None;
    }
    let mut all: Vec<u32> = known.iter().chain(&made).copied().collect();
    all.sort_unstable_by(|a, b| b.cmp(a));
    let starts = last.map_or_else(|| all.clone(), |last| vec![last]);
    for &i in &starts {
        for &j in &all {
            if i + j > target || all.contains(&(i + j)) {
                continue;
            }
            path.push((i, j));
            if let Some(found) = search(target, length - 1, known, path) {
                return Some(found);
            }
            path.pop();
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_take_the_fewest_multiplications() {
        let cases: [(&[u32], &[u32], usize); 9] = [
            (&[1], &[2], 1),
            (&[1], &[7], 4),
            (&[1], &[15], 5),
            (&[1], &[2, 3, 5], 3),
            (&[1], &[23], 6),
            (&[2, 1], &[3], 1),
            (&[2, 1], &[3, 5], 2),
            (&[1], &[64], 6),
            (&[1], &[1024], 10),
        ];
        for (given, wanted, expected) in cases {
            let steps = addition_chain(given, wanted);
            assert_eq!(steps.len(), expected, "{wanted:?} from {given:?}: {steps:?}");
        }
    }

    #[test]
    fn every_step_uses_powers_at_hand() {
        for target in 1..300 {
            let mut known = vec![1];
            for (i, j) in addition_chain(&[1], &[target]) {
                assert!(known.contains(&i) && known.contains(&j), "{target}");
                known.push(i + j);
            }
            assert!(known.contains(&target));
        }
    }
}
