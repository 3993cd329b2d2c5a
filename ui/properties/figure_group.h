// The group "Shape" of the Properties dock: of what figure the contour of the selected section is,
// and the numbers of those that its boundaries are still as.
#pragma once

#include "ui/properties/varying_rows.h"

#include "core/model/figures.h"

#include <QString>

#include <vector>

namespace fff::ui {

class Workbench;

class FigureGroup : public PropertyGroup
{
public:
    explicit FigureGroup(Workbench &bench, QWidget *parent = nullptr);

    /// Its own rows are hidden unless one section is selected that can be edited.
    void refresh();

private:
    void addKind();
    void rebuild(const Section &section);
    void addNumbers(int boundary, const FigureKind &kind);
    Followed followedOf(int boundary, const char *field) const;
    void addNumber(int boundary, const FigureKind &kind, std::size_t index);
    void addPlace(int boundary, int axis, const QString &name);
    void addTurn(int boundary);

    /// The drawn section; null: there is not one.
    const Section *section() const;
    std::optional<Figure> figure(int boundary) const;
    void change(int boundary, const std::function<void(Figure &)> &change);

    Workbench &m_bench;
    PropertyRow *m_kind = nullptr;
    PropertyGroup *m_numbers = nullptr; // between the kind and what others add
    VaryingRows m_rows;
};

} // namespace fff::ui
