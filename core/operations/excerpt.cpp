#include "core/operations/excerpt.h"

#include "core/model/bindings.h"
#include "core/model/placed_loads.h"
#include "core/model/sheet_edits.h"
#include "core/operations/baking.h"
#include "core/operations/drivable.h"
#include "core/operations/evaluate.h"
#include "core/operations/kept_slits.h"
#include "core/operations/operation_kind.h"
#include "core/values/presets.h"

#include <algorithm>
#include <map>
#include <set>

namespace fff {

namespace {

/// It is about the whole model, and could be about some of its sections.
bool isOfAll(const Operation &operation)
{
    const OperationKind *kind = operationKind(operation.kind);
    return kind && kind->narrow && kind->isOfAll(operation);
}

class Excerpt
{
public:
    Excerpt(const Model &model, const std::vector<SectionRef> &sections, bool isAttached)
        : m_model(model), m_wanted(sections.begin(), sections.end()), m_isAttached(isAttached)
    {
    }

    Document take();

private:
    bool isWanted(const SectionRef &ref) const { return m_wanted.contains(ref); }
    bool isWhole(const OperationResult &result) const;
    bool readsWanted(const Operation &operation) const;
    void chooseOperations();
    void addOperations();
    void addSections();
    void add(const Section &section);
    void settleParents();
    void addMarks();
    void addTurnings();
    void addStocks();
    void keepSlits();
    void addValues();
    /// What the section is called in the excerpt; empty: it is not there.
    SectionRef newRef(const SectionRef &ref) const;

