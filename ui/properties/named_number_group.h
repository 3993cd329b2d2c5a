// The group "Numbers" of the Properties dock: numbers with names, to be used wherever one is typed.
#pragma once

#include "ui/properties/varying_rows.h"

class QLineEdit;

namespace fff::ui {

class Workbench;

class NamedNumberGroup : public PropertyGroup
{
public:
    explicit NamedNumberGroup(Workbench &bench, QWidget *parent = nullptr);

    void refresh();

private:
    void add(std::size_t index);
    void addNew();
    bool set(const QString &name, const QString &expression, QWidget *field);

    Workbench &m_bench;
    VaryingRows m_rows;
};

} // namespace fff::ui
