// The numbers of what is selected, or of the model when nothing is. Rows read from the session and
// write through edits, one undo step each (ui/properties/property_rows.h).
#pragma once

#include <QDockWidget> // first: moc stumbles over some standard headers

#include "core/base/ids.h"

#include <QTimer>
#include <optional>
#include <vector>

namespace fff::ui {

class DrawingPage;
class JointRows;
class PointGroup;
class PropertiesHeader;
class PropertyGroup;
class PropertyRow;
class Workbench;

class PropertiesDock : public QDockWidget
{
    Q_OBJECT
public:
    explicit PropertiesDock(Workbench &bench, QWidget *parent = nullptr);

    /// Reads everything again; also for another theme.
    void refresh();

Q_SIGNALS:
    /// The stock editor shall show this one.
    void stockWanted(fff::StockId stock);

private:
    void follow();
    QWidget *makeModelPage(QWidget *parent);
    QWidget *makeSectionPage(QWidget *parent);
    void addStockRows(PropertyGroup *group);
    void addPlaceRows(PropertyGroup *group);
    void addContourRows(PropertyGroup *group);
    void refreshJoints();
    std::optional<double> commonThickness() const;
    PropertyRow *positionRow(int axis, const QString &name, const char *objectName,
                             QWidget *parent);

    Workbench &m_bench;
    PropertiesHeader *m_header = nullptr;
    QWidget *m_modelPage = nullptr, *m_sectionPage = nullptr;
    DrawingPage *m_drawingPage = nullptr; // while a stroke is drawn
    PointGroup *m_pointGroup = nullptr;
    PropertyGroup *m_jointGroup = nullptr;
    JointRows *m_joints = nullptr;
    std::vector<int> m_selected; // indices in the model that is shown, as of refresh()
    std::vector<PropertyRow *> m_modelRows, m_sectionRows;
    QTimer m_soon; // refreshes once all that came at once is in
};

} // namespace fff::ui
