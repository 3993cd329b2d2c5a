// The group "Dimensions" of the Properties dock: lengths that stay; typing another one scales the
// whole model.
#pragma once

#include "ui/properties/varying_rows.h"

namespace fff::ui {

class Workbench;

class DimensionGroup : public PropertyGroup
{
public:
    explicit DimensionGroup(Workbench &bench, QWidget *parent = nullptr);

    /// Hidden while there are none.
    void refresh();

private:
    void add(std::size_t index);
    std::optional<double> length(std::size_t index) const;

    Workbench &m_bench;
    VaryingRows m_rows;
};

} // namespace fff::ui
