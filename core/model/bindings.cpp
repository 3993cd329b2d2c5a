#include "core/model/bindings.h"

#include "core/base/letters.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace fff {

namespace {

auto placeIn(const std::vector<BindingPointer> &bindings, const DrivenPlace &place)
{
    return std::lower_bound(bindings.begin(), bindings.end(), place,
                            [](const BindingPointer &known, const DrivenPlace &wanted) {
                                return known->binding.place < wanted;
                            });
}

bool namesIt(const KnownBinding &known, const std::string &folded)
{
    return known.typed && std::find(known.typed->names().begin(), known.typed->names().end(),
                                    folded) != known.typed->names().end();
}

Understood<Document> withValues(Document document, Understood<Values> values)
{
    if (!values)
        return tl::unexpected(std::move(values.error()));
    document.values = *std::move(values);
    return document;
}

std::optional<double> thicknessOf(const Document &document, StockId id)
{
    const Stock *stock = document.find(id);
    return stock ? std::optional(stock->thickness) : std::nullopt;
}

std::optional<double> thicknessOf(const Document &document, const SectionRef &ref)
{
    const Section *section = document.find(ref.drawn);
    return section ? thicknessOf(document, section->stock) : std::nullopt;
}

/// Of an operation: of what it makes, or else of what it is mainly about.
std::optional<double> thicknessOf(const Document &document, const Operation &operation)
{
    if (operation.stock.isValid())
        return thicknessOf(document, operation.stock);
    for (const auto &[role, inputs] : operation.inputs)
        for (const OperationInput &input : inputs)
            if (const auto thickness = thicknessOf(document, input.section))
                return thickness;
    return std::nullopt;
}

/// Null: it is of none.
const Dimension *dimensionAt(const Document &document, const DrivenPlace &place)
{
    const auto found =
        std::find_if(document.dimensions.begin(), document.dimensions.end(),
                     [&place](const Dimension &one) { return one.id.value == place.id; });
    return found == document.dimensions.end() ? nullptr : &*found;
}

std::optional<double> thicknessAt(const Document &document, const DrivenPlace &place)
{
    switch (place.of) {
    case DrivenPlace::Of::Stock: // not of itself
        return place.field == "thickness" ? std::nullopt : thicknessOf(document, StockId{place.id});
    case DrivenPlace::Of::Operation: {
        const Operation *operation = document.find(OperationId{place.id});
        return operation ? thicknessOf(document, *operation) : std::nullopt;
    }
    case DrivenPlace::Of::Load: {
        const Load *load = document.find(LoadId{place.id});
        return load ? thicknessOf(document, load->section) : std::nullopt;
    }
    case DrivenPlace::Of::Dimension: {
        const Dimension *dimension = dimensionAt(document, place);
        return dimension ? thicknessOf(document, dimension->from.section) : std::nullopt;
    }
    case DrivenPlace::Of::Joint:
        return std::nullopt;
    case DrivenPlace::Of::Section:
    case DrivenPlace::Of::Figure:
    case DrivenPlace::Of::Lettering:
        break;
    }
    return thicknessOf(document, SectionId{place.id});
}

} // namespace

Understood<Document> addValue(Document document, Value value)
{
    value.id = ValueId{document.nextId};
    Understood<Values> values = addedValue(document.values, std::move(value));
    if (values)
        ++document.nextId;
    return withValues(std::move(document), std::move(values));
}

Understood<Document> changeValue(Document document, Value value)
{
    Understood<Values> values = changedValue(document.values, std::move(value));
    return withValues(std::move(document), std::move(values));
}

Understood<Document> typeValue(Document document, ValueId id, std::string typed,
                               const Reading &reading)
{
    Understood<Values> values = typedValue(document.values, id, std::move(typed), reading);
    return withValues(std::move(document), std::move(values));
}

