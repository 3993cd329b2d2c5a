// The numbers with names of a file from before there were values (core/values), beside which they
// go on, in the Properties dock. Other models do not have the group.
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
    bool set(const QString &name, const QString &expression, QWidget *field);

    Workbench &m_bench;
    VaryingRows m_rows;
};

} // namespace fff::ui
