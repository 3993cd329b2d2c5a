#include "core/interaction/symmetry_editing.h"

#include "core/interaction/contour_target.h"
#include "core/interaction/contour_words.h"
#include "core/interaction/section_editing.h"
#include "core/model/edit_words.h"
#include "core/model/symmetric_section.h"

namespace fff {

namespace {

constexpr CountedText kKeepSymmetric{//: %1 is the name of a section
                                     FFF_TEXT("Step", "Keep %1 symmetric"),
                                     FFF_TEXT_OF_MANY("Step", "Keep %n sections symmetric")};
constexpr CountedText kLetGoSymmetry{
    //: %1 is the name of a section
    FFF_TEXT("Step", "Let the halves of %1 differ"),
    FFF_TEXT_OF_MANY("Step", "Let the halves of %n sections differ")};
//: %1 is the name of a section
constexpr Text kNotSymmetric = FFF_TEXT("Hint", "%1 is not symmetric: its halves differ.");

} // namespace

std::optional<MirrorAxis> symmetryAxis(const Section &section, const Document &document)
{
    if (const MirrorAxis *axis = symmetryOf(section))
        return *axis;
    const Vec2 middle = section.shape->bounds().center();
    for (const std::optional<MirrorAxis> &axis :
         {slitAxis(ContourTarget::redraw(section), document),
          std::optional(MirrorAxis{middle, Vec2::UnitY()}),
          std::optional(MirrorAxis{middle, Vec2::UnitX()})})
        if (axis && isSymmetric(*section.shape, *axis))
            return axis;
    return {};
}

SectionEdit keptSymmetric(const Model &model, const std::vector<SectionRef> &sections, bool isKept)
{
    EditedSections edited;
    edited.document = model.document;
    std::vector<std::string> names;
    for (const SectionRef &ref : sections) {
        const auto drawn = drawnSection(model, ref);
        if (!drawn)
            return tl::unexpected(drawn.error());
        const Section &section = **drawn;
        const auto axis = isKept ? symmetryAxis(section, model.document) : std::nullopt;
        if (isKept && !axis)
            return refused(kNotSymmetric, {Named{section.name}});
        Result<Document> next = setSymmetry(std::move(edited.document), section.id, axis);
        if (!next)
            return refused(hints::kEditFailed);
        edited.document = *std::move(next);
        names.push_back(section.name);
    }
    edited.step = ofSections(isKept ? kKeepSymmetric : kLetGoSymmetry, names);
    return edited;
}

} // namespace fff
