// `.fff` among the formats (core/io/formats.h): read and written by fff_format.h.
#pragma once

#include "core/io/formats.h"

namespace fff::io {

const Format &fffFormat();

} // namespace fff::io
