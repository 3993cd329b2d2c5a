// Whether an object in JSON has a key twice, of which Qt would take the last in silence. Internal
// to the readers of core/io.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace fff::io {

struct RepeatedKey
{
    std::string key;
    std::size_t at = 0; // where it stands again, in bytes
};

/// The first in the text that repeats one of its object; keys are compared as what they stand for,
/// however they are escaped. json: what Qt has parsed without an error.
std::optional<RepeatedKey> repeatedKey(std::string_view json);

} // namespace fff::io
