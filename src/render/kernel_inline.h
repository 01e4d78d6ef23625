// TEMBLOR_KERNEL_INLINE: HWY_INLINE for the large parts of SIMD kernels, which then run without calls. With
// the address sanitizer, they are functions, because clang takes up to a minute to allocate the registers of
// a kernel of one piece: it has a call for each check.
#pragma once

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define TEMBLOR_KERNEL_INLINE HWY_NOINLINE
#endif
#endif
#ifndef TEMBLOR_KERNEL_INLINE
#define TEMBLOR_KERNEL_INLINE HWY_INLINE
#endif
