//! Whether this processor can run this build, and whether this build is made for this processor.
//!
//! The standard library cannot be asked: what a build was compiled for, it takes for given. What stands here was compiled
//! for the same level as everything else, so it must be plain enough to need none of its instructions;
//! `scripts/compare_cpu_levels.sh` tries it on an emulated old processor.

#[cfg(target_arch = "x86_64")]
use raw_cpuid::{CpuId, ExtendedFeatures};
use std::process::ExitCode;

/// An instruction set that this build was compiled for and this processor lacks.
#[cfg(target_arch = "x86_64")]
pub(crate) fn missing_instructions() -> Option<&'static str> {
    let cpu = CpuId::new();
    if let Some(has) = cpu.get_feature_info() {
        let sets = [
            (cfg!(target_feature = "sse3"), has.has_sse3(), "SSE3"),
            (cfg!(target_feature = "ssse3"), has.has_ssse3(), "SSSE3"),
            (cfg!(target_feature = "sse4.1"), has.has_sse41(), "SSE4.1"),
            (cfg!(target_feature = "sse4.2"), has.has_sse42(), "SSE4.2"),
            (cfg!(target_feature = "popcnt"), has.has_popcnt(), "POPCNT"),
            (cfg!(target_feature = "avx"), has.has_avx() && has.has_oxsave(), "AVX"),
            (cfg!(target_feature = "fma"), has.has_fma(), "FMA"),
            (cfg!(target_feature = "f16c"), has.has_f16c(), "F16C"),
            (cfg!(target_feature = "movbe"), has.has_movbe(), "MOVBE"),
        ];
        for (needed, there, name) in sets {
            if needed && !there {
                return Some(name);
            }
        }
    }
    let extended = cpu.get_extended_feature_info();
    let more = |has: fn(&ExtendedFeatures) -> bool| extended.as_ref().is_some_and(has);
    let sets = [
        (cfg!(target_feature = "avx2"), more(ExtendedFeatures::has_avx2), "AVX2"),
        (cfg!(target_feature = "bmi1"), more(ExtendedFeatures::has_bmi1), "BMI1"),
        (cfg!(target_feature = "bmi2"), more(ExtendedFeatures::has_bmi2), "BMI2"),
        (cfg!(target_feature = "avx512f"), more(ExtendedFeatures::has_avx512f), "AVX-512F"),
        (cfg!(target_feature = "avx512bw"), more(ExtendedFeatures::has_avx512bw), "AVX-512BW"),
        (cfg!(target_feature = "avx512dq"), more(ExtendedFeatures::has_avx512dq), "AVX-512DQ"),
        (cfg!(target_feature = "avx512vl"), more(ExtendedFeatures::has_avx512vl), "AVX-512VL"),
    ];
    for (needed, there, name) in sets {
        if needed && !there {
            return Some(name);
        }
    }
    None
}

/// Other processors have one level.
#[cfg(not(target_arch = "x86_64"))]
pub(crate) fn missing_instructions() -> Option<&'static str> {
    None
}

/// Says so in one line.
pub(crate) fn refuse(missing: &str) -> ExitCode {
    eprintln!(
        "error: this build of endless needs {missing}, which this processor does not have: build it with \
         RUSTFLAGS=-Ctarget-cpu=x86-64 cargo install --locked, which is slower and makes the same bytes"
    );
    ExitCode::FAILURE
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
