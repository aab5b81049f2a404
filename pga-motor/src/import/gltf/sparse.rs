//! The indices of a sparse accessor: which of its values are replaced.

use alloc::format;
use alloc::string::{String, ToString};

/// Indices as they stand in a buffer: little-endian, one after the other, each of as many bytes as `size`, which is 1, 2 or 4.
#[derive(Clone, Copy)]
pub(super) struct Indices<'a> {
    bytes: &'a [u8],
    size: usize,
}

impl<'a> Indices<'a> {
    pub(super) fn new(bytes: &'a [u8], size: usize) -> Self {
        Self { bytes, size }
    }

    pub(super) fn len(&self) -> usize {
        self.bytes.len() / self.size
    }

    fn get(&self, at: usize) -> usize {
        let mut word = [0; 4];
        word[..self.size].copy_from_slice(&self.bytes[at * self.size..][..self.size]);
        u32::from_le_bytes(word) as usize
    }

    /// Checks that they increase and are below a count, or says where they do not.
    pub(super) fn check(&self, count: usize) -> Result<(), String> {
        let mut least = 0;
        for index in (0..self.len()).map(|at| self.get(at)) {
            if index < least {
                return Err(format!("{index} after {}", least - 1));
            }
            if index >= count {
                return Err(index.to_string());
            }
            least = index + 1;
        }
        Ok(())
    }

    /// Where an index stands among these, which increase.
    pub(super) fn find(&self, index: usize) -> Option<usize> {
        let (mut start, mut end) = (0, self.len());
        while start < end {
            let middle = start + (end - start) / 2;
            if self.get(middle) < index {
                start = middle + 1;
            } else {
                end = middle;
            }
        }
        (start < self.len() && self.get(start) == index).then_some(start)
    }
}

#[cfg(test)]
mod tests {
    use alloc::vec::Vec;

    use super::Indices;

    #[test]
    fn indices_of_all_sizes_are_found() {
        let indices = [0_u32, 3, 4, 200, 255];
        for size in [1, 2, 4] {
            let bytes: Vec<u8> = indices.iter().flat_map(|index| index.to_le_bytes()[..size].to_vec()).collect();
            let list = Indices::new(&bytes, size);
            assert_eq!((list.len(), list.check(256)), (5, Ok(())));
            for index in 0..300_u32 {
                assert_eq!(list.find(index as usize), indices.iter().position(|&found| found == index));
            }
        }
        assert_eq!(Indices::new(&[], 4).find(0), None);
        let wide = [0x0304_u16.to_le_bytes(), 0x1203_u16.to_le_bytes()];
        assert_eq!(Indices::new(wide.as_flattened(), 2).find(0x1203), Some(1));
        let wide = 0x0001_0203_u32.to_le_bytes();
        assert_eq!(Indices::new(&wide, 4).find(0x0001_0203), Some(0));
    }

    #[test]
    fn indices_increase_below_the_count() {
        assert_eq!(Indices::new(&[0, 1, 6], 1).check(7), Ok(()));
        assert_eq!(Indices::new(&[0, 1, 7], 1).check(7), Err("7".into()));
        assert_eq!(Indices::new(&[0, 1, 1], 1).check(7), Err("1 after 1".into()));
        assert_eq!(Indices::new(&[4, 0], 1).check(7), Err("0 after 4".into()));
        assert_eq!(Indices::new(&[0], 1).check(0), Err("0".into()));
        assert_eq!(Indices::new(&[], 1).check(0), Ok(()));
    }
}
