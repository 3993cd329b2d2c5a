// Marks of joints: one at each place where slits meet, for the joints of what is selected. They are
// hovered, clicked and dragged, and drawn over everything.
#pragma once

#include "core/assembly/joint_state.h"
#include "core/interaction/pointer_event.h"
#include "core/interaction/selection.h"
#include "core/interaction/sight.h"

#include <optional>
#include <vector>

namespace fff {

struct JointMark
{
    JointRef joint;
    int overlap = 0;        // index into the joint's overlaps
    Vec3 at = Vec3::Zero(); // where its slits meet, or its middle; world, mm
    bool moves = false;     // the slits can meet elsewhere
    bool isProblem = false; // no slit lets them slide together

    bool operator==(const JointMark &) const = default;
};

/// What a joint looks like when it is pointed at.
struct JointLook
{
    struct Outline
    {
        SectionRef host;
        int overlap = 0;           // index into the joint's overlaps
        std::vector<Vec3> corners; // of a slit, closed, on the mid-plane; world, mm
        bool operator==(const Outline &) const = default;
    };
    JointRef joint;
    std::vector<Outline> slits;      // of both sections
    std::vector<Vec3> meetingPoints; // one an overlap
    Vec3 opens = Vec3::Zero();       // where slits of b open to, unit; zero: no side

    bool operator==(const JointLook &) const = default;
};

JointLook lookOf(const Model &model, const JointState &state);
JointMark markOf(const JointState &state, int overlap);

/// The marks of a selection, found anew only when it or the document becomes another one.
class JointMarks
{
public:
    /// Of more sections than this there are none: they would hide the model.
    static constexpr std::size_t kMostSections = 4;

    const std::vector<JointMark> &of(const Model &model, const Selection &selection);
    /// Null when there is no such joint. Of the model and selection asked for last.
    const JointLook *look(const JointRef &joint) const;

private:
    void add(const Model &model, const JointRef &joint);

    std::optional<Document> m_document;
    std::vector<SectionRef> m_sections;
    std::optional<JointRef> m_joint;
    std::vector<JointMark> m_marks;
    std::vector<JointLook> m_looks;
};

/// How far the cursor may be off a mark, px.
double reachOf(Pointer pointer);

/// Index of the nearest of the marks within reach of the place (px), else of the one whose slit is
/// there, of the joint that is selected (may be null); −1 when there is none. Those of sections
/// that are hidden or stand back are passed over.
int jointMarkAt(const std::vector<JointMark> &marks, const JointLook *selected, const Sight &sight,
                const Vec2 &position, double reach);
bool isShown(const JointMark &mark, const Sight &sight);

} // namespace fff
