// The group "Dimensions" of the Properties dock: lengths that stay. Typing another one stretches
// the section that it is on; between two sections it scales the whole model.
#pragma once

#include "core/model/binding.h"
#include "ui/properties/varying_rows.h"

#include <optional>
#include <vector>

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
    std::optional<DrivenPlace> place(std::size_t index) const;
    void change(std::size_t index, double length);
    QString name(std::size_t index) const;
    QString tip(std::size_t index) const;

    Workbench &m_bench;
    VaryingRows m_rows;
    std::vector<PropertyRow *> m_lengths; // as they are listed
};

} // namespace fff::ui
