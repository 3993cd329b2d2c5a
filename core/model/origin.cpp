#include "core/model/origin.h"

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
    return Origin{drawn,
                  axesOf(shown->frame, isMirrored) * axesOf(drawn->frame, false).transpose()};
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
    return std::make_shared<const Section>(std::move(edited));
}

} // namespace fff
