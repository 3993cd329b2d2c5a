// Three numbers of one thing in one row: a place, a direction.
#pragma once

#include "ui/properties/property_rows.h"

#include <array>

namespace fff::ui {

class TripleRow : public PropertyRow
{
public:
    /// Of one axis; nothing when the selected things differ in it.
    using Read = std::function<std::optional<double>(int axis)>;

    /// edits  of X, Y and Z, which announce changes by themselves and have their object names
    /// tips   what each of them is
    TripleRow(const QString &name, const std::array<NumberEdit *, 3> &edits,
              const std::array<QString, 3> &tips, Read read, QWidget *parent = nullptr);
    void refresh() override;

private:
    std::array<NumberEdit *, 3> m_edits;
    Read m_read;
};

} // namespace fff::ui
