//! Groups of near-duplicates.

use super::fingerprint::distance;

/// The group number of each fingerprint, numbered in the order of their first members.
///
/// Leader clustering: the first member leads its group. A later photo joins the nearest leader within
/// `threshold` (the first of equal ones), or leads a new group. All groups are searched, so photos that
/// return later in a video or album are found too.
#[must_use]
pub fn leaders(fingerprints: &[u64], threshold: u32) -> Vec<usize> {
    leaders_by(fingerprints, &|_, _| threshold)
}

/// Like [`leaders`], with a separate threshold for each pair of indices.
#[must_use]
pub fn leaders_by(fingerprints: &[u64], threshold: &dyn Fn(usize, usize) -> u32) -> Vec<usize> {
    let mut leaders: Vec<usize> = Vec::new();
    let mut groups = Vec::with_capacity(fingerprints.len());
    for (i, &fingerprint) in fingerprints.iter().enumerate() {
        let far = |group: usize| distance(fingerprints[leaders[group]], fingerprint);
        let near = (0..leaders.len()).filter(|&group| far(group) <= threshold(leaders[group], i));
        let group = near.min_by_key(|&group| far(group));
        groups.push(group.unwrap_or(leaders.len()));
        if group.is_none() {
            leaders.push(i);
        }
    }
    groups
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_nearest_leader_wins_wherever_it_stands() {
        let fingerprints = [0, u64::MAX, 0b111, 0b111 << 61, 0b1_1111_1111, 0];
        // The fifth is 9 from the first leader; at 8 it leads, and the last still joins the first.
        assert_eq!(leaders(&fingerprints, 9), [0, 1, 0, 0, 0, 0]);
        assert_eq!(leaders(&fingerprints, 8), [0, 1, 0, 0, 2, 0]);
        assert_eq!(leaders(&fingerprints, 0), [0, 1, 2, 3, 4, 0]);
        assert_eq!(leaders(&[0, 0xFFFF, 0xFFF], 12), [0, 1, 1]);
    }

    proptest! {
        #[test]
        fn members_are_near_their_leader_and_leaders_apart(
            fingerprints in prop::collection::vec(0u64..4096, 0..60), threshold in 0u32..17,
        ) {
            let groups = leaders(&fingerprints, threshold);
            let count = groups.iter().max().map_or(0, |most| most + 1);
            let first: Vec<usize> = (0..count).map(|g| groups.iter().position(|&x| x == g).unwrap()).collect();
            prop_assert!(first.is_sorted());
            for (i, &group) in groups.iter().enumerate() {
                prop_assert!(distance(fingerprints[i], fingerprints[first[group]]) <= threshold);
            }
            for (a, &i) in first.iter().enumerate() {
                for &j in &first[..a] {
                    prop_assert!(distance(fingerprints[i], fingerprints[j]) > threshold);
                }
            }
        }
    }
}
