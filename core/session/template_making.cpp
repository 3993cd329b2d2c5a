#include "core/session/template_making.h"

#include "core/analysis/facetted.h"
#include "core/interaction/template_words.h"
#include "core/model/template_edits.h"

namespace fff {

namespace {

Message together(const std::vector<Message> &messages)
{
    Message all;
    for (const Message &message : messages)
        all = all.isEmpty() ? message : Message{kOneAfterOther, {all, message}};
    return all;
}

SectionEdit made(Document document, const std::vector<SectionId> &sections, Step step, Hint note)
{
    EditedSections edit{std::move(document), std::move(step)};
    edit.select.emplace(sections.begin(), sections.end());
    if (!note.words.isEmpty())
        edit.note = std::move(note);
    return edit;
}

Hint whatIsBare(const FacetModel &model)
{
    if (model.bare.empty())
        return {};
    return Message{hints::kBareEdges, {}, static_cast<int>(model.bare.size())};
}

/// What a person can do about it; the error where that is nothing.
Result<SectionEdit> refusedFor(Error error, const Document &document, TemplateId of)
{
    if (error.code == ErrorCode::EmptyContour)
        return SectionEdit(refused(hints::kTooSmallForFacets, {Named{document.find(of)->name}}));
    if (error.code == ErrorCode::BadCount)
        return SectionEdit(refused(hints::kTooManyFacets, {static_cast<int>(kMostFacets)}));
    if (error.code == ErrorCode::BadValue && error.place == "thickness") {
        const double thickness = document.find(document.currentStock)->thickness;
        return SectionEdit(
            refused(hints::kTooThickToFold, {widthOf(thickness), widthOf(kThickestFolded)}));
    }
    return tl::unexpected(std::move(error));
}

} // namespace

Result<SectionEdit> suggestedEdit(const Model &model, TemplateId of,
                                  const SuggestionOptions &options, const LongWork &work)
{
    Result<Suggestion> suggested = suggestSections(model, of, options, work);
    if (!suggested)
        return tl::unexpected(std::move(suggested.error()));
    Hint note = together(suggested->messages);
    if (suggested->sections.empty()) {
        note.isRefusal = true;
        return SectionEdit(tl::unexpect, std::move(note));
    }
    const Named name{suggested->document.find(of)->name};
    const auto count = static_cast<int>(suggested->sections.size());
    return made(std::move(suggested->document), suggested->sections,
                Message{steps::kSuggestSections, {name}, count}, std::move(note));
}

Result<SectionEdit> facetEdit(const Document &document, TemplateId of, std::size_t faces,
                              const LongWork &work)
{
    Result<FacetModel> model = facetted(document, of, faces, work);
    if (!model)
        return refusedFor(std::move(model.error()), document, of);
    Template hidden = *model->document.find(of);
    hidden.isHidden = true;
    Result<Document> next = setTemplate(std::move(model->document), hidden);
    if (!next)
        return tl::unexpected(std::move(next.error()));
    return made(*std::move(next), model->sections,
                Message{steps::kMakeFacets, {Named{hidden.name}}}, whatIsBare(*model));
}

Result<SectionEdit> netEdit(const Document &document, TemplateId of, std::size_t faces,
                            const LongWork &work)
{
    const double flap = usualFlap(*document.find(document.currentStock));
    Result<NetModel> model = unfolded(document, of, faces, flap, work);
    if (!model)
        return refusedFor(std::move(model.error()), document, of);
    const Named name{document.find(of)->name};
    return made(std::move(model->document), model->sections, Message{steps::kMakeNet, {name}},
                Message{hints::kUnfolded, {}, model->seams});
}

} // namespace fff
