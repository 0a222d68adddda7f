//! For tests: everything runs with each instruction set that the processor has.

/// `on_all_levels!(|simd| { .. })` runs the block for each of them.
macro_rules! on_all_levels {
    (|$simd:ident| $block:block) => {{
        let level = fearless_simd::Level::new();
        let mut count = 0;
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        {
            if let Some($simd) = level.as_avx512() {
                $block
                count += 1;
            }
            if let Some($simd) = level.as_avx2() {
                $block
                count += 1;
            }
            if let Some($simd) = level.as_sse2() {
                $block
                count += 1;
            }
        }
        #[cfg(target_arch = "aarch64")]
        if let Some($simd) = level.as_neon() {
            $block
            count += 1;
        }
        assert!(count > 0, "no instruction set");
    }};
}

pub(crate) use on_all_levels;
