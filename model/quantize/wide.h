#pragma once

/// Marks a function whose loops are compiled for AVX2 and AVX-512 as well and chosen at load time.
/// Nothing is fused, so the results are the same to the last bit. Sanitizers do not know such
/// functions.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
#define PTM_QUANTIZE_WIDE [[gnu::target_clones("default", "avx2", "arch=x86-64-v4")]]
#else
#define PTM_QUANTIZE_WIDE
#endif
