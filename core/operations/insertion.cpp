#include "core/operations/insertion.h"

#include "core/base/letters.h"
#include "core/model/bindings.h"
#include "core/model/edits.h"
#include "core/model/named_numbers.h"
#include "core/model/sheet_edits.h"
#include "core/operations/evaluate.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>

namespace fff {

namespace {

/// Of names that are not here yet, the very ones; of others with the first free number behind.
template <class Things>
class FreeNames
{
public:
    FreeNames(const Things &here, const Things &coming)
    {
        for (const auto &thing : here)
            m_taken.insert(thing->name);
        for (const auto &thing : coming)
            m_coming.insert(thing->name);
    }
    std::string take(const std::string &name)
    {
        std::string result = name;
        for (int number = 2;
             m_taken.contains(result) || (result != name && m_coming.contains(result)); ++number)
            result = std::string(name).append(" ").append(std::to_string(number));
        if (result != name)
            m_taken.insert(result);
        return result;
    }

private:
    std::set<std::string> m_taken, m_coming;
};

/// One document on its way into another one: its ids, keys and names there.
class Inserter
{
public:
    Inserter(Document into, const Document &other, bool isAttached)
        : m_other(other), m_isAttached(isAttached), m_shift(into.nextId - 1),
          m_isFirst(into.sections.empty())
    {
        m_result.document = std::move(into);
    }

    Insertion insert();

private:
    template <class Tag>
    Id<Tag> moved(Id<Tag> id) const
    {
        return id.isValid() ? Id<Tag>{id.value + m_shift} : id;
    }
    SectionRef moved(const SectionRef &ref) const;
    std::string movedKey(OperationId operation, const std::string &key) const;
    StockId moved(StockId id) const { return m_stocks.at(id); }
    void addStocks();
    void addSections();
    void settleParents();
    void addOperations();
    void addMarks();
    void addTemplates();
    std::set<std::string> sharedValues() const;
    void addValues();
    std::optional<DrivenPlace> moved(const DrivenPlace &place) const;
    Operation moved(const Operation &operation) const;

