#include "core/base/message.h"

#include <string_view>

namespace fff {

bool operator==(const Text &a, const Text &b)
{
    if (!a.source || !b.source)
        return a.source == b.source;
    return std::string_view(a.context) == b.context && std::string_view(a.source) == b.source;
}

bool operator==(const Message &a, const Message &b)
{
    return a.text == b.text && a.arguments == b.arguments && a.count == b.count;
}

} // namespace fff
