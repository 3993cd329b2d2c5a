// Mechanics against reference cases: a program of its own, for any folder of such cases.
//     tst_reference_cases [--cases DIR]
// Prints quantity, truth, ours and their ratio; 1 when anything is outside its tolerance, 2 when
// cases cannot be read.
#include "tests/core/physics/reference_comparison.h"
#include "tests/core/physics/reference_json.h"

#include <cstdio>

using namespace fff;
using namespace fff::test;

namespace {

bool compare(const ReferenceCase &found, const Tolerances &tolerances, int &doubtful)
{
    Report report(found.id);
    const Comparison comparison{found, tolerances, report};
    for (const std::string &unknown : tolerances.unknown)
        std::printf("%-34s nobody knows the tolerance \"%s\"\n", found.id.c_str(), unknown.c_str());
    const std::optional<Equilibrium> rigid = compareRigid(comparison);
    compareBeams(comparison, rigid);
    comparePlates(comparison, rigid);
    doubtful += report.doubtful();
    return report.isWithin();
}

int compareAll(const QDir &folder)
{
    const ReferenceIndex index(folder);
    int read = 0, outside = 0, doubtful = 0;
    std::printf("%-34s %-34s %13s %13s %9s\n", "case", "quantity", "truth", "ours", "ratio");
    for (const QString &name : folder.entryList({key("*.json")}, QDir::Files, QDir::Name)) {
        if (name == key("index.json"))
            continue;
        QString error;
        const std::optional<ReferenceCase> found = readReferenceCase(folder.filePath(name), &error);
        if (!found) {
            std::fprintf(stderr, "%s\n", qPrintable(error));
            return 2;
        }
        if (!found->json.contains(key("truth")) && !found->contact.isThere() &&
            !found->contactWithPlay.isThere())
            continue;
        ++read;
        outside += !compare(*found, index.of(*found), doubtful);
    }
    std::printf("%d cases, %d outside; %d numbers apart that are not judged\n", read, outside,
                doubtful);
    if (read == 0) {
        std::fprintf(stderr, "no cases in %s\n", qPrintable(folder.path()));
        return 2;
    }
    return outside > 0 ? 1 : 0;
}

} // namespace

int main(int argc, char *argv[])
{
    QString path = key(FFF_SHARED "/mechanics/cases");
    bool isGiven = false;
    for (int i = 1; i < argc; ++i) {
        if (QString::fromLocal8Bit(argv[i]) == key("--cases") && i + 1 < argc) {
            path = QString::fromLocal8Bit(argv[++i]);
            isGiven = true;
        } else {
            std::fprintf(stderr, "tst_reference_cases [--cases DIR]\n");
            return 2;
        }
    }
    if (!isGiven && !QDir(key(FFF_SHARED)).exists()) {
        std::printf("there is no " FFF_SHARED ", so nothing real was compared\n");
        return 0;
    }
    if (!QDir(path).exists()) {
        std::fprintf(stderr, "no folder %s\n", qPrintable(path));
        return 2;
    }
    return compareAll(QDir(path));
}
