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

/// Where a card goes that explains a place: to a side of it, in the view if it fits there, so that
/// it hides as little as can be of what it is about and of what is kept free. All in px.
/// around  what the place belongs to, as it is seen
QRectF cardPlace(const QSizeF &size, const QPointF &place, const QRectF &around,
                 const MarkPen &pen);

/// A card with the place, the neck seen flat, and these rows, beside `place`, px, with a line to
/// it.
void paintStressCard(MarkPen &pen, const Analysis &analysis, const StressLine &line,
                     const QPointF &place, const QLocale &locale);

} // namespace fff::ui
