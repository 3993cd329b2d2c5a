// The joints of a section: with which other one, of what kind, how long. A click selects the joint.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "core/model/section.h"

#include <vector>

class QLabel;

namespace fff::ui {

class JointRow;

class JointRows : public QWidget
{
    Q_OBJECT
public:
    struct Entry
    {
        SectionRef other;
        QString name, text;
        bool isProblem = false;
        QString brief = {}; // of the text, where there is no room for all of it
        bool operator==(const Entry &) const = default;
    };

    explicit JointRows(QWidget *parent = nullptr);

    /// Changes only what differs.
    void setEntries(const std::vector<Entry> &entries);

    /// That of the joint with this section, if there is one.
    void focusRow(const SectionRef &other);

Q_SIGNALS:
    /// The joint with that section.
    void chosen(const fff::SectionRef &other);
    /// The cursor is on that row, or on none any more (an empty one).
    void hovered(const fff::SectionRef &other);

private:
    void addRow();

    std::vector<Entry> m_entries;
    std::vector<JointRow *> m_rows; // as many as entries, or more, hidden
    QLabel *m_empty = nullptr;
};

} // namespace fff::ui
