// What names stand for in the number fields of a window: the numbers of its document that have one.
#pragma once

#include <QObject> // first: moc stumbles over some standard headers

#include "core/base/expression.h"

#include <QPointer>

class QWidget;

namespace fff::ui {

class Workbench;

/// A child of the window; fields find it there, also in docks that float.
class NumberNameSource : public QObject
{
public:
    NumberNameSource(const Workbench &bench, QObject *window);
    /// Of the document as it is now.
    NumberNames names() const;

private:
    QPointer<const Workbench> m_bench; // fields may still read while the window goes
};

/// Those of the window that the field is in; null: none.
NumberNames numberNamesFor(const QWidget *field);

} // namespace fff::ui
