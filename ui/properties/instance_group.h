// The properties of a section that an operation made: by which, and what can be done to it alone.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "core/model/section.h"
#include "ui/properties/property_rows.h"

class QCheckBox;
class QLabel;
class QPushButton;

namespace fff::ui {

class LinkRow;
class Workbench;

class InstanceGroup : public PropertyGroup
{
    Q_OBJECT
public:
    InstanceGroup(Workbench &bench, QWidget *parent);

    /// Hides itself unless the one section that is selected was made by an operation.
    void refresh();

private:
    Workbench &m_bench;
    LinkRow *m_madeBy = nullptr;
    LinkRow *m_source = nullptr; // of an image
    EditorRow *m_sourceRow = nullptr;
    QCheckBox *m_leaveOut = nullptr;
    QPushButton *m_detach = nullptr;
    SectionRef m_section, m_origin;
};

} // namespace fff::ui
