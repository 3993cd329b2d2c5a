#include "core/model/naming.h"

#include <algorithm>
#include <utility>

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

SectionNames::SectionNames(const Document &document, Naming naming)
    : m_naming(std::move(naming)), m_count(document.sections.size())
{
    for (const SectionPointer &section : document.sections)
        m_names.insert(section->name);
}

bool SectionNames::isTaken(const std::string &pattern, std::size_t number) const
{
    return m_names.contains(numberedName(pattern, number));
}

std::string SectionNames::next()
{
    for (std::size_t number = m_count + 1;; ++number) {
        const bool isOthers = std::any_of(m_naming.others.begin(), m_naming.others.end(),
                                          [&](const auto &p) { return isTaken(p, number); });
        if (isOthers || isTaken(m_naming.section, number))
            continue;
        ++m_count;
        return *m_names.insert(numberedName(m_naming.section, number)).first;
    }
}

std::string freeSectionName(const Document &document, const Naming &naming)
{
    return SectionNames(document, naming).next();
}

std::vector<std::string> namesAfter(const Document &document, const std::string &word,
                                    std::size_t count)
{
    std::vector<std::string> names;
    if (word.empty())
        return names;
    std::unordered_set<std::string> taken;
    for (const SectionPointer &section : document.sections)
        taken.insert(section->name);
    if (count == 1 && !taken.contains(word))
        return {word};
    for (std::size_t number = 1; names.size() < count; ++number)
        if (std::string name = word + " " + std::to_string(number); taken.insert(name).second)
            names.push_back(std::move(name));
    return names;
}

} // namespace fff
