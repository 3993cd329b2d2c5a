#include "ui/properties/mass_edit.h"

#include "ui/base/expression_text.h"
#include "ui/bench/number_names.h"

namespace fff::ui {

namespace {

constexpr double kGram = 1e-3; // kg

} // namespace

MassEdit::MassEdit(const Range &range, QWidget *parent) : NumberEdit(range, tr("g"), parent) {}

Expression MassEdit::read(const QString &text) const
{
    Expression mass = readMass(text.toStdString(), kGram, commasOf(locale()), numberNamesFor(this));
    if (mass.value)
        *mass.value /= kGram;
    return mass;
}

} // namespace fff::ui
