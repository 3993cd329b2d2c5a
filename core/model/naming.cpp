#include "core/model/naming.h"

#include <algorithm>
#include <unordered_set>

namespace fff {

std::string numberedName(const std::string &pattern, std::size_t number)
{
    constexpr std::string_view kPlace = "%1";
    const std::string digits = std::to_string(number);
    const std::size_t at = pattern.find(kPlace);
    if (at == std::string::npos)
        return pattern + " " + digits;
    return std::string(pattern).replace(at, kPlace.size(), digits);
}

std::string freeSectionName(const Document &document, const Naming &naming)
{
    std::unordered_set<std::string_view> names;
    for (const SectionPointer &section : document.sections)
        names.insert(section->name);
    const auto isTaken = [&](const std::string &pattern, std::size_t number) {
        return names.count(numberedName(pattern, number)) > 0;
    };
    for (std::size_t number = document.sections.size() + 1;; ++number) {
        const bool isOthers = std::any_of(naming.others.begin(), naming.others.end(),
                                          [&](const auto &p) { return isTaken(p, number); });
        if (!isOthers && !isTaken(naming.section, number))
            return numberedName(naming.section, number);
    }
}

} // namespace fff
