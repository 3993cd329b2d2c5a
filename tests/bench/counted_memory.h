// Counts what the program allocates: linking counted_memory.cpp replaces operator new and delete.
#pragma once

#include <cstdint>

namespace fff::bench {

/// Bytes that this thread has asked for with new, less those that it has given back.
std::int64_t liveBytes();

} // namespace fff::bench
