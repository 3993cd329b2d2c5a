// What the Properties dock shows of the weight or the push that is selected.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "core/model/load.h"
#include "ui/properties/number_edit.h"

#include <functional>
#include <vector>

namespace fff::ui {

class PropertyGroup;
class PropertyRow;
class SliderField;
class Workbench;

class LoadPage : public QWidget
{
    Q_OBJECT
public:
    LoadPage(Workbench &bench, QWidget *parent);

    /// Another load may be selected, or none: what is dragged for the one before is done.
    void follow();
    void refresh();

private:
    void addWeightRows(PropertyGroup *group);
    void addPushRows(PropertyGroup *group);
    void addSpreadRows(PropertyGroup *group);
    void addPlaceRows(PropertyGroup *group);
    PropertyRow *add(PropertyGroup *group, PropertyRow *row, std::function<bool()> isWanted);
    Followed followedOf(const char *field);
    PropertyRow *lengthRow(const QString &name, const char *objectName,
                           const NumberEdit::Range &range, const char *field,
                           std::function<double &(Load &)> in, PropertyGroup *group);
    /// Along an axis of the world.
    void addDirection(PropertyGroup *group, int axis, const QString &name, const char *objectName);

    /// The one that is shown; a plain one while none is.
    const Load &load() const { return m_load; }
    bool hasCopies() const;
    /// The load with this change, as a step or only to be seen.
    void change(const std::function<void(Load &)> &change);
    void preview(const std::function<void(Load &)> &change);

    struct Row
    {
        PropertyRow *row;
        std::function<bool()> isWanted;
    };
    Workbench &m_bench;
    Load m_load;
    std::vector<Row> m_rows;
    PropertyGroup *m_weight = nullptr, *m_push = nullptr;
    SliderField *m_water = nullptr;
};

} // namespace fff::ui
