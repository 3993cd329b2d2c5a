// What the Properties dock shows of the sections that are selected: stock, place, contour, the
// selected points and, of a single one, its joints.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "core/model/joint_ref.h"
#include "ui/properties/driven_field.h"

#include <optional>
#include <vector>

namespace fff::ui {

class FigureGroup;
class MagnetGroup;
class MarkGroup;
class InstanceGroup;
class JointRows;
class PlaceGroup;
class PointGroup;
class PropertyGroup;
class PropertyRow;
class SheetGroup;
class Workbench;

class SectionPage : public QWidget
{
    Q_OBJECT
public:
    SectionPage(Workbench &bench, QWidget *parent);

    void refresh();
    /// On the row of the joint with that section.
    void focusJoint(const SectionRef &other);
    /// Tells the view whether the list of joints is in sight: then they are marked there.
    void tellListed();

Q_SIGNALS:
    /// The joint of that row in the list.
    void jointWanted(const fff::JointRef &joint);
    /// The stock editor shall show this one.
    void stockWanted(fff::StockId stock);

protected:
    bool eventFilter(QObject *object, QEvent *event) override;

private:
    void addStockRows(PropertyGroup *group);
    void addTurningRow(PropertyGroup *group);
    void addSize(PropertyGroup *group, const QString &name, const char *objectName,
                 const char *field, int axis);
    void addContourRows(PropertyGroup *group);
    void refreshJoints();
    std::optional<double> commonThickness() const;

    Workbench &m_bench;
    InstanceGroup *m_instanceGroup = nullptr;
    SheetGroup *m_sheetGroup = nullptr;
    PlaceGroup *m_placeGroup = nullptr;
    MarkGroup *m_markGroup = nullptr;
    MagnetGroup *m_magnetGroup = nullptr;
    FigureGroup *m_figureGroup = nullptr;
    PointGroup *m_pointGroup = nullptr;
    PropertyGroup *m_jointGroup = nullptr;
    JointRows *m_joints = nullptr;
    std::vector<int> m_selected; // indices in the model that is shown, as of refresh()
    std::vector<PropertyRow *> m_rows;
    struct Size
    {
        PropertyRow *row;
        PlaceNow place;
    };
    std::vector<Size> m_sizes;
};

} // namespace fff::ui
