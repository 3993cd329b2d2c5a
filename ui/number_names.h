// What names stand for in the number fields of a window: the numbers of its document that have one.
#pragma once

#include <QObject> // first: moc stumbles over some standard headers

#include "core/model/document.h"
#include "ui/expression.h"

class QWidget;

namespace fff::ui {

/// A child of the window; fields find it there, also in docks that float.
class NumberNameSource : public QObject
{
public:
    NumberNameSource(NumberNames names, QObject *window)
        : QObject(window), m_names(std::move(names))
    {
    }
    const NumberNames &names() const { return m_names; }

private:
    NumberNames m_names;
};

/// Those of the window that the field is in; null: none.
NumberNames numberNamesFor(const QWidget *field);

/// The names of a document, or of those numbers alone that stand before one.
std::optional<NamedValue> namedValue(const Document &document, const QString &name,
                                     std::size_t before);
NumberNames namesBefore(const Document &document, std::size_t index);

} // namespace fff::ui
