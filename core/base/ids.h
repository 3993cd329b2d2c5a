// Identities inside one document. Ids are never reused, also not after a deletion, so that
// references that lost their target stay dormant instead of pointing at something else.
#pragma once

#include <compare>
#include <cstdint>
#include <functional>

namespace fff {

template <class Tag>
struct Id
{
    std::int64_t value = 0; // 0: none

    constexpr bool isValid() const { return value > 0; }
    constexpr auto operator<=>(const Id &) const = default;
};

using SectionId = Id<struct SectionTag>;
using StockId = Id<struct StockTag>;
using LoadId = Id<struct LoadTag>;
using OperationId = Id<struct OperationTag>;
using DimensionId = Id<struct DimensionTag>;
using TemplateId = Id<struct TemplateTag>;

} // namespace fff

template <class Tag>
struct std::hash<fff::Id<Tag>>
{
    std::size_t operator()(const fff::Id<Tag> &id) const noexcept
    {
        return std::hash<std::int64_t>()(id.value);
    }
};
