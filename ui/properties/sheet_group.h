// The group "On the sheet" of the Properties dock: where the part of the selected section lies as
// it will be cut, how it is turned there, and whether it stays.
#pragma once

#include "ui/properties/property_rows.h"

#include "core/model/sheet_wishes.h"

#include <optional>
#include <vector>

class QCheckBox;

namespace fff::ui {

class Workbench;

class SheetGroup : public PropertyGroup
{
    Q_OBJECT
public:
    explicit SheetGroup(Workbench &bench, QWidget *parent = nullptr);

    /// Hidden where it is not known how parts lie, as long as nobody looks at the sheets.
    void refresh();

private:
    void addText(const QString &name, const char *objectName, const QString &text);
    void pin(bool isOn);

    Workbench &m_bench;
    std::optional<PinnedPlace> m_place; // of the part; none: hidden
    QString m_sheet, m_position, m_turn;
    bool m_fits = true; // a sheet
    QCheckBox *m_pinned = nullptr;
    std::vector<PropertyRow *> m_rows;
};

} // namespace fff::ui
