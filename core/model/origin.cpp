#include "core/model/origin.h"

#include "core/model/edits.h"

#include <algorithm>

namespace fff {

namespace {

/// The axes of a frame and its normal, which is turned round where the world is mirrored.
Eigen::Matrix3d axesOf(const Frame &frame, bool isMirrored)
{
    Eigen::Matrix3d axes;
    axes << frame.x, frame.y, (isMirrored ? -1.0 : 1.0) * frame.normal();
    return axes;
}

} // namespace

std::optional<Origin> originOf(const Model &model, const SectionRef &ref)
{
    const Section *shown = model.find(ref);
    if (!shown)
        return std::nullopt;
    bool isMirrored = false;
    SectionRef at = ref;
    while (!at.drawn.isValid()) { // one operation up each time
        const OperationResult *result = model.resultOf(at.operation);
        if (!result)
            return std::nullopt;
        const auto image = result->images.find(at.key);
        if (image == result->images.end())
            return std::nullopt;
        at = image->second.of;
        isMirrored = isMirrored != image->second.isMirrored;
    }
    const Section *drawn = model.document.find(at.drawn);
    if (!drawn)
        return std::nullopt;
    const Halfplane *mirror = nullptr;
    bool isReshaped = false; // by others, whose work is none of the drawn contour
    for (const OperationResultPointer &result : model.evaluation.results) {
        const auto line = result->mirrors.find(at);
        if (line != result->mirrors.end())
            mirror = &line->second;
        else
            isReshaped = isReshaped || std::any_of(result->changed.begin(), result->changed.end(),
                                                   [&](const auto &c) { return c.first == at; });
    }
    if (isReshaped)
        mirror = nullptr;
    return Origin{drawn, axesOf(shown->frame, isMirrored) * axesOf(drawn->frame, false).transpose(),
                  mirror};
}

SectionPointer editedSection(const Model &model, const SectionRef &ref)
{
    const std::optional<Origin> origin = originOf(model, ref);
    if (!origin)
        return nullptr;
    const SectionPointer &shown = model.section(static_cast<std::size_t>(model.indexOf(ref)));
    if (shown.get() == origin->section)
        return shown;
    Section edited = *origin->section;
    edited.frame = shown->frame;
    if (origin->mirror)
        edited.shape = shown->shape;
    return std::make_shared<const Section>(std::move(edited));
}

Document documentToEdit(const Model &model, const SectionRef &ref)
{
    const SectionPointer edited = editedSection(model, ref);
    if (!edited || edited->shape == model.document.find(edited->id)->shape)
        return model.document;
    Result<Document> document = setShape(model.document, edited->id, edited->shape);
    return document ? *std::move(document) : model.document;
}

} // namespace fff
