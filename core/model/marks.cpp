#include "core/model/marks.h"

namespace fff {

namespace {

tl::unexpected<Error> noMark(std::size_t index)
{
    return failure(ErrorCode::BadValue, "mark", {std::to_string(index), "a mark of the section"});
}

template <class Change>
Result<Document> changeMarks(Document document, SectionId id, Change change)
{
    const int at = document.indexOf(id);
    if (at < 0)
        return failure(ErrorCode::UnknownReference, std::to_string(id.value),
                       {std::to_string(id.value)});
    SectionPointer &place = document.sections[static_cast<std::size_t>(at)];
    Section next = *place;
    if (Result<void> done = change(next.marks); !done)
        return tl::unexpected(done.error());
    if (!(next == *place))
        place = std::make_shared<const Section>(std::move(next));
    return document;
}

bool isDrawn(const MarkPointer &mark)
{
    return mark && !mark->paths.empty();
}

} // namespace

Result<Document> addMark(Document document, SectionId id, MarkPointer mark)
{
    return changeMarks(std::move(document), id,
                       [&](std::vector<MarkPointer> &marks) -> Result<void> {
                           if (!isDrawn(mark))
                               return noMark(marks.size());
                           marks.push_back(std::move(mark));
                           return {};
                       });
}

Result<Document> setMark(Document document, SectionId id, std::size_t index, MarkPointer mark)
{
    return changeMarks(std::move(document), id,
                       [&](std::vector<MarkPointer> &marks) -> Result<void> {
                           if (index >= marks.size() || !isDrawn(mark))
                               return noMark(index);
                           marks[index] = std::move(mark);
                           return {};
                       });
}

Result<Document> removeMark(Document document, SectionId id, std::size_t index)
{
    return changeMarks(std::move(document), id,
                       [&](std::vector<MarkPointer> &marks) -> Result<void> {
                           if (index >= marks.size())
                               return noMark(index);
                           marks.erase(marks.begin() + static_cast<std::ptrdiff_t>(index));
                           return {};
                       });
}

} // namespace fff
