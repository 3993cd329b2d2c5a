// The group "Template" of the Properties dock: whether the selected sections pull meshes into their
// planes, and from how far.
#pragma once

#include "ui/properties/property_rows.h"

class QCheckBox;

namespace fff::ui {

class Workbench;

class MagnetGroup : public PropertyGroup
{
    Q_OBJECT
public:
    explicit MagnetGroup(Workbench &bench, QWidget *parent = nullptr);

    /// Hidden where there is no mesh that could be pulled.
    void refresh();

private:
    Workbench &m_bench;
    QCheckBox *m_pulls = nullptr;
    LengthRow *m_reach = nullptr;
};

} // namespace fff::ui
