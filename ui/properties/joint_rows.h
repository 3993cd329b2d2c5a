// The joints of a section: with which other one, of what kind, how long. A click selects the other.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "core/assembly/joint.h"

#include <vector>

class QLabel;

namespace fff::ui {

/// "cross lap"
QString jointKindText(JointKind kind);

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
        bool operator==(const Entry &) const = default;
    };

    explicit JointRows(QWidget *parent = nullptr);

    /// Changes only what differs.
    void setEntries(const std::vector<Entry> &entries);

Q_SIGNALS:
    void chosen(const fff::SectionRef &section);

private:
    std::vector<Entry> m_entries;
    std::vector<JointRow *> m_rows; // as many as entries, or more, hidden
    QLabel *m_empty = nullptr;
};

} // namespace fff::ui
