#include "core/model/model.h"

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
    for (std::size_t i = 0; i < sectionCount(); ++i) {
        if (this->ref(i) == ref)
            return static_cast<int>(i);
    }
    return -1;
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
