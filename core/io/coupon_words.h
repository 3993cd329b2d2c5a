// What the parts of a fit coupon are called in files. Internal to what writes them.
#pragma once

#include "core/fabrication/fit_coupon.h"

namespace fff::io {

/// In the language that is set.
CouponWords couponWords();

} // namespace fff::io
