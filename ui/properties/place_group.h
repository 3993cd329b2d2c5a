// The group "Place" of the Properties dock: what a section is on, where it is and which way it
// faces, of all that are selected.
#pragma once

#include "ui/properties/property_rows.h"

#include "core/model/section.h"

#include <functional>
#include <optional>
#include <vector>

class QToolButton;

namespace fff::ui {

class Workbench;

class PlaceGroup : public PropertyGroup
{
public:
    explicit PlaceGroup(Workbench &bench, QWidget *parent = nullptr);

    /// Hidden where an operation says where they are.
    void refresh();

private:
    void addParent();
    void addAngle();
    void addHolding();
    void addPosition();
    void addNormal();
    void addSwitch(const QString &name, const char *objectName, const QString &tip,
                   const char *command, std::function<bool(const Section &)> read,
                   std::function<QString()> words = {});
    QString symmetryWords() const;
    void add(PropertyRow *row);

    /// The drawn sections behind what is selected, as they are shown.
    std::vector<const Section *> sections() const;
    const Section *parentOf(const Section &section) const;
    std::optional<double>
    common(const std::function<std::optional<double>(const Section &)> &valueOf) const;

    Workbench &m_bench;
    QToolButton *m_pick = nullptr, *m_off = nullptr; // of what it is on
    PropertyRow *m_angle = nullptr;                  // to that
    PropertyRow *m_holding = nullptr;                // when that is stretched
    std::vector<PropertyRow *> m_rows;
};

} // namespace fff::ui
