// Counts what the program allocates: linking counted_memory.cpp replaces operator new and delete.
#pragma once

#include <cstdint>

namespace fff::bench {

/// Bytes that were asked for with new and not given back yet, in all threads.
std::int64_t liveBytes();

} // namespace fff::bench
