// Prints how suggested sections of the ten made forms compare with an even grid of slices:
// suggestion_table [-v] [-sSEED] [COUNT…] [FORM…]; run by hand. Of each: sections, time, the share
// of the silhouette that they show, the same of what is above the ground, how far that was lowered,
// how much is wrong by all checks, and how much of that is graver than thin walls beside slits.
// With -slices what an even grid, a row and slices around an axis come to in place of that.
#include "core/analysis/suggesting/suggestion.h"
#include "core/operations/evaluate.h"
#include "tests/core/session/suggested_forms.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

using namespace fff;
using namespace fff::test;

namespace {

void printSlices(const QStringList &names, bool isVerbose)
{
    std::printf("%-10s %8s %6s | %8s %5s %9s %5s %5s\n", "form", "planes", "each", "sections", "s",
                "assembled", "wrong", "grave");
    for (const MadeForm &form : madeForms()) {
        if (!names.isEmpty() && !names.contains(QLatin1String(form.name)))
            continue;
        const Document document = documentWith(form);
        for (const auto &[direction, planes] :
             {std::pair("xz", 5), std::pair("xz", 8), std::pair("xy", 5), std::pair("radial", 6)}) {
            const auto begin = std::chrono::steady_clock::now();
            const Model model = slicesOf(document, direction, planes);
            const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
            const QStringList faults = faultsOf(model);
            const bool isBlocked = !faults.filter(QStringLiteral("block each other")).isEmpty();
            std::printf("%-10s %8s %6d | %8zu %5.2f %9s %5d %5d\n", form.name, direction, planes,
                        model.sectionCount(), time.count(), isBlocked ? "no" : "yes",
                        int(faults.size()),
                        int(std::count_if(faults.begin(), faults.end(), isGrave)));
            for (const QString &fault : faults)
                if (isVerbose)
                    std::printf("    %s\n", qPrintable(fault));
            std::fflush(stdout);
        }
    }
}

} // namespace

int main(int argc, char **argv)
{
    std::vector<int> counts;
    QStringList names;
    bool isVerbose = false, isSlices = false;
    std::uint64_t seed = 1;
    for (int i = 1; i < argc; ++i) {
        if (argv[i] == std::string("-slices"))
            isSlices = true;
        else if (argv[i] == std::string("-v"))
            isVerbose = true;
        else if (std::string(argv[i]).starts_with("-s"))
            seed = std::strtoull(argv[i] + 2, nullptr, 10);
        else if (const int count = std::atoi(argv[i]); count > 0)
            counts.push_back(count);
        else
            names += QString::fromLocal8Bit(argv[i]);
    }
    if (isSlices) {
        printSlices(names, isVerbose);
        return 0;
    }
    if (counts.empty())
        counts = {8, 16, 32};
    struct Sum
    {
        int forms = 0, noWorse = 0, grave = 0;
        double slowest = 0.0;
    };
    std::map<int, Sum> sums;
    std::printf("%-10s %4s | %8s %5s %6s %6s %5s %5s %5s | %s\n", "form", "want", "sections", "s",
                "shown", "above", "low'd", "wrong", "grave",
                "even grid: sections, shown, above, wrong");
    for (const MadeForm &form : madeForms()) {
        if (!names.isEmpty() && !names.contains(QLatin1String(form.name)))
            continue;
        const Document document = documentWith(form);
        const Model model = evaluate(document);
        for (const int count : counts) {
            const auto begin = std::chrono::steady_clock::now();
            const Result<Suggestion> made = suggestSections(model, document.templates.front()->id,
                                                            {.count = count, .seed = seed});
            const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
            if (!made) {
                std::printf("%-10s %5d failed\n", form.name, count);
                continue;
            }
            const Document &after = made->document;
            const Template &before = *document.templates.front(), &now = *after.templates.front();
            const Model grid = evenGridOf(document, std::size_t(count));
            const double shown = silhouetteShown(now, after.sections),
                         ofGrid = silhouetteShown(before, grid.sections());
            const QStringList faults = faultsOf(evaluate(after));
            const auto grave = std::count_if(faults.begin(), faults.end(), isGrave);
            std::printf("%-10s %4d | %8zu %5.2f %5.1f%% %5.1f%% %5.1f %5d %5d | %3zu %5.1f%% "
                        "%5.1f%% %4d\n",
                        form.name, count, made->sections.size(), time.count(), 100.0 * shown,
                        100.0 * silhouetteShown(now, after.sections, 0.0), made->lowered,
                        int(faults.size()), int(grave), grid.sectionCount(), 100.0 * ofGrid,
                        100.0 * silhouetteShown(before, grid.sections(), made->lowered),
                        int(faultsOf(grid).size()));
            if (isVerbose)
                for (const QString &fault : faults)
                    std::printf("    %s\n", qPrintable(fault));
            std::fflush(stdout);
            Sum &sum = sums[count];
            ++sum.forms;
            sum.noWorse += shown > ofGrid - kAsGood ? 1 : 0;
            sum.grave += int(grave);
            sum.slowest = std::max(sum.slowest, time.count());
        }
    }
    for (const auto &[count, sum] : sums)
        std::printf("%d sections: no worse than the grid on %d of %d, graver faults %d, at most "
                    "%.1f s\n",
                    count, sum.noWorse, sum.forms, sum.grave, sum.slowest);
    return 0;
}
