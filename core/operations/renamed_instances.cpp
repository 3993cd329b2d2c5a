#include "core/operations/renamed_instances.h"

#include "core/operations/evaluate.h"

#include <algorithm>
#include <vector>

namespace fff {

namespace {

/// All that it makes, also what exceptions leave out.
std::vector<SectionPointer> allMade(const Model &model, OperationId id)
{
    const Operation *operation = model.document.find(id);
    if (!operation)
        return {};
    const OperationResult *result = model.resultOf(id);
    if (result && operation->exceptions.empty())
        return result->sections;
    Document bare = model.document;
    for (OperationPointer &pointer : bare.operations) {
        if (pointer->id != id)
            continue;
        Operation next = *pointer;
        next.isOn = true;
        next.exceptions.clear();
        pointer = std::make_shared<const Operation>(std::move(next));
    }
    const Model whole = evaluate(std::move(bare), model);
    result = whole.resultOf(id);
    return result ? result->sections : std::vector<SectionPointer>();
}

bool isSame(const Section &a, const Section &b)
{
    return a.frame == b.frame && a.stock == b.stock && (a.shape == b.shape || *a.shape == *b.shape);
}

} // namespace

Replacements renamedInstances(const Model &before, const Model &now, OperationId id)
{
    const std::vector<SectionPointer> old = allMade(before, id), made = allMade(now, id);
    std::vector<SectionPointer> rest; // with keys that were not there
    for (const SectionPointer &section : made)
        if (indexOfKey(old, section->made.key) < 0)
            rest.push_back(section);
    Replacements renamed;
    for (const SectionPointer &section : old) {
        if (rest.empty() || indexOfKey(made, section->made.key) >= 0)
            continue;
        const auto found = std::find_if(rest.begin(), rest.end(), [&](const SectionPointer &one) {
            return isSame(*one, *section);
        });
        if (found == rest.end())
            continue;
        renamed.emplace(section->made, (*found)->made);
        rest.erase(found);
    }
    return renamed;
}

} // namespace fff