    const Document &m_other;
    const bool m_isAttached;
    const std::int64_t m_shift; // of all ids but those of stocks: their order stays
    const bool m_isFirst;
    std::map<StockId, StockId> m_stocks;
    std::set<StockId> m_newStocks; // of the other, that were none of this document's
    std::map<OperationId, std::map<std::string, std::string>> m_keys; // by operations of the other
    Insertion m_result;
};

std::string Inserter::movedKey(OperationId operation, const std::string &key) const
{
    const auto keys = m_keys.find(operation);
    if (keys == m_keys.end())
        return key;
    const auto found = keys->second.find(key);
    return found == keys->second.end() ? key : found->second;
}

SectionRef Inserter::moved(const SectionRef &ref) const
{
    const bool isIn = ref.drawn.isValid() ? m_other.find(ref.drawn) != nullptr
                                          : m_other.find(ref.operation) != nullptr;
    if (m_isAttached && !isIn)
        return ref;
    if (ref.drawn.isValid())
        return moved(ref.drawn);
    if (!ref.operation.isValid())
        return ref;
    return {moved(ref.operation), movedKey(ref.operation, ref.key)};
}

void Inserter::addStocks()
{
    Document &document = m_result.document;
    for (const auto &stock : m_other.stocks) {
        const auto isAlike = [&stock](const auto &known) {
            Stock same = *known;
            same.id = stock->id;
            return same == *stock;
        };
        const auto known = std::find_if(document.stocks.begin(), document.stocks.end(), isAlike);
        if (known != document.stocks.end()) {
            m_stocks.emplace(stock->id, (*known)->id);
            continue;
        }
        Stock next = *stock;
        next.id = Id<StockTag>{stock->id.value + m_shift};
        m_stocks.emplace(stock->id, next.id);
        m_newStocks.insert(stock->id);
        document.stocks.push_back(std::make_shared<const Stock>(std::move(next)));
    }
    m_stocks.emplace(StockId(), StockId());
    if (m_isFirst)
        document.currentStock = moved(m_other.currentStock);
}

void Inserter::addSections()
{
    Document &document = m_result.document;
    FreeNames names(document.sections, m_other.sections);
    for (const SectionPointer &pointer : m_other.sections) {
        Section next = *pointer;
        next.id = moved(next.id);
        next.name = names.take(next.name);
        next.stock = moved(next.stock);
        if (next.parent)
            next.parent->section = moved(next.parent->section);
        m_result.sections.push_back(next.id);
        document.sections.push_back(std::make_shared<const Section>(std::move(next)));
    }
}

/// What was drawn on what operations make, by the keys that those have now.
void Inserter::settleParents()
{
    auto place = m_result.document.sections.end() - std::ssize(m_other.sections);
    for (const SectionPointer &section : m_other.sections) {
        SectionPointer &pointer = *place++;
        if (!section->parent || !section->parent->section.operation.isValid())
            continue;
        Section next = *pointer;
        next.parent->section = moved(section->parent->section);
        pointer = std::make_shared<const Section>(std::move(next));
    }
}

Operation Inserter::moved(const Operation &operation) const
{
    Operation next = operation;
    next.id = moved(operation.id);
    next.subject = moved(operation.subject);
    next.stock = moved(operation.stock);
    for (auto &[role, inputs] : next.inputs)
        for (OperationInput &input : inputs)
            input.section = moved(input.section);
    next.exceptions.clear();
    for (const auto &[key, exception] : operation.exceptions) {
        Exception same = exception;
        same.stock = moved(exception.stock);
        next.exceptions.emplace(movedKey(operation.id, key), same);
    }
    return next;
}

/// Keys may have ids in them, as each kind wants it. Since ids keep their order, what an operation
/// makes there comes in the order in which it makes it here: so both are made and compared.
void Inserter::addOperations()
{
    Document here = m_other;
    here.operations.clear();
    here.loads.clear();
    here.dimensions.clear();
    here.jointOverrides.clear();
    Document there = newDocument();
    there.stocks = m_result.document.stocks;
    there.currentStock = m_result.document.currentStock;
    there.sections.assign(m_result.document.sections.end() - std::ssize(m_other.sections),
                          m_result.document.sections.end());
    Model from = evaluate(here), to = evaluate(there);
    const auto bare = [](Operation operation) {
        operation.isOn = true;
        operation.exceptions.clear();
        return std::make_shared<const Operation>(std::move(operation));
    };
    for (const OperationPointer &operation : m_other.operations) {
        here.operations.push_back(bare(*operation));
        there.operations.push_back(bare(moved(*operation)));
        from = evaluate(here, from);
        to = evaluate(there, to);
        const OperationResult *made = from.resultOf(operation->id);
        const OperationResult *again = to.resultOf(moved(operation->id));
        if (!made || !again || made->sections.size() != again->sections.size())
            continue;
        for (std::size_t i = 0; i < made->sections.size(); ++i)
            m_keys[operation->id].emplace(made->sections[i]->made.key,
                                          again->sections[i]->made.key);
        settleParents();
        there.sections.assign(m_result.document.sections.end() - std::ssize(m_other.sections),
                              m_result.document.sections.end());
    }
    FreeNames names(m_result.document.operations, m_other.operations);
    for (const OperationPointer &operation : m_other.operations) {
        Operation next = moved(*operation);
        next.name = names.take(next.name);
        m_result.operations.push_back(next.id);
        m_result.document.operations.push_back(std::make_shared<const Operation>(std::move(next)));
    }
}

void Inserter::addTemplates()
{
    Document &document = m_result.document;
    for (const BlobPointer &blob : m_other.blobs)
        document = addBlob(std::move(document), blob);
    FreeNames names(document.templates, m_other.templates);
    for (const TemplatePointer &pointer : m_other.templates) {
        Template next = *pointer;
        next.id = moved(next.id);
        next.name = names.take(next.name);
        if (next.on != SectionRef())
            next.on = moved(next.on);
        for (Magnet &magnet : next.magnets)
            magnet.section = moved(magnet.section);
        settleMagnets(next);
        document.templates.push_back(std::make_shared<const Template>(std::move(next)));
    }
}

void Inserter::addMarks()
{
    Document &document = m_result.document;
    for (Load weight : m_other.loads) {
        weight.id = moved(weight.id);
        weight.section = moved(weight.section);
        document.loads.push_back(std::move(weight));
    }
    for (Dimension dimension : m_other.dimensions) {
        dimension.id = moved(dimension.id);
        for (Anchor *anchor : {&dimension.from, &dimension.to})
            if (anchor->section != SectionRef())
                anchor->section = moved(anchor->section);
        document.dimensions.push_back(std::move(dimension));
    }
    for (const SectionTurning &one : m_other.turnings)
        document = *setTurning(std::move(document), moved(one.section), one.turning);
    addTemplates();
    // What is called so here already means what it means here.
    for (const NamedNumber &number : m_other.numbers)
        if (!findNumber(document, number.name))
            document.numbers.push_back(number);
    for (const JointOverridePointer &joint : m_other.jointOverrides) {
        JointOverride next = *joint;
        next.a = moved(joint->a);
        next.b = moved(joint->b);
        document.jointOverrides.push_back(std::make_shared<const JointOverride>(std::move(next)));
    }
    std::sort(document.jointOverrides.begin(), document.jointOverrides.end(),
              [](const JointOverridePointer &a, const JointOverridePointer &b) {
                  return std::tie(a->a, a->b) < std::tie(b->a, b->b);
              });
}

/// Folded names of the other's values that this document has, with all that they are made of, by
/// all that they say but their ids.
std::set<std::string> Inserter::sharedValues() const
{
    const Values &here = m_result.document.values, &others = m_other.values;
    std::set<std::string> shared;
    for (const ValuePointer &known : others.list) {
        const Value *same = here.find(known->value.name);
        Value value = known->value;
        value.id = same ? same->id : ValueId();
        if (same && value == *same)
            shared.insert(known->folded);
    }
    const auto isMadeOfOthers = [&](const ValuePointer &known) {
        return known->typed &&
               std::any_of(known->typed->names().begin(), known->typed->names().end(),
                           [&](const std::string &name) {
                               return !shared.contains(name) && others.find(name);
                           });
    };
    for (bool isSettled = false; !isSettled;) {
        isSettled = true;
        for (const ValuePointer &known : others.list)
            if (shared.contains(known->folded) && isMadeOfOthers(known)) {
                shared.erase(known->folded);
                isSettled = false;
            }
    }
    return shared;
}

/// Of the other's number here; nothing where that is one of this document's own.
std::optional<DrivenPlace> Inserter::moved(const DrivenPlace &place) const
{
    DrivenPlace next = place;
    if (place.of == DrivenPlace::Of::Stock && !m_newStocks.contains(StockId{place.id}))
        return std::nullopt;
    if (place.of != DrivenPlace::Of::Joint) {
        next.id += m_shift;
        return next;
    }
    next.a = moved(place.a);
    next.b = moved(place.b);
    return next;
}

void Inserter::addValues()
{
    Document &document = m_result.document;
    const std::set<std::string> shared = sharedValues();
    Values coming;
    for (const ValuePointer &known : m_other.values.list)
        if (!shared.contains(known->folded))
            coming.list.push_back(known);
    if (!coming.list.empty())
        coming.presets = m_other.values.presets;
    ValueMerge merge = mergedValues(document.values, coming, document.nextId);
    document.values = std::move(merge.values);
    document.nextId += std::ssize(coming.list);
    for (const BindingPointer &pointer : m_other.bindings) {
        const std::optional<DrivenPlace> place = moved(pointer->binding.place);
        if (!place)
            continue;
        Binding next = pointer->binding;
        next.place = *place;
        next.typed = renamedIn(next.typed, next.kind, merge.renames);
        document = withBinding(std::move(document), std::move(next));
    }
}

Insertion Inserter::insert()
{
    Document &document = m_result.document;
    addStocks();
    addSections();
    addOperations();
    addMarks();
    document.nextId += m_other.nextId - 1;
    addValues();
    const Model model = evaluate(document);
    document = model.document;
    for (const OperationId id : m_result.operations)
        if (const OperationResult *made = model.resultOf(id))
            for (const SectionPointer &section : made->sections)
                m_result.sections.push_back(section->made);
    std::erase_if(m_result.sections, // whose places operations take
                  [&model](const SectionRef &ref) { return model.indexOf(ref) < 0; });
    return std::move(m_result);
}

} // namespace

Insertion inserted(Document into, const Document &other)
{
    return Inserter(std::move(into), other, false).insert();
}

Insertion insertedAttached(Document into, const Document &other)
{
    return Inserter(std::move(into), other, true).insert();
}

} // namespace fff
