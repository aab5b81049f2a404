//! Which instructions slices, batches and packed kernels are worked out with: the one place that calls functions compiled for certain
//! instructions, and so the one with `unsafe`.

#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
pub(crate) mod sse2;

/// Something to be done.
pub(crate) trait Work {
    /// Does it. Always inlined, so that it is compiled for the instructions of its caller.
    fn run(self);
    /// The same where the caller has an instruction for a product fused with a sum.
    fn run_fused(self);
}

/// The instructions that a batch may use.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum InstructionSet {
    /// Those that the crate was compiled for: SSE2 in a default build for x86-64.
    Portable,
    /// AVX2 and FMA, with registers for 8 `f32`.
    Avx2,
    /// AVX-512, with registers for 16 `f32`.
    Avx512,
}

impl InstructionSet {
    /// All of them, from narrow to wide.
    pub const ALL: [Self; 3] = [Self::Portable, Self::Avx2, Self::Avx512];

    /// Whether this machine, and its operating system, have it. Without the feature `std` that cannot be asked, so only the portable
    /// one is.
    pub fn is_available(self) -> bool {
        match self {
            Self::Portable => true,
            #[cfg(all(feature = "std", target_arch = "x86_64"))]
            Self::Avx2 => std::is_x86_feature_detected!("avx2") && std::is_x86_feature_detected!("fma"),
            #[cfg(all(feature = "std", target_arch = "x86_64"))]
            Self::Avx512 => {
                Self::Avx2.is_available()
                    && std::is_x86_feature_detected!("avx512f")
                    && std::is_x86_feature_detected!("avx512vl")
                    && std::is_x86_feature_detected!("avx512dq")
            }
            #[cfg(not(all(feature = "std", target_arch = "x86_64")))]
            Self::Avx2 | Self::Avx512 => false,
        }
    }

    /// The one that batches on this thread use: the widest available, unless [`with_instruction_set`] says otherwise.
    pub fn in_use() -> Self {
        #[cfg(feature = "std")]
        if let Some(forced) = FORCED.get() {
            return forced;
        }
        let available = Self::ALL.into_iter().rev().find(|set| set.is_available());
        available.unwrap_or(Self::Portable)
    }
}

#[cfg(feature = "std")]
std::thread_local! {
    static FORCED: core::cell::Cell<Option<InstructionSet>> = const { core::cell::Cell::new(None) };
}

/// Does something in which batches on this thread use these instructions, to compare or measure them. `None`, and nothing is done, where
/// they are not available.
///
/// ```
/// use pga_motor::batch::{InstructionSet, with_instruction_set};
///
/// let in_use = with_instruction_set(InstructionSet::Portable, InstructionSet::in_use);
/// assert_eq!(in_use, Some(InstructionSet::Portable));
/// ```
#[cfg(feature = "std")]
pub fn with_instruction_set<R>(set: InstructionSet, work: impl FnOnce() -> R) -> Option<R> {
    /// Puts the choice back as it was, whatever happens in between.
    struct Restore(Option<InstructionSet>);

    impl Drop for Restore {
        fn drop(&mut self) {
            FORCED.set(self.0);
        }
    }

    if !set.is_available() {
        return None;
    }
    let _restore = Restore(FORCED.replace(Some(set)));
    Some(work())
}

/// Whether all of the crate is compiled for machines with an instruction for a product fused with a sum.
const ALWAYS_FUSES: bool = cfg!(any(target_feature = "fma", target_arch = "aarch64"));

/// Does work compiled for the instructions in use.
#[inline]
#[cfg_attr(all(feature = "std", target_arch = "x86_64"), expect(unsafe_code, reason = "each call is behind its check"))]
pub(crate) fn dispatch<W: Work>(work: W) {
    match InstructionSet::in_use() {
        // SAFETY: what is in use is available, so the machine has every instruction that the function was compiled for.
        #[cfg(all(feature = "std", target_arch = "x86_64"))]
        InstructionSet::Avx512 => unsafe { run_avx512(work) },
        // SAFETY: as above.
        #[cfg(all(feature = "std", target_arch = "x86_64"))]
        InstructionSet::Avx2 => unsafe { run_avx2(work) },
        _ if ALWAYS_FUSES => work.run_fused(),
        _ => work.run(),
    }
}

#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[target_feature(enable = "avx2,fma,avx512f,avx512vl,avx512dq")]
fn run_avx512<W: Work>(work: W) {
    work.run_fused();
}

#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[target_feature(enable = "avx2,fma")]
fn run_avx2<W: Work>(work: W) {
    work.run_fused();
}
