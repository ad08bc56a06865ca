//! What was asked for last, so that it need not be read again.

use std::{
    collections::VecDeque,
    sync::{Mutex, PoisonError},
};

/// A few values by key, the most recently used last. A value counts only as long as its stamp does.
#[derive(Debug)]
pub(crate) struct RecentCache<K, S, V> {
    most: usize,
    entries: Mutex<VecDeque<(K, S, V)>>,
}

impl<K: PartialEq, S: PartialEq, V: Clone> RecentCache<K, S, V> {
    /// Holds so many.
    pub(crate) fn new(most: usize) -> Self {
        Self { most, entries: Mutex::new(VecDeque::new()) }
    }

    /// The value of this key, if it is of this stamp.
    pub(crate) fn get(&self, key: &K, stamp: &S) -> Option<V> {
        let mut entries = self.entries.lock().unwrap_or_else(PoisonError::into_inner);
        let place = entries.iter().position(|(other, ..)| other == key)?;
        let entry = entries.remove(place)?;
        if entry.1 != *stamp {
            return None;
        }
        let value = entry.2.clone();
        entries.push_back(entry);
        Some(value)
    }

    /// Keeps a value, and forgets the one that nobody has asked for longest.
    pub(crate) fn put(&self, key: K, stamp: S, value: V) {
        let mut entries = self.entries.lock().unwrap_or_else(PoisonError::into_inner);
        entries.retain(|(other, ..)| *other != key);
        entries.push_back((key, stamp, value));
        while entries.len() > self.most {
            entries.pop_front();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_least_recent_goes_and_old_stamps_do_not_count() {
        let cache = RecentCache::new(2);
        cache.put(1, 'a', "one");
        cache.put(2, 'a', "two");
        assert_eq!(cache.get(&1, &'a'), Some("one"));
        cache.put(3, 'a', "three");
        assert_eq!((cache.get(&1, &'a'), cache.get(&2, &'a')), (Some("one"), None));
        assert_eq!((cache.get(&3, &'b'), cache.get(&3, &'a')), (None, None));
    }
}
