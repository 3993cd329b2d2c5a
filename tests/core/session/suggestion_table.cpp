// Prints how suggested sections of the ten made forms compare with an even grid of slices:
// suggestion_table [-v] [COUNT…] [FORM…]; run by hand. Of each: sections, time, the share of the
// silhouette that they show, the same of what is above the ground, how far that was lowered, and
// how much is wrong by all checks.
#include "core/analysis/suggesting/suggestion.h"
#include "core/operations/evaluate.h"
#include "tests/core/session/suggested_forms.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

using namespace fff;
using namespace fff::test;

int main(int argc, char **argv)
{
    std::vector<int> counts;
    QStringList names;
    bool isVerbose = false;
    for (int i = 1; i < argc; ++i) {
        if (argv[i] == std::string("-v"))
            isVerbose = true;
        else if (const int count = std::atoi(argv[i]); count > 0)
            counts.push_back(count);
        else
            names += QString::fromLocal8Bit(argv[i]);
    }
    if (counts.empty())
        counts = {8, 16, 32};
    std::printf("%-10s %4s | %8s %5s %6s %6s %5s %s | %s\n", "form", "want", "sections", "s",
                "shown", "above", "low'd", "wrong", "even grid: sections, shown, above, wrong");
    for (const MadeForm &form : madeForms()) {
        if (!names.isEmpty() && !names.contains(QLatin1String(form.name)))
            continue;
        const Document document = documentWith(form);
        const Model model = evaluate(document);
        for (const int count : counts) {
            const auto begin = std::chrono::steady_clock::now();
            const Result<Suggestion> made =
                suggestSections(model, document.templates.front()->id, {.count = count});
            const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
            if (!made) {
                std::printf("%-10s %5d failed\n", form.name, count);
                continue;
            }
            const Document &after = made->document;
            const Template &before = *document.templates.front(), &now = *after.templates.front();
            const Model grid = evenGridOf(document, std::size_t(count));
            std::printf(
                "%-10s %4d | %8zu %5.2f %5.1f%% %5.1f%% %5.1f %4d | %3zu %5.1f%% %5.1f%% %4d\n",
                form.name, count, made->sections.size(), time.count(),
                100.0 * silhouetteShown(now, after.sections),
                100.0 * silhouetteShown(now, after.sections, 0.0), made->lowered,
                int(faultsOf(evaluate(after)).size()), grid.sectionCount(),
                100.0 * silhouetteShown(before, grid.sections()),
                100.0 * silhouetteShown(before, grid.sections(), made->lowered),
                int(faultsOf(grid).size()));
            for (const QString &fault : faultsOf(evaluate(after)))
                if (isVerbose)
                    std::printf("    %s\n", qPrintable(fault));
            std::fflush(stdout);
        }
    }
    return 0;
}
