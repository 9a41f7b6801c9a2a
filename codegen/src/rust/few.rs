//! A list of at most a few elements, without heap allocation.

use std::ops::{Deref, DerefMut};

/// Up to `N` elements.
#[derive(Clone, Copy, Debug)]
pub(super) struct Few<T, const N: usize> {
    items: [T; N],
    n: usize,
}

impl<T: Copy + Default, const N: usize> Default for Few<T, N> {
    #[inline]
    fn default() -> Self {
        Self { items: [T::default(); N], n: 0 }
    }
}

impl<T, const N: usize> Few<T, N> {
    /// Appends an element.
    ///
    /// # Panics
    /// If the list is full: a fault of the emitter.
    #[inline]
    pub fn push(&mut self, item: T) {
        self.items[self.n] = item;
        self.n += 1;
    }
}

impl<T: Copy + Default, const N: usize> FromIterator<T> for Few<T, N> {
    #[inline]
    fn from_iter<I: IntoIterator<Item = T>>(items: I) -> Self {
        let mut few = Self::default();
        items.into_iter().for_each(|item| few.push(item));
        few
    }
}

impl<T, const N: usize> Deref for Few<T, N> {
    type Target = [T];
    #[inline]
    fn deref(&self) -> &[T] {
        &self.items[..self.n]
    }
}

impl<T, const N: usize> DerefMut for Few<T, N> {
    #[inline]
    fn deref_mut(&mut self) -> &mut [T] {
        &mut self.items[..self.n]
    }
}
