// A load in the hand: dragged over the sections by its place, or by the tip of its arrow.
#pragma once

#include "core/base/result.h"
#include "core/interaction/load_marks.h"
#include "core/interaction/pick.h"

namespace fff {

/// The nearest section under the cursor.
std::optional<Hit> sectionUnder(const Vec2 &position, const GestureContext &context);

class LoadDrag
{
public:
    /// Of one that is there.
    LoadDrag(const LoadAt &at, const Load &load);
    /// Of a new one, which is where it is put; of a push the tip is in the hand.
    explicit LoadDrag(const Load &load);

    const Load &load() const { return m_load; }
    bool isNew() const { return !m_load.id.isValid(); }
    bool hasMoved() const { return m_hasMoved; }

    /// Over a copy of its section it slides on the section itself, over others it goes to these; by
    /// its tip it is turned in the plane that faces the eye, to a right angle or along the world's
    /// axes where `snaps` and it is near to that. Beside all sections, and over locked ones, it
    /// stays.
    void follow(const Vec2 &position, bool snaps, const GestureContext &context);

    /// The document with it.
    Result<Document> document(const Document &committed) const;
    /// What that came to.
    Step step(const Model &model) const;
    /// Where it is now.
    std::optional<Vec3> place(const Model &model) const;

private:
    void slide(const Vec2 &position, const GestureContext &context);
    void turn(const Vec2 &position, bool snaps, const GestureContext &context);

    Load m_load;
    // Where it is held, its section or a copy of that, and as it is there.
    SectionRef m_on;
    Vec2 m_at = Vec2::Zero();
    Vec3 m_push = Vec3::Zero();
    Vec2 m_grip = Vec2::Zero(); // px, see LoadAt
    bool m_isTip = false;
    bool m_hasMoved = false;
};

} // namespace fff
