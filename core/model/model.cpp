#include "core/model/model.h"

#include <algorithm>

namespace fff {

const SectionPointer &Model::section(std::size_t index) const
{
    const std::size_t drawn = document.sections.size();
    return index < drawn ? document.sections[index] : evaluation.sections[index - drawn].section;
}

SectionRef Model::ref(std::size_t index) const
{
    const std::size_t drawn = document.sections.size();
    return index < drawn ? SectionRef(document.sections[index]->id)
                         : evaluation.sections[index - drawn].ref;
}

int Model::indexOf(const SectionRef &ref) const
{
    if (ref.drawn.isValid())
        return document.indexOf(ref.drawn);
    const auto &made = evaluation.sections;
    const auto it = std::find_if(made.begin(), made.end(),
                                 [&](const GeneratedSection &s) { return s.ref == ref; });
    return it == made.end()
               ? -1
               : static_cast<int>(document.sections.size()) + static_cast<int>(it - made.begin());
}

std::vector<SectionRef> Model::refs(const std::vector<int> &sections) const
{
    std::vector<SectionRef> refs;
    refs.reserve(sections.size());
    for (const int index : sections)
        refs.push_back(ref(static_cast<std::size_t>(index)));
    return refs;
}

std::string Model::nameOf(const SectionRef &ref) const
{
    const int index = indexOf(ref);
    return index < 0 ? std::string() : section(static_cast<std::size_t>(index))->name;
}

Box3 Model::bounds() const
{
    Box3 box;
    // Of every vertex: a box round the box of a turned section would be much larger.
    for (std::size_t i = 0; i < sectionCount(); ++i)
        for (const Vec2 &p : section(i)->shape->region().outer)
            box.extend(section(i)->frame.toWorld(p));
    return box;
}

} // namespace fff
