// How much has been done, and whether that is enough. Internal to nesting.
#pragma once

#include "core/nesting/collision.h"

#include <stop_token>

namespace fff::nest {

struct Meter
{
    Steps used = 0;
    Steps limit = 0;
    std::stop_token stop;

    bool isOver() const { return used >= limit || stop.stop_requested(); }
};

} // namespace fff::nest
