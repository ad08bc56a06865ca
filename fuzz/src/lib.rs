//! The targets of `endless_fuzz` under libFuzzer: a program each in `fuzz_targets`.

use endless_fuzz::FuzzTarget;
use endless_world::Stream;

pub use libfuzzer_sys;

/// The program of a target.
#[macro_export]
macro_rules! fuzz {
    ($target:expr) => {
        use $crate::libfuzzer_sys;

        libfuzzer_sys::fuzz_target!(|bytes: &[u8]| $crate::judge(&$target, bytes));
        libfuzzer_sys::fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
            $crate::mutate(&$target, data, size, max_size, seed)
        });
    };
}

/// Has bytes read.
///
/// # Panics
/// When the answer is wrong, so that libFuzzer keeps the bytes.
pub fn judge(target: &FuzzTarget, bytes: &[u8]) {
    if let Err(wrong) = (target.judge)(bytes) {
        panic!("{wrong}");
    }
}

/// Changes the first `size` bytes of `data` in place, to at most `max_size`; returns how many there are then. By turns as
/// the target does, who knows the format, and as libFuzzer does, who knows what comparisons wanted.
pub fn mutate(target: &FuzzTarget, data: &mut [u8], size: usize, max_size: usize, seed: u32) -> usize {
    let mut stream = Stream::named(u64::from(seed), "fuzz", &[]);
    if stream.chance(0.5) {
        return libfuzzer_sys::fuzzer_mutate(data, size, max_size);
    }
    let changed = (target.mutate)(&data[..size], &mut stream);
    let size = changed.len().min(max_size);
    data[..size].copy_from_slice(&changed[..size]);
    size
}
