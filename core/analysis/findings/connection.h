// Whether joints hold all sections together.
#pragma once

#include "core/analysis/finder.h"

namespace fff {

/// Of both of them.
struct Connection
{
    int sections = 0, joints = 0; // all
    Text provided = {};           // kWouldConnect: what keeps them from it
};
/// Of kNotConnected: a group of bodies that nothing holds to the largest group, by their sections.
struct Gap
{
    std::optional<SectionRef> other; // who is nearest
    double distance = -1.0;          // to it, mm; negative: unknown
};

extern const FindingKind kConnected, kWouldConnect;
extern const FindingKind kNotConnected; // one a group

extern const ActionKind kDeleteSections;

void findConnection(const Looked &at, std::vector<Finding> &found);

} // namespace fff
