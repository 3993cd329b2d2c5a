#include "core/model/binding.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fff {

BindingPointer makeBinding(Binding binding)
{
    Understood<Typed> typed = Typed::read(binding.typed, binding.kind, binding.reading);
    return std::make_shared<const KnownBinding>(KnownBinding{std::move(binding), std::move(typed)});
}

bool isSameWorth(const Worth &a, const Worth &b)
{
    const double scale = std::max({1.0, std::abs(a.number), std::abs(b.number)});
    return a.type == b.type && a.text == b.text &&
           std::abs(a.number - b.number) <= kSameNumber * scale;
}

} // namespace fff
