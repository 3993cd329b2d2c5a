// What files of the GNU C library's mathematics expect around them, as it is on a processor with SSE2 and with rounding to
// nearest, which is how FlatFitFab calls them. Its names for other libraries, and flags of exceptions, are left out.
#pragma once

#include <errno.h>
#include <fenv.h>
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#define attribute_hidden
#define hidden_def(name)
#define libm_alias_double(from, to)
#define libm_alias_double_other(from, to)
#define libm_alias_finite(from, to)
#define strong_alias(from, to)
#define LIBM_SVID_COMPAT 0

#define __always_inline inline __attribute__((always_inline))
#define __glibc_likely(x) __builtin_expect(!!(x), 1)
#define __glibc_unlikely(x) __builtin_expect(!!(x), 0)
#define __set_errno(number) (errno = (number))
#define __frexp frexp
#define __ldexp ldexp
#define sqrt __builtin_sqrt // one instruction; the compiler's library rounds twice

#define SET_RESTORE_ROUND(mode)
#define SET_RESTORE_ROUND_53BIT(mode)
#define math_check_force_underflow(x)
#define math_check_force_underflow_nonneg(x)
#define math_force_eval(x) ((void)(x))
#define math_narrow_eval(x) (x)
#define math_opt_barrier(x) (x)
#define FIX_INT_FP_CONVERT_ZERO 0
#define USE_FMAX_BUILTIN 0
#define USE_FMIN_BUILTIN 0

#define HIGH_ORDER_BIT_IS_SET_FOR_SNAN 0
#define LITTLE_ENDI 1
#define HIGH_HALF 1
#define LOW_HALF 0
#define EXTRACT_WORDS64(bits, number) memcpy(&(bits), &(double){number}, sizeof(double))
#define INSERT_WORDS64(number, bits) memcpy(&(number), &(uint64_t){bits}, sizeof(double))

// Its kinds of numbers are in an order.
#undef fpclassify
#undef FP_ZERO
#define FP_ZERO 2
#define fpclassify(x) __builtin_fpclassify(0, 1, 4, 3, FP_ZERO, x)
