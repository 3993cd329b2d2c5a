#include "core/base/message.h"

#include <string_view>

namespace fff {

bool operator==(const Text &a, const Text &b)
{
    const auto isSame = [](const char *one, const char *other) {
        return one == other || (one && other && std::string_view(one) == other);
    };
    return isSame(a.context, b.context) && isSame(a.source, b.source);
}

bool operator==(const Message &a, const Message &b)
{
    return a.text == b.text && a.arguments == b.arguments && a.count == b.count;
}

} // namespace fff
