// What is selected, sections, a joint, an operation or a weight, and how it comes back when Undo
// brings back what was deleted.
#pragma once

#include "core/model/joint_ref.h"
#include "core/model/model.h"

#include <optional>
#include <vector>

namespace fff {

class Selection
{
public:
    const std::vector<SectionRef> &sections() const { return m_sections; }
    /// While one is selected no section is.
    const std::optional<JointRef> &joint() const { return m_joint; }
    /// While one is selected neither a section nor a joint is; not valid: none is.
    OperationId operation() const { return m_operation; }
    /// While one is selected nothing else is; not valid: none is.
    LoadId load() const { return m_load; }
    bool isEmpty() const
    {
        return m_sections.empty() && !m_joint && !m_operation.isValid() && !m_load.isValid();
    }
    void select(std::vector<SectionRef> sections);
    void selectJoint(const JointRef &joint);
    void selectOperation(OperationId id);
    void selectLoad(LoadId id);
    /// One step back from sections or an operation: from one section that an operation made to
    /// that, else to nothing.
    void goBack();
    /// One step back from a joint: to the sections that it was chosen from, as far as they are
    /// there.
    void leaveJoint(const Model &model);

    /// Sections went or came. Those that went are not selected, but are again when they come back,
    /// if nobody has chosen something else meanwhile. In place of a joint that is none any more
    /// those that it was chosen from are selected, or of its two sections those that are left.
    void follow(const Model &model);
    /// Another document: ids of the one before name other sections.
    void forget();

private:
    void followJoint(const Model &model);
    bool followOperation(const Document &document);
    bool followWeight(const Document &document);

    std::vector<SectionRef> m_sections;
    std::vector<SectionRef> m_before, m_left; // before sections of it went, and what stayed
    std::optional<JointRef> m_joint;
    std::optional<JointRef> m_lost;   // a joint that went
    std::vector<SectionRef> m_origin; // sections that were selected before the joint
    OperationId m_operation, m_lostOperation;
    LoadId m_load, m_lostLoad;
};

/// The selected sections that are there; of a selected operation those that it made or changed.
std::vector<SectionRef> sectionsInFocus(const Model &model, const Selection &selection);
/// The operation that is selected, or that made all that is; not valid: there is none.
OperationId operationInFocus(const Selection &selection);

} // namespace fff
