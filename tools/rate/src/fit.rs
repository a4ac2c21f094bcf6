//! Weights of score terms that fit the stored pairs: logistic regression on the differences of two pages, the model of Bradley
//! and Terry (Biometrika 39, 1952).

use std::collections::BTreeSet;
use std::fmt::Write as _;

use anyhow::{Result, bail};
use serde_json::{Map, Value};

use crate::pairs::Pair;

/// Minimum number of pairs for a fit.
const FEWEST: usize = 20;
/// Parts of the cross-validation.
const FOLDS: usize = 5;
/// Steps of the gradient descent. The problem is convex, so more steps change nothing.
const STEPS: usize = 2000;
/// Size of a step, in units of standardised differences.
const RATE: f64 = 0.5;
/// Weight of the squared weights. It keeps them finite if terms separate all pairs.
const RIDGE: f64 = 0.01;

/// Prints the weights, and how often they agree with the ratings, also for pairs of albums that were left out
/// of the fit.
///
/// # Errors
/// If there are too few pairs.
pub(crate) fn report(pairs: &[Pair]) -> Result<String> {
    if pairs.len() < FEWEST {
        bail!("{} pairs are stored; rate at least {FEWEST} with `cargo xtask rate FOLDER...`", pairs.len());
    }
    let names: Vec<&String> =
        pairs.iter().flat_map(|pair| pair.better.keys()).collect::<BTreeSet<_>>().into_iter().collect();
    let rows: Vec<Vec<f64>> = pairs
        .iter()
        .map(|pair| names.iter().map(|name| value(&pair.better, name) - value(&pair.worse, name)).collect())
        .collect();
    let all: Vec<&[f64]> = rows.iter().map(Vec::as_slice).collect();
    let weights = fitted(&all);
    let today = vec![1.0; names.len()];

    let albums: Vec<&String> =
        pairs.iter().map(|pair| &pair.album).collect::<BTreeSet<_>>().into_iter().collect();
    // Pages of one album are similar, so a fold contains an album completely or not at all.
    let fold_of = |pair: &Pair| albums.iter().position(|album| **album == pair.album).unwrap_or(0) % FOLDS;
    let folds: BTreeSet<usize> = pairs.iter().map(fold_of).collect();
    let mut agreed = 0.0;
    for &fold in folds.iter().filter(|_| folds.len() > 1) {
        let of = |inside: bool| {
            let rows = pairs.iter().zip(&rows).filter(move |(pair, _)| (fold_of(pair) == fold) == inside);
            rows.map(|(_, row)| row.as_slice()).collect::<Vec<_>>()
        };
        let (left_out, rest) = (of(true), of(false));
        agreed += agreement(&fitted(&rest), &left_out) * left_out.len() as f64;
    }

    let mut text = format!("{} pairs of {} albums\n\nterm       weight\n", pairs.len(), albums.len());
    for (name, weight) in names.iter().zip(&weights) {
        let _ = writeln!(text, "{name:10} {weight:6.2}");
    }
    let percent = |part: f64| format!("{:.0} %", part * 100.0);
    let _ = writeln!(text, "\nagreement of the present score: {}", percent(agreement(&today, &all)));
    let _ = writeln!(text, "agreement of the fit: {}", percent(agreement(&weights, &all)));
    if folds.len() > 1 {
        let part = percent(agreed / pairs.len() as f64);
        let _ = writeln!(text, "agreement on albums left out of the fit: {part}");
    } else {
        text.push_str("no cross-validation: rate pages of a second album\n");
    }
    Ok(text)
}

fn value(terms: &Map<String, Value>, name: &str) -> f64 {
    terms.get(name).and_then(Value::as_f64).unwrap_or(0.0)
}

/// The part of the pairs whose better page has the higher sum. An equal sum counts half.
fn agreement(weights: &[f64], rows: &[&[f64]]) -> f64 {
    let sums = rows.iter().map(|row| row.iter().zip(weights).map(|(x, w)| x * w).sum::<f64>());
    let points = sums.map(|sum| {
        if sum > 0.0 {
            1.0
        } else if sum < 0.0 {
            0.0
        } else {
            0.5
        }
    });
    points.sum::<f64>() / rows.len().max(1) as f64
}

/// Weights of the differences, by gradient descent on differences of unit variance.
fn fitted(rows: &[&[f64]]) -> Vec<f64> {
    let width = rows.first().map_or(0, |row| row.len());
    let count = rows.len().max(1) as f64;
    let scales: Vec<f64> = (0..width)
        .map(|i| (rows.iter().map(|row| row[i] * row[i]).sum::<f64>() / count).sqrt())
        .map(|scale| if scale > 1e-9 { scale } else { f64::INFINITY })
        .collect();
    let mut weights = vec![0.0; width];
    for _ in 0..STEPS {
        let mut slope: Vec<f64> = weights.iter().map(|weight| RIDGE * weight).collect();
        for row in rows {
            let sum: f64 = (0..width).map(|i| weights[i] * row[i] / scales[i]).sum();
            let miss = 1.0 / (1.0 + sum.exp());
            for i in 0..width {
                slope[i] -= miss * row[i] / scales[i] / count;
            }
        }
        for (weight, slope) in weights.iter_mut().zip(&slope) {
            *weight -= RATE * slope;
        }
    }
    weights.iter().zip(&scales).map(|(weight, scale)| weight / scale).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use oorandom::Rand64;

    /// Pairs with known weights and some noise.
    fn pairs(count: usize, weights: [f64; 2]) -> Vec<Pair> {
        let mut random = Rand64::new(7);
        (0..count)
            .map(|i| {
                let mut page = || [random.rand_float() * 2.0, random.rand_float()];
                let [mut a, mut b] = [page(), page()];
                let sum = |page: [f64; 2]| page[0] * weights[0] + page[1] * weights[1];
                let likes_a = 1.0 / (1.0 + (sum(b) - sum(a)).exp()) > random.rand_float();
                if !likes_a {
                    std::mem::swap(&mut a, &mut b);
                }
                let terms = |page: [f64; 2]| {
                    Map::from_iter([("fit".to_owned(), page[0].into()), ("hero".to_owned(), page[1].into())])
                };
                Pair { album: format!("album {}", i % 6), seeds: [0, 1], better: terms(a), worse: terms(b) }
            })
            .collect()
    }

    #[test]
    fn the_weights_behind_the_pairs_are_found() {
        let pairs = pairs(4000, [2.0, -3.0]);
        let rows: Vec<Vec<f64>> = pairs
            .iter()
            .map(|pair| {
                ["fit", "hero"].map(|name| value(&pair.better, name) - value(&pair.worse, name)).to_vec()
            })
            .collect();
        let found = fitted(&rows.iter().map(Vec::as_slice).collect::<Vec<_>>());
        assert!((found[0] - 2.0).abs() < 0.3 && (found[1] + 3.0).abs() < 0.4, "{found:?}");
    }

    #[test]
    fn the_report_has_a_cross_validation_and_few_pairs_are_refused() -> Result<()> {
        let text = report(&pairs(200, [3.0, 1.0]))?;
        assert!(
            text.starts_with("200 pairs of 6 albums") && text.contains("left out of the fit: "),
            "{text}"
        );
        assert!(report(&pairs(FEWEST - 1, [1.0, 1.0])).is_err());
        Ok(())
    }

    #[test]
    fn equal_sums_count_half() {
        let agreement = agreement(&[1.0], &[&[1.0], &[-1.0], &[0.0], &[2.0]]);
        assert!((agreement - 0.625).abs() < 1e-12);
    }
}
