//! Whether this processor can run this build, and whether this build is made for this processor.
//!
//! The standard library cannot be asked: what a build was compiled for, it takes for given. What stands here was compiled
//! for the same level as everything else, so it must be plain enough to need none of its instructions: numbers in
//! registers, nothing copied or formatted. `scripts/compare_cpu_levels.sh` tries it on an emulated old processor.

/// What to tell who starts this build on a processor that lacks an instruction set which it was compiled for.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub fn missing_cpu_feature() -> Option<&'static str> {
    use raw_cpuid::native_cpuid::cpuid_count;

    macro_rules! need {
        ($register:ident: $($feature:literal is bit $bit:literal),+) => {
            $(if cfg!(target_feature = $feature) && $register & (1 << $bit) == 0 {
                return Some(concat!(
                    "error: this build of endless needs a processor with ", $feature, ", which this one has not: build \
                     it with RUSTFLAGS=-Ctarget-cpu=x86-64 cargo install --locked, which is slower and makes the same \
                     bytes\n"
                ));
            })+
        };
    }
    // Intel's manual, volume 2, CPUID: leaf 1, and leaf 7 where there is one.
    let features = cpuid_count(1, 0).ecx;
    need!(features: "sse3" is bit 0, "ssse3" is bit 9, "fma" is bit 12, "sse4.1" is bit 19, "sse4.2" is bit 20);
    need!(features: "movbe" is bit 22, "popcnt" is bit 23, "xsave" is bit 27, "avx" is bit 28, "f16c" is bit 29);
    let more = if cpuid_count(0, 0).eax >= 7 { cpuid_count(7, 0).ebx } else { 0 };
    need!(more: "bmi1" is bit 3, "avx2" is bit 5, "bmi2" is bit 8, "avx512f" is bit 16, "avx512dq" is bit 17);
    need!(more: "avx512cd" is bit 28, "avx512bw" is bit 30, "avx512vl" is bit 31);
    None
}

/// Other processors have one level.
#[cfg(not(target_arch = "x86_64"))]
pub fn missing_cpu_feature() -> Option<&'static str> {
    None
}

/// What to do where the processor could be used better than this build does.
pub(crate) fn advice() -> Option<&'static str> {
    #[cfg(all(target_arch = "x86_64", not(target_feature = "avx2")))]
    if std::is_x86_feature_detected!("avx2") && std::is_x86_feature_detected!("fma") {
        return Some(
            "warning: built without AVX2, so this is slower than need be; the bytes are the same. Install with \
             RUSTFLAGS=-Ctarget-cpu=x86-64-v3 cargo install --locked",
        );
    }
    None
}
