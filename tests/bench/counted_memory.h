// Counts what the program allocates: linking counted_memory.cpp replaces operator new and delete.
#pragma once

#include <cstdint>

namespace fff::bench {

/// Bytes that this thread has asked for with new, less those that it has given back.
std::int64_t liveBytes();

/// The same of all threads together: what a worker made and another thread gives back is counted
/// once.
std::int64_t liveBytesOfAll();

} // namespace fff::bench