Understood<Document> renameValue(Document document, ValueId id, const std::string &name)
{
    const Value *known = document.values.find(id);
    const Renames renames{{known ? foldedName(known->name) : std::string(), name}};
    Understood<Values> values = renamedValue(document.values, id, name);
    if (!values)
        return tl::unexpected(std::move(values.error()));
    document.values = *std::move(values);
    for (BindingPointer &pointer : document.bindings) {
        Binding next = pointer->binding;
        next.typed = renamedIn(next.typed, next.kind, renames);
        if (next.typed != pointer->binding.typed)
            pointer = makeBinding(std::move(next));
    }
    return document;
}

RemovedValue removeValue(const Document &document, ValueId id)
{
    RemovedValue removed{document, 0};
    const Value *known = document.values.find(id);
    if (!known)
        return removed;
    const std::string folded = foldedName(known->name);
    const EvaluatedValues evaluated = EvaluatedValues::of(document.values);
    const Names names = evaluated.names();
    ValueRemoval values = removedValue(document.values, id, evaluated);
    removed.document.values = std::move(values.values);
    removed.users = static_cast<int>(values.users.size());
    std::vector<BindingPointer> bindings;
    for (const BindingPointer &pointer : document.bindings) {
        if (!namesIt(*pointer, folded)) {
            bindings.push_back(pointer);
            continue;
        }
        ++removed.users;
        Binding next = pointer->binding;
        next.typed = withoutName(*pointer->typed, folded, namesAt(document, next.place, names));
        BindingPointer without = makeBinding(std::move(next));
        if (without->typed && !without->typed->isConstant())
            bindings.push_back(std::move(without));
    }
    removed.document.bindings = std::move(bindings);
    return removed;
}

const Binding *bindingOf(const Document &document, const DrivenPlace &place)
{
    const auto found = placeIn(document.bindings, place);
    return found != document.bindings.end() && (*found)->binding.place == place ? &(*found)->binding
                                                                                : nullptr;
}

Document withBinding(Document document, Binding binding)
{
    const auto found = placeIn(document.bindings, binding.place);
    const auto index = found - document.bindings.begin();
    if (found == document.bindings.end() || (*found)->binding.place != binding.place)
        document.bindings.insert(found, makeBinding(std::move(binding)));
    else if ((*found)->binding != binding)
        document.bindings[static_cast<std::size_t>(index)] = makeBinding(std::move(binding));
    return document;
}

Document withoutBinding(Document document, const DrivenPlace &place)
{
    const auto found = placeIn(document.bindings, place);
    if (found != document.bindings.end() && (*found)->binding.place == place)
        document.bindings.erase(found);
    return document;
}

std::vector<DrivenPlace> boundTo(const Document &document, const EvaluatedValues &evaluated,
                                 ValueId id)
{
    std::vector<ValueId> values = evaluated.dependents(id);
    values.push_back(id);
    std::vector<DrivenPlace> places;
    for (const BindingPointer &pointer : document.bindings) {
        const auto isMadeOf = [&](ValueId value) {
            const Value *known = document.values.find(value);
            return known && namesIt(*pointer, foldedName(known->name));
        };
        if (std::any_of(values.begin(), values.end(), isMadeOf))
            places.push_back(pointer->binding.place);
    }
    return places;
}

bool isStretchedByValues(const Document &document, SectionId section)
{
    const auto stretchesIt = [&](const BindingPointer &pointer) {
        const DrivenPlace &place = pointer->binding.place;
        if (place.of == DrivenPlace::Of::Dimension) {
            const Dimension *dimension = dimensionAt(document, place);
            return dimension && dimension->from.section == SectionRef(section);
        }
        return place.of == DrivenPlace::Of::Section && place.id == section.value &&
               (place.field == "width" || place.field == "height");
    };
    return section.isValid() &&
           std::any_of(document.bindings.begin(), document.bindings.end(), stretchesIt);
}

Names namesAt(const Document &document, const DrivenPlace &place, const Names &values)
{
    const std::optional<double> thickness = thicknessAt(document, place);
    if (!thickness)
        return values;
    Worth worth;
    worth.powers = kLengthPowers;
    worth.number = *thickness;
    return [worth = std::move(worth), values](std::string_view name) -> const Worth * {
        return name == "t" ? &worth : values(name);
    };
}

} // namespace fff
