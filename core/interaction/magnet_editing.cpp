#include "core/interaction/magnet_editing.h"

#include "core/interaction/magnet_words.h"
#include "core/model/edit_words.h"
#include "core/model/magnet_edits.h"

namespace fff {

SectionEdit magnetsChanged(const Model &model, const std::vector<SectionRef> &sections,
                           std::optional<double> radius)
{
    Document document = model.document;
    std::vector<std::string> names;
    for (const SectionRef &section : sections) {
        Result<Document> next = setMagnet(std::move(document), section, radius);
        if (!next)
            return tl::unexpected(Hint::refusal(hints::kEditFailed));
        document = *std::move(next);
        names.push_back(model.nameOf(section));
    }
    return EditedSections{
        std::move(document),
        ofSections(radius ? steps::kPullTemplates : steps::kReleaseTemplates, names)};
}

} // namespace fff
