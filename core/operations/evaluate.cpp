#include "core/operations/evaluate.h"

namespace fff {

Model evaluate(Document document, const Model &previous)
{
    Model model;
    model.document = std::move(document);
    // An equal list of operations over the same sections makes the same sections.
    if (model.document.isSame(previous.document))
        model.evaluation = previous.evaluation;
    return model;
}

} // namespace fff