    const Model &m_model;
    std::set<SectionRef> m_wanted;
    const bool m_isAttached;                  // to what it is an excerpt of
    std::set<OperationId> m_operations;       // that come along
    std::set<SectionId> m_read;               // drawn ones that are not shown, but read by those
    std::map<SectionRef, SectionRef> m_drawn; // what became of those that come without theirs
    Document m_result;
};

/// All that it made or changed is wanted, as far as it is shown.
bool Excerpt::isWhole(const OperationResult &result) const
{
    const auto &made = result.sections;
    const auto &changed = result.changed;
    return (!made.empty() || !changed.empty()) &&
           std::all_of(made.begin(), made.end(),
                       [this](const SectionPointer &s) {
                           return isWanted(s->made) || !m_model.find(s->made);
                       }) &&
           std::all_of(changed.begin(), changed.end(), [this](const auto &one) {
               return isWanted(one.first) || !m_model.find(one.first);
           });
}

/// One that is not shown, since an operation took its place, comes along with that.
bool Excerpt::readsWanted(const Operation &operation) const
{
    const OperationKind *kind = operationKind(operation.kind);
    for (const auto &[role, inputs] : operation.inputs) {
        const InputSpec *spec = kind ? kind->input(role) : nullptr;
        for (const OperationInput &input : inputs) {
            const SectionRef &ref = input.section;
            const bool isThere =
                ref.drawn.isValid()
                    ? isWanted(ref) || (m_model.document.find(ref.drawn) && !m_model.find(ref))
                    : m_operations.contains(ref.operation);
            if (!isThere && spec && counts(*spec, operation))
                return false;
        }
    }
    return true;
}

void Excerpt::chooseOperations()
{
    for (const OperationResultPointer &result : m_model.evaluation.results) {
        const Operation &operation = *result->operation;
        const bool stays = operation.subject.isValid(); // beside its template
        if (stays || !isWhole(*result) || !readsWanted(operation))
            continue;
        m_operations.insert(operation.id);
        for (const auto &[role, inputs] : operation.inputs)
            for (const OperationInput &input : inputs)
                if (!m_model.find(input.section) && m_model.document.find(input.section.drawn))
                    m_read.insert(input.section.drawn);
    }
}

void Excerpt::add(const Section &section)
{
    m_result.sections.push_back(std::make_shared<const Section>(section));
}

/// Drawn ones in the order of the document, then those that become such.
void Excerpt::addSections()
{
    std::set<SectionRef> reshaped; // by operations that do not come along
    for (const OperationResultPointer &result : m_model.evaluation.results)
        if (!m_operations.contains(result->operation->id))
            for (const auto &[ref, section] : result->changed)
                reshaped.insert(ref);
    for (const SectionPointer &drawn : m_model.document.sections) {
        const Section *shown = m_model.find(drawn->id);
        if (m_read.contains(drawn->id))
            add(*drawn);
        else if (shown && isWanted(drawn->id))
            add(reshaped.contains(drawn->id) ? *shown : *drawn);
    }
    for (std::size_t i = m_model.drawnCount(); i < m_model.sectionCount(); ++i) {
        const SectionPointer &made = m_model.section(i);
        if (!isWanted(made->made) || m_operations.contains(made->made.operation))
            continue;
        Section section = *made;
        section.id = SectionId{m_result.nextId++};
        section.made = {};
        section.copyOf.reset();
        m_drawn.emplace(made->made, section.id);
        add(section);
    }
}

SectionRef Excerpt::newRef(const SectionRef &ref) const
{
    if (const auto found = m_drawn.find(ref); found != m_drawn.end())
        return found->second;
    const bool isThere = ref.drawn.isValid() ? m_result.find(ref.drawn) != nullptr
                                             : m_operations.contains(ref.operation);
    return isThere ? ref : SectionRef();
}

void Excerpt::settleParents()
{
    for (SectionPointer &pointer : m_result.sections) {
        if (!pointer->parent)
            continue;
        const SectionRef parent = newRef(pointer->parent->section);
        if (parent == pointer->parent->section || (m_isAttached && parent == SectionRef()))
            continue;
        Section next = *pointer;
        if (parent == SectionRef())
            next.parent.reset();
        else
            next.parent->section = parent;
        pointer = std::make_shared<const Section>(std::move(next));
    }
}

void Excerpt::addOperations()
{
    for (const OperationPointer &operation : m_model.document.operations)
        if (m_operations.contains(operation->id))
            m_result.operations.push_back(operation);
}

/// Where parts are pinned says nothing without all the others around them.
void Excerpt::addTurnings()
{
    for (const SectionTurning &one : m_model.document.turnings)
        if (const SectionRef ref = newRef(one.section); ref != SectionRef())
            m_result = *setTurning(std::move(m_result), ref, one.turning);
    for (const auto &[ref, id] : m_drawn)
        if (const Section *copy = m_model.find(ref))
            if (const auto turning = turningOf(m_model.document, *copy))
                m_result = *setTurning(std::move(m_result), id, turning);
}

void Excerpt::addMarks()
{
    for (const Load &load : m_model.document.loads) {
        const SectionRef on = newRef(load.section);
        if (on == SectionRef())
            continue;
        m_result.loads.push_back(load);
        m_result.loads.back().section = on;
    }
    // Those on copies that become drawn ones are on these by themselves.
    for (const auto &[ref, id] : m_drawn) {
        const Section *copy = m_model.find(ref);
        for (Load own : copy ? carriedLoads(m_model.document, *copy) : std::vector<Load>()) {
            own.id = LoadId{m_result.nextId++};
            own.section = id;
            m_result.loads.push_back(std::move(own));
        }
    }
    for (Dimension dimension : m_model.document.dimensions) {
        dimension.from.section = newRef(dimension.from.section);
        dimension.to.section = newRef(dimension.to.section);
        if (dimension.from.section != SectionRef() && dimension.to.section != SectionRef())
            m_result.dimensions.push_back(dimension);
    }
    addTurnings();
    // Those of sections that became drawn ones would speak of another order.
    for (const JointOverridePointer &joint : m_model.document.jointOverrides)
        if (newRef(joint->a) == joint->a && newRef(joint->b) == joint->b)
            m_result.jointOverrides.push_back(joint);
}

void Excerpt::addStocks()
{
    std::set<StockId> used;
    for (const SectionPointer &section : m_result.sections)
        used.insert(section->stock);
    for (const OperationPointer &operation : m_result.operations)
        for (const auto &[key, exception] : operation->exceptions)
            used.insert(exception.stock);
    const Document &all = m_model.document;
    const StockId first =
        m_result.sections.empty() ? all.currentStock : m_result.sections.front()->stock;
    used.insert(first);
    for (const auto &stock : all.stocks)
        if (used.contains(stock->id))
            m_result.stocks.push_back(stock);
    m_result.currentStock = first;
}

/// Of slices, whose sides follow from what made them, which stays.
void Excerpt::keepSlits()
{
    const auto isSlice = [this](const auto &one) {
        const Operation *operation = m_model.document.find(one.first.operation);
        return operation && operation->subject.isValid();
    };
    if (!std::any_of(m_drawn.begin(), m_drawn.end(), isSlice))
        return;
    if (Result<Document> kept = withSlitsKept(m_result, m_model, m_drawn))
        m_result = *std::move(kept);
}

/// What was typed for numbers that are here, and the values of which that is made.
void Excerpt::addValues()
{
    const Document &all = m_model.document;
    std::set<ValueId> used;
    std::vector<const Typed *> reached;
    const auto reach = [&reached](const Understood<Typed> &typed) {
        if (typed)
            reached.push_back(&*typed);
    };
    for (const BindingPointer &pointer : all.bindings)
        if (drivenNumber(m_result, pointer->binding.place)) {
            m_result.bindings.push_back(pointer);
            reach(pointer->typed);
        }
    for (std::size_t i = 0; i < reached.size(); ++i)
        for (const std::string &name : reached[i]->names())
            if (const int index = all.values.indexOf(name); index >= 0) {
                const KnownValue &known = *all.values.list[static_cast<std::size_t>(index)];
                if (used.insert(known.value.id).second)
                    reach(known.typed);
            }
    std::map<ValueId, ValueId> taken;
    for (const ValuePointer &known : all.values.list)
        if (used.contains(known->value.id)) {
            m_result.values.list.push_back(known);
            taken.emplace(known->value.id, known->value.id);
        }
    mergePresets(m_result.values, all.values, taken);
}

Document Excerpt::take()
{
    m_result.nextId = m_model.document.nextId;
    chooseOperations();
    addSections();
    settleParents();
    addOperations();
    addMarks();
    addStocks();
    keepSlits();
    addValues();
    return selfContained(evaluate(std::move(m_result)));
}

} // namespace

Document excerpt(const Model &model, const std::vector<SectionRef> &sections)
{
    return Excerpt(model, sections, false).take();
}

Document attachedExcerpt(const Model &model, const std::vector<SectionRef> &sections)
{
    return Excerpt(model, sections, true).take();
}

Document selfContained(const Model &model)
{
    Model next = model;
    for (const OperationPointer &operation : model.document.operations) {
        if (!isOfAll(*operation))
            continue;
        const OperationKind &kind = *operationKind(operation->kind);
        std::vector<OperationInput> all;
        for (const SectionPointer &section : next.sections()) {
            const SectionRef ref = section->ref();
            const auto &operations = next.document.operations;
            // Those that it sees: drawn ones, and what operations above it made.
            const bool isAbove =
                ref.drawn.isValid() ||
                std::any_of(operations.begin(),
                            std::find_if(operations.begin(), operations.end(),
                                         [&](const auto &o) { return o->id == operation->id; }),
                            [&](const auto &o) { return o->id == ref.operation; });
            if (isAbove)
                all.push_back({ref, section->name});
        }
        Operation narrow = *operation;
        Document document = next.document;
        if (kind.narrow(narrow, std::move(all))) {
            for (OperationPointer &place : document.operations)
                if (place->id == narrow.id)
                    place = std::make_shared<const Operation>(narrow);
        } else if (Result<Document> drawn = baked(next, operation->id)) {
            document = *std::move(drawn);
        }
        next = evaluate(std::move(document), next);
    }
    return next.document;
}

} // namespace fff
