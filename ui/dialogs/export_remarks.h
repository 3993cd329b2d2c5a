// What is to be said of a model before it is cut, in sentences: what the checks have found and what
// the drawing itself shows, the worst first.
#pragma once

#include "core/analysis/finding.h"
#include "ui/dialogs/cutting_work.h"

#include <QString>

#include <optional>
#include <vector>

namespace fff {
class CheckList;
struct Machine;
}

namespace fff::ui {

struct ExportRemark
{
    Severity severity = Severity::Good;
    QString title; // "Falls over forwards"; may be empty
    QString text;  // "The centre of mass …"
    // What there is to show of it in the model; with neither there is nothing.
    std::optional<Finding> finding;
    std::vector<SectionRef> sections;

    bool canBeShown() const { return finding || !sections.empty(); }
    bool operator==(const ExportRemark &other) const;
};

/// That the margins leave nothing of the stock's sheet; empty where they do.
/// margin  mm
QString noRoomText(const Stock &stock, double margin);

/// Never empty. Good is said in one line, of what is known to be good alone.
/// machine  that somebody chose; null: none in particular
std::vector<ExportRemark> exportRemarks(const CheckList &checks, const CuttingWork &work,
                                        const Machine *machine);

} // namespace fff::ui
