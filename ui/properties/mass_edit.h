// The one field for masses: shows grams, and takes other units and sums ("1.5 kg", "2 lb",
// "3*12g"). Its value() is in g.
#pragma once

#include "ui/properties/number_edit.h"

namespace fff::ui {

class MassEdit : public NumberEdit
{
    Q_OBJECT
public:
    /// All of the range is meant in g.
    explicit MassEdit(const Range &range, QWidget *parent = nullptr);

protected:
    Expression read(const QString &text) const override;
};

} // namespace fff::ui
