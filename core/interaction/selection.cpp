#include "core/interaction/selection.h"

#include "core/assembly/joint_state.h"

#include <algorithm>
#include <utility>

namespace fff {

void Selection::select(std::vector<SectionRef> sections)
{
    if (sections != m_sections || m_joint || m_operation.isValid() || m_load.isValid()) {
        m_before.clear();
        m_lost.reset();
        m_lostOperation = {};
        m_lostLoad = {};
    }
    m_operation = {};
    m_load = {};
    m_joint.reset();
    m_origin.clear();
    m_sections = std::move(sections);
}

void Selection::selectJoint(const JointRef &joint)
{
    if (m_joint == joint)
        return;
    if (!m_joint)
        m_origin = m_sections;
    m_before.clear();
    m_lost.reset();
    m_lostOperation = m_operation = {};
    m_lostLoad = m_load = {};
    m_sections.clear();
    m_joint = joint;
}

void Selection::selectOperation(OperationId id)
{
    select({});
    m_lostOperation = {};
    m_lostLoad = {};
    m_operation = id;
}

void Selection::selectLoad(LoadId id)
{
    select({});
    m_before.clear();
    m_lost.reset();
    m_lostOperation = {};
    m_lostLoad = {};
    m_load = id;
}

void Selection::leaveJoint(const Model &model)
{
    std::vector<SectionRef> origin = m_origin;
    std::erase_if(origin, [&](const SectionRef &ref) { return model.indexOf(ref) < 0; });
    select(std::move(origin));
}

void Selection::followJoint(const Model &model)
{
    if (hasJoint(model, *m_joint))
        return;
    const JointRef lost = *m_joint;
    leaveJoint(model);
    if (m_sections.empty())
        for (const SectionRef &ref : {lost.a, lost.b})
            if (model.indexOf(ref) >= 0)
                m_sections.push_back(ref);
    m_lost = lost;
    m_left = m_sections;
}

void Selection::goBack()
{
    const OperationId made = operationInFocus(*this);
    if (m_sections.size() == 1 && made.isValid())
        selectOperation(made);
    else
        select({});
}

/// True when that is all there was to do.
bool Selection::followOperation(const Document &document)
{
    if (m_operation.isValid() && !document.find(m_operation)) {
        m_lostOperation = std::exchange(m_operation, {});
        return true;
    }
    if (m_lostOperation.isValid() && isEmpty() && document.find(m_lostOperation))
        selectOperation(m_lostOperation);
    return m_operation.isValid();
}

/// The same of a weight.
bool Selection::followWeight(const Document &document)
{
    if (m_load.isValid() && !document.find(m_load)) {
        m_lostLoad = std::exchange(m_load, {});
        return true;
    }
    if (m_lostLoad.isValid() && isEmpty() && document.find(m_lostLoad))
        selectLoad(m_lostLoad);
    return m_load.isValid();
}

void Selection::follow(const Model &model)
{
    if (followOperation(model.document) || followWeight(model.document))
        return;
    if (m_joint) {
        followJoint(model);
        return;
    }
    if (m_lost && m_sections == m_left && hasJoint(model, *m_lost)) {
        const JointRef back = *m_lost;
        selectJoint(back);
        return;
    }
    const auto isGone = [&](const SectionRef &ref) { return model.indexOf(ref) < 0; };
    if (!m_before.empty() && m_sections == m_left &&
        std::none_of(m_before.begin(), m_before.end(), isGone)) {
        m_sections = std::exchange(m_before, {});
        return;
    }
    if (std::none_of(m_sections.begin(), m_sections.end(), isGone))
        return;
    m_before = m_sections;
    std::erase_if(m_sections, isGone);
    m_left = m_sections;
}

void Selection::forget()
{
    m_before.clear();
    m_lost.reset();
    m_lostOperation = m_operation = {};
    m_lostLoad = m_load = {};
    m_joint.reset();
    m_origin.clear();
}

std::vector<SectionRef> sectionsInFocus(const Model &model, const Selection &selection)
{
    std::vector<SectionRef> sections = selection.sections();
    if (const OperationResult *result = model.resultOf(selection.operation())) {
        for (const SectionPointer &section : result->sections)
            sections.push_back(section->ref());
        for (const auto &[ref, section] : result->changed)
            if (section)
                sections.push_back(ref);
    }
    std::erase_if(sections, [&](const SectionRef &ref) { return model.indexOf(ref) < 0; });
    return sections;
}

OperationId operationInFocus(const Selection &selection)
{
    OperationId id = selection.operation();
    for (const SectionRef &ref : selection.sections()) {
        if (ref.drawn.isValid() || (id.isValid() && id != ref.operation))
            return {};
        id = ref.operation;
    }
    return id;
}

} // namespace fff
