#include "core/model/magnet_edits.h"

#include "core/model/template_edits.h"

#include <algorithm>

namespace fff {

namespace {

bool canBePulled(const Template &one)
{
    return !one.isFlat() && !one.isLocked;
}

} // namespace

bool canPullTemplates(const Document &document)
{
    return std::any_of(document.templates.begin(), document.templates.end(),
                       [](const TemplatePointer &one) { return canBePulled(*one); });
}

std::optional<double> magnetOf(const Document &document, const SectionRef &section)
{
    for (const TemplatePointer &one : document.templates)
        for (const Magnet &magnet : one->magnets)
            if (magnet.section == section)
                return magnet.radius;
    return std::nullopt;
}

Result<Document> setMagnet(Document document, const SectionRef &section,
                           std::optional<double> radius)
{
    if (!canPullTemplates(document))
        return failure(ErrorCode::UnknownReference, "template", {"no mesh"});
    const std::vector<TemplatePointer> all = document.templates;
    for (const TemplatePointer &one : all) {
        if (!canBePulled(*one))
            continue;
        Template next = *one;
        std::erase_if(next.magnets,
                      [&](const Magnet &magnet) { return magnet.section == section; });
        if (radius)
            next.magnets.push_back({section, *radius});
        Result<Document> changed = setTemplate(std::move(document), std::move(next));
        if (!changed)
            return changed;
        document = *std::move(changed);
    }
    return document;
}

} // namespace fff
