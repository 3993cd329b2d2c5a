#include "core/model/step.h"

namespace fff {

Message ofSections(const CountedText &texts, const std::vector<std::string> &names)
{
    if (names.size() == 1)
        return {texts.one, {Named{names.front()}}};
    return {texts.many, {}, static_cast<int>(names.size())};
}

Message ofParts(const CountedText &texts, const std::string &name, std::size_t count)
{
    if (count == 1)
        return {texts.one, {Named{name}}};
    return {texts.many, {Named{name}}, static_cast<int>(count)};
}

} // namespace fff
