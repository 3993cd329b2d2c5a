#include "core/operations/value_dependents.h"

#include "core/model/bindings.h"

#include <algorithm>
#include <set>

namespace fff {

namespace {

/// What numbers are made of the value, as sections and operations.
class DependentSections
{
public:
    explicit DependentSections(const Model &model) : m_model(model) {}

    void takePlace(const DrivenPlace &place)
    {
        switch (place.of) {
        case DrivenPlace::Of::Stock:
            takeStock(StockId{place.id});
            break;
        case DrivenPlace::Of::Operation:
            m_operations.insert(OperationId{place.id});
            break;
        case DrivenPlace::Of::Section:
        case DrivenPlace::Of::Figure:
        case DrivenPlace::Of::Lettering:
            m_sections.insert(SectionRef(SectionId{place.id}));
            break;
        case DrivenPlace::Of::Load:
            if (const Load *load = m_model.document.find(LoadId{place.id}))
                m_sections.insert(load->section);
            break;
        case DrivenPlace::Of::Dimension:
            for (const Dimension &dimension : m_model.document.dimensions)
                if (dimension.id.value == place.id)
                    m_sections.insert(dimension.from.section);
            break;
        case DrivenPlace::Of::Joint:
            m_sections.insert(place.a);
            m_sections.insert(place.b);
            break;
        }
    }

    std::vector<SectionRef> take()
    {
        takeStanding();
        for (const OperationResultPointer &result : m_model.evaluation.results)
            if (m_operations.contains(result->operation->id) || looksAtOne(*result))
                takeMade(*result);
        std::vector<SectionRef> there;
        for (const SectionRef &section : m_sections)
            if (m_model.indexOf(section) >= 0)
                there.push_back(section);
        return there;
    }

private:
    void takeStock(StockId stock)
    {
        for (const SectionPointer &section : m_model.sections())
            if (section->stock == stock)
                m_sections.insert(section->ref());
    }
    /// Whole chains of them, in whatever order they are listed.
    void takeStanding()
    {
        for (bool isMore = true; isMore;) {
            isMore = false;
            for (const SectionPointer &section : m_model.document.sections)
                if (section->parent && m_sections.contains(section->parent->section))
                    isMore = m_sections.insert(section->ref()).second || isMore;
        }
    }
    bool looksAtOne(const OperationResult &result) const
    {
        return std::any_of(result.readSections.begin(), result.readSections.end(),
                           [this](const auto &read) { return m_sections.contains(read.first); });
    }
    void takeMade(const OperationResult &result)
    {
        for (const SectionPointer &section : result.sections)
            m_sections.insert(section->ref());
        for (const auto &[section, now] : result.changed)
            m_sections.insert(section);
    }

    const Model &m_model;
    std::set<SectionRef> m_sections;
    std::set<OperationId> m_operations;
};

} // namespace

std::vector<SectionRef> dependents(const Model &model, ValueId id)
{
    DependentSections sections(model);
    for (const DrivenPlace &place : boundTo(model.document, model.evaluation.values, id))
        sections.takePlace(place);
    return sections.take();
}

} // namespace fff
