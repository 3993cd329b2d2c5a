// What is known of one cross-section, beside it in the view.
#pragma once

#include "core/analysis/stress_lines.h"
#include "ui/view/mark_pen.h"

#include <QLocale>

namespace fff::ui {

/// One line of the card.
struct StressRow
{
    QString what, value;
};

/// What strains it, the worst first, without what adds less than 2 % of all; then what breaks
/// first.
std::vector<StressRow> stressRows(const StressLine &line, const QLocale &locale);
QString breaksFirst(const StressLine &line);

/// A card with the place, the neck seen flat, and these rows, beside `place`, px.
void paintStressCard(MarkPen &pen, const Analysis &analysis, const StressLine &line,
                     const QPointF &place, const QLocale &locale);

} // namespace fff::ui
