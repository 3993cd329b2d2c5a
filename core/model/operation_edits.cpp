#include "core/model/operation_edits.h"

#include "core/model/sheet_edits.h"

#include <algorithm>

namespace fff {

namespace {

tl::unexpected<Error> unknown(OperationId id)
{
    return failure(ErrorCode::UnknownReference, std::to_string(id.value),
                   {std::to_string(id.value)});
}

std::vector<OperationPointer>::iterator placeOf(Document &document, OperationId id)
{
    return std::find_if(document.operations.begin(), document.operations.end(),
                        [id](const auto &operation) { return operation->id == id; });
}

/// An empty one where there is none.
Exception exceptionOf(const Document &document, const SectionRef &instance)
{
    const Operation *operation = document.find(instance.operation);
    if (!operation)
        return {};
    const auto known = operation->exceptions.find(instance.key);
    return known == operation->exceptions.end() ? Exception() : known->second;
}

} // namespace

Document addOperation(Document document, Operation operation)
{
    operation.id = OperationId{document.nextId++};
    document.operations.push_back(std::make_shared<const Operation>(std::move(operation)));
    return document;
}

Result<Document> setOperation(Document document, Operation operation)
{
    const auto place = placeOf(document, operation.id);
    if (place == document.operations.end())
        return unknown(operation.id);
    if (!(**place == operation))
        *place = std::make_shared<const Operation>(std::move(operation));
    return document;
}

Result<Document> renameOperation(Document document, OperationId id, std::string name)
{
    const Operation *known = document.find(id);
    if (!known)
        return unknown(id);
    Operation renamed = *known;
    renamed.name = std::move(name);
    return setOperation(std::move(document), std::move(renamed));
}

Result<Document> removeOperation(Document document, OperationId id)
{
    const auto place = placeOf(document, id);
    if (place == document.operations.end())
        return unknown(id);
    document.operations.erase(place);
    std::erase_if(document.loads, [id](const Load &w) { return w.section.operation == id; });
    std::erase_if(document.jointOverrides, [id](const JointOverridePointer &joint) {
        return joint->a.operation == id || joint->b.operation == id;
    });
    forgetSheetWishes(document, [id](const SectionRef &ref) { return ref.operation == id; });
    for (SectionPointer &pointer : document.sections) {
        if (!pointer->parent || pointer->parent->section.operation != id)
            continue;
        Section orphan = *pointer;
        orphan.parent.reset();
        pointer = std::make_shared<const Section>(std::move(orphan));
    }
    return document;
}

Result<Document> moveOperation(Document document, OperationId id, int index)
{
    const auto place = placeOf(document, id);
    if (place == document.operations.end())
        return unknown(id);
    const int last = static_cast<int>(document.operations.size()) - 1;
    const auto to = document.operations.begin() + std::clamp(index, 0, last);
    if (to < place)
        std::rotate(to, place, place + 1);
    else
        std::rotate(place, place + 1, to + 1);
    return document;
}

Result<Document> setException(Document document, const SectionRef &instance,
                              const Exception &exception)
{
    const auto place = placeOf(document, instance.operation);
    if (place == document.operations.end())
        return unknown(instance.operation);
    if (exception.stock.isValid() && !document.find(exception.stock))
        return failure(ErrorCode::UnknownReference, std::to_string(exception.stock.value),
                       {std::to_string(exception.stock.value)});
    Operation next = **place;
    if (exception.isEmpty())
        next.exceptions.erase(instance.key);
    else
        next.exceptions.insert_or_assign(instance.key, exception);
    if (!(**place == next))
        *place = std::make_shared<const Operation>(std::move(next));
    return document;
}

Result<Document> setExceptionState(Document document, const SectionRef &instance,
                                   Exception::State state)
{
    Exception exception = exceptionOf(document, instance);
    exception.state = state;
    return setException(std::move(document), instance, exception);
}

Result<Document> setExceptionStock(Document document, const SectionRef &instance, StockId stock)
{
    Exception exception = exceptionOf(document, instance);
    exception.stock = stock;
    return setException(std::move(document), instance, exception);
}

} // namespace fff
