// What the Properties dock shows of a section while it is drawn: stock, slit, contour, how it
// follows a template, and whether and why it is mirrored. Reads only; a stroke has the mouse.
#pragma once

#include <QWidget>

#include <functional>
#include <vector>

class QLabel;

namespace fff::ui {

class PropertyGroup;
class PropertyRow;
class Workbench;

class DrawingPage : public QWidget
{
    Q_OBJECT
public:
    DrawingPage(Workbench &bench, QWidget *parent);

    /// Whether a stroke is being drawn, so that this is to be seen.
    bool isWanted() const;
    void refresh();

private:
    void addRow(PropertyGroup *group, const QString &name, const char *objectName,
                std::function<QString()> read);
    QString ownSlit() const;
    QString symmetryText() const;

    Workbench &m_bench;
    QLabel *m_icon = nullptr, *m_name = nullptr, *m_kind = nullptr, *m_why = nullptr;
    PropertyGroup *m_slit = nullptr, *m_contour = nullptr, *m_template = nullptr;
    std::vector<PropertyRow *> m_rows;
};

} // namespace fff::ui
