// The rows of a design's values, under the headings of their groups. What is not shown to others
// comes last, and is folded where it is much.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "core/values/values.h"

#include <string>
#include <vector>

class QVBoxLayout;

namespace fff::ui {

class PropertyGroup;
class ValueRow;
class Workbench;

class ValueRows : public QWidget
{
    Q_OBJECT
public:
    ValueRows(Workbench &bench, QWidget *parent);

    /// Whoever only adjusts the design sees what is shown to others alone.
    void setAdjustsOnly(bool only);
    /// Rows that are there stay, with what is typed in them and what is unfolded.
    void refresh();
    void forgetRefusals();
    bool isEmpty() const { return m_rows.empty(); }
    /// The name of this value is to be typed.
    void beginNaming(ValueId value);

Q_SIGNALS:
    void hovered(ValueId value, bool isOver);

private:
    /// A heading, and whose rows stand under it.
    struct Heading
    {
        std::string group; // empty: none
        bool isHidden = false;
        std::vector<ValueId> values;

        bool operator==(const Heading &) const = default;
    };

    std::vector<Heading> headings() const;
    void arrange(const std::vector<Heading> &headings);
    ValueRow *takenRow(std::vector<ValueRow *> &before, ValueId value);
    bool isHiddenWrong() const;

    Workbench &m_bench;
    QVBoxLayout *m_column = nullptr;
    std::vector<Heading> m_headings;
    std::vector<PropertyGroup *> m_groups; // as the headings
    std::vector<ValueRow *> m_rows;
    bool m_adjustsOnly = false;
};

} // namespace fff::ui
