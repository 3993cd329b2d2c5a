// Why an expression has no worth, and where in its text.
#pragma once

#include "core/base/message.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace fff {

/// Bytes of a UTF-8 text from `begin` until before `end`.
struct TextRange
{
    std::size_t begin = 0, end = 0;

    bool operator==(const TextRange &) const = default;
};

/// One sentence that quotes the place.
struct ExpressionError
{
    Message message;
    TextRange place;
    bool isFollowing = false; // only because another value has none

    bool operator==(const ExpressionError &) const = default;
};

template <class T>
using Understood = tl::expected<T, ExpressionError>;

inline tl::unexpected<ExpressionError> misunderstood(const Text &text, TextRange place,
                                                     std::vector<Argument> arguments = {})
{
    return tl::unexpected(ExpressionError{{text, std::move(arguments)}, place});
}

/// What stands there, one line of no more than some forty letters.
Named quoted(std::string_view text, TextRange place);

} // namespace fff
