#include "core/interaction/mark_editing.h"

#include "core/interaction/mark_words.h"
#include "core/interaction/section_editing.h"
#include "core/model/edit_words.h"
#include "core/model/lettering.h"
#include "core/model/marks.h"
#include "core/model/origin.h"

namespace fff {

namespace {

//: %1 is the name of a section
constexpr Text kAddMark = FFF_TEXT("Step", "Mark %1");
//: %1 is the name of a section
constexpr Text kChangeMark = FFF_TEXT("Step", "Change mark of %1");
//: %1 is the name of a section
constexpr Text kDeleteMark = FFF_TEXT("Step", "Delete mark of %1");

tl::unexpected<Hint> refused(const Error &error)
{
    const bool isLetter =
        error.code == ErrorCode::BadValue && error.place == "text" && !error.args.empty();
    return isLetter ? refused(hints::kLetterUnknown, {Named{error.args[0]}})
                    : refused(hints::kEditFailed);
}

template <class Edit>
SectionEdit edited(const Model &model, const SectionRef &ref, Text step, Edit edit)
{
    const auto drawn = drawnSection(model, ref);
    if (!drawn)
        return tl::unexpected(drawn.error());
    const Section &section = **drawn;
    Result<Document> next = edit(section);
    if (!next)
        return refused(next.error());
    return EditedSections{*std::move(next), {step, {Named{section.name}}}};
}

tl::unexpected<Error> noMark(std::size_t index)
{
    return failure(ErrorCode::BadValue, "mark", {std::to_string(index), "a mark"});
}

} // namespace

SectionEdit markAdded(const Model &model, const SectionRef &ref, MarkPointer mark)
{
    return edited(model, ref, kAddMark, [&](const Section &section) {
        return addMark(model.document, section.id, std::move(mark));
    });
}

SectionEdit markRemoved(const Model &model, const SectionRef &ref, std::size_t index)
{
    return edited(model, ref, kDeleteMark, [&](const Section &section) {
        return removeMark(model.document, section.id, index);
    });
}

SectionEdit markKindChanged(const Model &model, const SectionRef &ref, std::size_t index,
                            Mark::Kind kind)
{
    return edited(model, ref, kChangeMark, [&](const Section &section) -> Result<Document> {
        if (index >= section.marks.size())
            return noMark(index);
        Mark next = *section.marks[index];
        next.kind = kind;
        return setMark(model.document, section.id, index,
                       std::make_shared<const Mark>(std::move(next)));
    });
}

SectionEdit letteringAdded(const Model &model, const SectionRef &ref, const Lettering &lettering,
                           Mark::Kind kind)
{
    return edited(model, ref, kAddMark, [&](const Section &section) -> Result<Document> {
        Result<MarkPointer> mark = letteredMark(lettering, kind);
        if (!mark)
            return tl::unexpected(mark.error());
        return addMark(model.document, section.id, *std::move(mark));
    });
}

SectionEdit letteringChanged(const Model &model, const SectionRef &ref, std::size_t index,
                             const Lettering &lettering)
{
    SectionEdit edit =
        edited(model, ref, kChangeMark, [&](const Section &section) -> Result<Document> {
            if (index >= section.marks.size() || !section.marks[index]->lettering)
                return noMark(index);
            Result<MarkPointer> mark = letteredMark(lettering, section.marks[index]->kind);
            if (!mark)
                return tl::unexpected(mark.error());
            return setMark(model.document, section.id, index, *std::move(mark));
        });
    if (edit) {
        const auto origin = originOf(model, ref);
        edit->step.merges = "mark ";
        edit->step.merges.append(std::to_string(origin->section->id.value))
            .append("/")
            .append(std::to_string(index));
    }
    return edit;
}

} // namespace fff
