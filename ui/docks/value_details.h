// What there is to say of a value besides what it is: its kind, its range, what it is for. Opens
// under its row.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "core/interaction/section_edit.h"
#include "core/values/values.h"

#include <functional>
#include <vector>

class QLineEdit;

namespace fff::ui {

class PropertyRow;
class Workbench;

class ValueDetails : public QWidget
{
    Q_OBJECT
public:
    ValueDetails(Workbench &bench, ValueId value, QWidget *parent);

    void refresh();

Q_SIGNALS:
    /// Empty: it was done, what was refused before counts no more.
    void refused(const QString &why);

private:
    using Change = std::function<bool(Value &value, const QString &text)>;
    const Value *value() const;
    PropertyRow *add(const QString &name, const char *id,
                     std::function<QString(const Value &)> read, Change change,
                     const QString &placeholder);
    void addKind();
    void addRange();
    void addShown();
    void addDelete();
    void change(const std::function<bool(Value &)> &how);
    void make(SectionEdit edit);

    Workbench &m_bench;
    const ValueId m_id;
    std::vector<PropertyRow *> m_rows;
    std::vector<QWidget *> m_ofNumbers; // rows of numeric kinds alone
    QWidget *m_choices = nullptr;       // the row of what can be chosen
    QWidget *m_made = nullptr;          // that of what a choice or a switch is made of
};

} // namespace fff::ui
