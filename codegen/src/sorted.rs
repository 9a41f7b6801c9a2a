//! A map as a sorted list: for a handful of entries it takes less memory and fewer steps than a tree.

use std::ops::{Bound, Index, RangeBounds};
use std::slice;

/// Keys and values, ascending by key.
#[derive(Clone, PartialEq, Debug)]
pub struct Sorted<K, V>(Vec<(K, V)>);

/// Entries by reference.
pub type Iter<'m, K, V> = std::iter::Map<slice::Iter<'m, (K, V)>, fn(&'m (K, V)) -> (&'m K, &'m V)>;

impl<K, V> Default for Sorted<K, V> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<K: Ord, V> Sorted<K, V> {
    /// The place of a key, or the place where it belongs.
    #[inline]
    fn place(&self, key: &K) -> Result<usize, usize> {
        match self.0.last() {
            // Most maps are filled in ascending order.
            Some((last, _)) if last >= key => self.0.binary_search_by(|(k, _)| k.cmp(key)),
            _ => Err(self.0.len()),
        }
    }

    /// The value of a key.
    #[must_use]
    pub fn get(&self, key: &K) -> Option<&V> {
        self.place(key).ok().map(|place| &self.0[place].1)
    }

    /// Is the key there?
    #[must_use]
    pub fn contains_key(&self, key: &K) -> bool {
        self.place(key).is_ok()
    }

    /// Sets the value of a key.
    pub fn insert(&mut self, key: K, value: V) {
        match self.place(&key) {
            Ok(place) => self.0[place].1 = value,
            Err(place) => self.0.insert(place, (key, value)),
        }
    }

    /// Removes a key; returns its value, if it was there.
    pub fn remove(&mut self, key: &K) -> Option<V> {
        self.place(key).ok().map(|place| self.0.remove(place).1)
    }

    /// The entries whose keys are in the range.
    pub fn range(&self, keys: impl RangeBounds<K>) -> Iter<'_, K, V> {
        let start = match keys.start_bound() {
            Bound::Unbounded => 0,
            Bound::Included(low) => self.0.partition_point(|(key, _)| key < low),
            Bound::Excluded(low) => self.0.partition_point(|(key, _)| key <= low),
        };
        let end = match keys.end_bound() {
            Bound::Unbounded => self.0.len(),
            Bound::Included(high) => self.0.partition_point(|(key, _)| key <= high),
            Bound::Excluded(high) => self.0.partition_point(|(key, _)| key < high),
        };
        self.0[start..end.max(start)].iter().map(|(key, value)| (key, value))
    }
}

impl<K, V> Sorted<K, V> {
    /// Keeps the entries for which `kept` holds.
    pub fn retain(&mut self, mut kept: impl FnMut(&K, &mut V) -> bool) {
        self.0.retain_mut(|(key, value)| kept(key, value));
    }

    /// Number of entries.
    #[must_use]
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// No entry?
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The entry with the least key.
    #[must_use]
    pub fn first(&self) -> Option<(&K, &V)> {
        self.iter().next()
    }

    /// Entries, ascending.
    #[inline]
    pub fn iter(&self) -> Iter<'_, K, V> {
        self.0.iter().map(|(key, value)| (key, value))
    }

    /// Keys, ascending.
    pub fn keys(&self) -> impl DoubleEndedIterator<Item = &K> + ExactSizeIterator + Clone {
        self.0.iter().map(|(key, _)| key)
    }

    /// Values in the order of their keys.
    pub fn values(&self) -> impl DoubleEndedIterator<Item = &V> + ExactSizeIterator + Clone {
        self.0.iter().map(|(_, value)| value)
    }

    /// Mutable values in the order of their keys.
    pub fn values_mut(&mut self) -> impl DoubleEndedIterator<Item = &mut V> + ExactSizeIterator {
        self.0.iter_mut().map(|(_, value)| value)
    }
}

impl<K: Ord, V> Index<&K> for Sorted<K, V> {
    type Output = V;
    fn index(&self, key: &K) -> &V {
        self.get(key).expect("the key is there")
    }
}

impl<K: Ord, V> Extend<(K, V)> for Sorted<K, V> {
    fn extend<I: IntoIterator<Item = (K, V)>>(&mut self, entries: I) {
        let entries = entries.into_iter();
        self.0.reserve(entries.size_hint().0);
        entries.for_each(|(key, value)| self.insert(key, value));
    }
}

impl<K: Ord, V> FromIterator<(K, V)> for Sorted<K, V> {
    fn from_iter<I: IntoIterator<Item = (K, V)>>(entries: I) -> Self {
        let mut map = Self::default();
        map.extend(entries);
        map
    }
}

impl<'m, K, V> IntoIterator for &'m Sorted<K, V> {
    type Item = (&'m K, &'m V);
    type IntoIter = Iter<'m, K, V>;
    #[inline]
    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl<K, V> IntoIterator for Sorted<K, V> {
    type Item = (K, V);
    type IntoIter = std::vec::IntoIter<(K, V)>;
    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

#[cfg(test)]
mod tests {
    use super::Sorted;

    #[test]
    fn entries_stay_sorted_and_the_last_value_of_a_key_counts() {
        let mut map = Sorted::from_iter([(3, 'c'), (1, 'a'), (3, 'd'), (2, 'b')]);
        assert_eq!(map.iter().collect::<Vec<_>>(), [(&1, &'a'), (&2, &'b'), (&3, &'d')]);
        assert_eq!([map.get(&0), map.get(&2), map.get(&4)], [None, Some(&'b'), None]);
        assert_eq!((map.remove(&2), map.remove(&2), map.len()), (Some('b'), None, 2));
        assert_eq!(map.first(), Some((&1, &'a')));
    }

    #[test]
    fn ranges_end_where_they_say() {
        let map = Sorted::from_iter([1, 3, 5].map(|key| (key, ())));
        let keys = |found: super::Iter<'_, i32, ()>| found.map(|(key, ())| *key).collect::<Vec<_>>();
        assert_eq!(
            [keys(map.range(..3)), keys(map.range(..=3)), keys(map.range(2..))],
            [vec![1], vec![1, 3], vec![3, 5]]
        );
        assert!(keys(map.range(4..5)).is_empty());
    }
}
