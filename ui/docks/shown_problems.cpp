#include "ui/docks/shown_problems.h"

#include "core/analysis/outlined_sections.h"

#include <iterator>
#include <utility>

namespace fff::ui {

ShownProblems shownProblems(const std::vector<CheckEntry> &entries, const Model &model,
                            const std::optional<Finding> &chosen, const Finding *lit)
{
    ShownProblems shown;
    ProblemLook &look = shown.look;
    for (const CheckEntry &entry : entries) {
        const int chosenPlace = chosen ? entry.placeOf(*chosen) : -1;
        for (int place = 0; place < entry.count(); ++place) {
            const Finding &finding = entry.row.all[static_cast<std::size_t>(place)];
            const bool isChosen = place == chosenPlace;
            ProblemLook own = finding.kind->look ? finding.kind->look(finding) : ProblemLook();
            if (isProblem(finding) || isChosen)
                std::move(own.grounds.begin(), own.grounds.end(), std::back_inserter(look.grounds));
            std::move(own.feet.begin(), own.feet.end(), std::back_inserter(look.feet));
            if (isChosen)
                std::move(own.links.begin(), own.links.end(), std::back_inserter(look.links));
            if (!isProblem(finding) || !(isChosen || &finding == lit))
                continue;
            const bool isHatched = isChosen && finding.subject() != Subject::Stability;
            std::vector<SectionRef> sections = outlinedSections(finding, model);
            if (finding.severity < Severity::Error)
                shown.doubtful.insert(shown.doubtful.end(), sections.begin(), sections.end());
            shown.*(isHatched ? &ShownProblems::hatched : &ShownProblems::outlined) =
                std::move(sections);
        }
    }
    return shown;
}

} // namespace fff::ui
