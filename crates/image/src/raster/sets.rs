//! Disjoint sets: finds connected pixels or runs of pixels in one pass over an image.
//!
//! Source: Tarjan, "Efficiency of a good but not linear set union algorithm", 1975 (here with path halving and the smaller
//! number as the root).

/// Sets of numbers that are counted from 0.
#[derive(Debug, Clone, Default)]
pub struct Sets {
    parents: Vec<u32>,
}

impl Sets {
    /// Adds a set with one element and returns its number.
    pub fn add(&mut self) -> u32 {
        let number = self.parents.len() as u32;
        self.parents.push(number);
        number
    }

    /// Numbers that were given.
    #[must_use]
    pub fn len(&self) -> usize {
        self.parents.len()
    }

    /// Whether none was given.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.parents.is_empty()
    }

    /// The smallest number of the set that this one is in.
    pub fn root(&mut self, mut number: u32) -> u32 {
        while self.parents[number as usize] != number {
            self.parents[number as usize] = self.parents[self.parents[number as usize] as usize];
            number = self.parents[number as usize];
        }
        number
    }

    /// Makes one set of two; its root.
    pub fn join(&mut self, a: u32, b: u32) -> u32 {
        let (a, b) = (self.root(a), self.root(b));
        self.parents[a.max(b) as usize] = a.min(b);
        a.min(b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_joined_has_the_smallest_number_for_a_root() {
        let mut sets = Sets::default();
        for number in 0..10 {
            assert_eq!(sets.add(), number);
        }
        assert_eq!(sets.join(7, 3), 3);
        assert_eq!(sets.join(9, 7), 3);
        assert_eq!(sets.join(9, 1), 1);
        let roots: Vec<u32> = (0..10).map(|number| sets.root(number)).collect();
        assert_eq!(roots, [0, 1, 2, 1, 4, 5, 6, 1, 8, 1]);
    }
}
