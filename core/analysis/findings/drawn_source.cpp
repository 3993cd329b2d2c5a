#include "core/analysis/findings/drawn_source.h"

namespace fff {

std::optional<DrawnSource> drawnSourceOf(const Model &model, std::size_t index)
{
    const Section &section = *model.section(index);
    DrawnSource source;
    if (section.id.isValid()) {
        source.section = model.document.find(section.id);
    } else {
        for (const CopyOf *copy = section.copyOf ? &*section.copyOf : nullptr;
             copy && !source.section; copy = copy->before.get()) {
            source.shift += source.matrix * copy->shift;
            source.matrix = source.matrix * copy->matrix;
            if (copy->section.drawn.isValid())
                source.section = model.document.find(copy->section.drawn);
        }
    }
    if (!source.section || source.section->isLocked)
        return {};
    return source;
}

} // namespace fff
