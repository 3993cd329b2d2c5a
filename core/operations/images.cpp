#include "core/operations/images.h"

#include "core/model/instance_key.h"
#include "core/model/transformed.h"

#include <algorithm>

namespace fff {

std::string keyOfSection(const SectionRef &ref)
{
    if (ref.drawn.isValid())
        return std::to_string(ref.drawn.value);
    std::string operation = "o";
    return keyBelow(operation.append(std::to_string(ref.operation.value)), ref.key);
}

ImageMaker::ImageMaker(OperationContext &context, std::vector<SectionPointer> scope)
    : m_context(context), m_scope(std::move(scope))
{
    for (const SectionPointer &section : m_scope)
        m_isCopied[section->ref()] = true;
}

void ImageMaker::change(const SectionPointer &section, const SectionPointer &next)
{
    m_context.change(section->ref(), next);
    std::replace(m_scope.begin(), m_scope.end(), SectionPointer(section), SectionPointer(next));
}

Section ImageMaker::imageOf(const Section &section, const Similarity &placement)
{
    return transformed(asCopy(section), placement).value();
}

void ImageMaker::moveSlit(Section &copy, const Similarity &placement)
{
    const SectionPointer parent = m_context.find(copy.parent->section);
    if (!parent)
        return;
    for (Vec2 *end : {&copy.parent->slitFrom, &copy.parent->slitTo})
        *end = parent->frame.toLocal(placement(parent->frame.toWorld(*end)));
}

void ImageMaker::addCopies(const Similarity &placement, const std::string &above,
                           const std::string &mark)
{
    for (const SectionPointer &section : m_scope) {
        if (!isCopied(section))
            continue;
        Section copy = imageOf(*section, placement);
        copy.name = section->name;
        copy.name.append(mark);
        if (copy.parent) {
            const auto parent = m_isCopied.find(copy.parent->section);
            const bool isTaken = parent != m_isCopied.end() && parent->second;
            if (isTaken)
                copy.parent->section = SectionRef(m_context.operation().id,
                                                  keyBelow(above, keyOfSection(parent->first)));
            else
                moveSlit(copy, placement);
        }
        const std::string key = keyBelow(above, keyOfSection(section->ref()));
        m_context.setImage(key, section->ref(), placement.turn.determinant() < 0.0);
        m_context.add(key, std::move(copy));
    }
}

} // namespace fff
