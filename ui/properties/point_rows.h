// The group "Point" of the Properties dock: place, kind and handles of the selected control points.
#pragma once

#include "ui/properties/property_rows.h"

#include "core/interaction/point_editing.h"

#include <vector>

namespace fff::ui {

class Workbench;

class PointGroup : public PropertyGroup
{
public:
    explicit PointGroup(Workbench &bench, QWidget *parent = nullptr);

    /// Hidden when no point is selected.
    void refresh();

private:
    void addPlaces();
    void addKind();
    void addHandle(HandleSide side, const QString &length, const QString &angle);
    void add(PropertyRow *row);

    /// What all selected points have in common; nothing when they differ.
    std::optional<double>
    common(const std::function<double(const Contour &contour, int index)> &valueOf) const;
    void edit(const std::function<Result<Contour>(const Contour &, int index)> &change,
              bool moves = false);

    Workbench &m_bench;
    std::vector<PropertyRow *> m_rows;
};

} // namespace fff::ui
