// What the view shows of problems besides their marks: red is for what is looked at alone, so that
// a model with forty problems is still seen.
#pragma once

#include "core/analysis/problem_look.h"
#include "ui/docks/check_entries.h"

#include <optional>
#include <vector>

namespace fff::ui {

struct ShownProblems
{
    ProblemLook look;
    std::vector<SectionRef> hatched;  // red and hatched
    std::vector<SectionRef> outlined; // a red outline only
    std::vector<SectionRef> doubtful; // those of them that are amber: it is a warning
};

/// Hatched are the sections of the chosen problem, but of one about standing its feet are outlined;
/// so are those of the one that the cursor is on, by its row or its mark. Whether it stands
/// concerns the whole model, so that is drawn as long as it is a problem; who blocks whom of the
/// chosen one only, or it would be a web of lines.
/// lit  among the findings of the entries; null: the cursor is on none
ShownProblems shownProblems(const std::vector<CheckEntry> &entries, const Model &model,
                            const std::optional<Finding> &chosen, const Finding *lit);

} // namespace fff::ui
