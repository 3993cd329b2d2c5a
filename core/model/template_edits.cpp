#include "core/model/template_edits.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

tl::unexpected<Error> unknownTemplate(std::int64_t id)
{
    return failure(ErrorCode::UnknownReference, std::to_string(id), {std::to_string(id)});
}

tl::unexpected<Error> badTemplate(const char *place)
{
    return failure(ErrorCode::BadValue, place);
}

Result<void> checkedMagnets(const Document &document, const Template &one)
{
    if (one.isFlat() && !one.magnets.empty())
        return badTemplate("magnets");
    for (const Magnet &magnet : one.magnets) {
        if (magnet.section.drawn.isValid() && !document.find(magnet.section.drawn))
            return unknownTemplate(magnet.section.drawn.value);
        if (!(magnet.radius >= kLeastMagnet && magnet.radius <= kMostMagnet))
            return badTemplate("radius");
    }
    return {};
}

bool isSoundFrame(const Frame &frame)
{
    return frame.origin.allFinite() && frame.origin.cwiseAbs().maxCoeff() <= kMaxCoordinate &&
           std::abs(frame.x.norm() - 1.0) <= kExactFrame &&
           std::abs(frame.y.norm() - 1.0) <= kExactFrame &&
           std::abs(frame.x.dot(frame.y)) <= kExactFrame;
}

/// before: as it was; null: it is new. Bytes that were missing may still be.
Result<void> checkedTemplate(const Document &document, const Template &one, const Template *before)
{
    if (!one.blob.empty() && !(before && before->blob == one.blob) && !document.findBlob(one.blob))
        return badTemplate("blob");
    if (one.blob.empty() && one.file.empty())
        return badTemplate("file");
    if (!isSoundFrame(one.frame))
        return badTemplate("frame");
    if (!(one.scale >= kLeastTemplateScale && one.scale <= kMostTemplateScale))
        return badTemplate("scale");
    if (!(one.opacity >= 0.0 && one.opacity <= 1.0))
        return badTemplate("opacity");
    if (!one.isFlat() && one.on != SectionRef())
        return badTemplate("on");
    if (one.on.drawn.isValid() && !document.find(one.on.drawn))
        return unknownTemplate(one.on.drawn.value);
    return checkedMagnets(document, one);
}

auto placeOf(Document &document, TemplateId id)
{
    return std::find_if(document.templates.begin(), document.templates.end(),
                        [id](const TemplatePointer &one) { return one->id == id; });
}

std::string freeTemplateName(const Document &document, const std::string &wanted)
{
    const auto isTaken = [&document](const std::string &name) {
        return std::any_of(document.templates.begin(), document.templates.end(),
                           [&name](const TemplatePointer &one) { return one->name == name; });
    };
    std::string name = wanted;
    for (int number = 2; isTaken(name); ++number)
        name = wanted + " " + std::to_string(number);
    return name;
}

} // namespace

namespace {

/// The bytes that no template is of any more.
void dropUnused(Document &document, const std::string &blob)
{
    const bool isUsed =
        std::any_of(document.templates.begin(), document.templates.end(),
                    [&blob](const TemplatePointer &one) { return one->blob == blob; });
    if (!isUsed)
        std::erase_if(document.blobs,
                      [&blob](const BlobPointer &one) { return one->sha256 == blob; });
}

} // namespace

Result<Document> addTemplate(Document document, Template added)
{
    if (Result<void> sound = checkedTemplate(document, added, nullptr); !sound)
        return tl::unexpected(std::move(sound.error()));
    settleMagnets(added);
    added.id = TemplateId{document.nextId++};
    added.name = freeTemplateName(document, added.name);
    document.templates.push_back(std::make_shared<const Template>(std::move(added)));
    return document;
}

Result<Document> setTemplate(Document document, Template changed)
{
    const auto found = placeOf(document, changed.id);
    if (found == document.templates.end())
        return unknownTemplate(changed.id.value);
    if (Result<void> sound = checkedTemplate(document, changed, found->get()); !sound)
        return tl::unexpected(std::move(sound.error()));
    settleMagnets(changed);
    if (**found != changed || !(*found)->hasContentOf(changed)) {
        const std::string blob = (*found)->blob;
        *found = std::make_shared<const Template>(std::move(changed));
        dropUnused(document, blob);
    }
    return document;
}

Result<Document> removeTemplate(Document document, TemplateId id)
{
    const auto found = placeOf(document, id);
    if (found == document.templates.end())
        return unknownTemplate(id.value);
    const std::string blob = (*found)->blob;
    document.templates.erase(found);
    dropUnused(document, blob);
    return document;
}

Result<Document> moveTemplate(Document document, TemplateId id, std::size_t place)
{
    const auto found = placeOf(document, id);
    if (found == document.templates.end())
        return unknownTemplate(id.value);
    const auto to = document.templates.begin() +
                    static_cast<std::ptrdiff_t>(std::min(place, document.templates.size()));
    if (to <= found)
        std::rotate(to, found, found + 1);
    else
        std::rotate(found, found + 1, to);
    return document;
}

} // namespace fff
