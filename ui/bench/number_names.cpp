#include "ui/bench/number_names.h"

#include "core/model/named_numbers.h"
#include "ui/bench/workbench.h"

#include <QWidget>

namespace fff::ui {

NumberNameSource::NumberNameSource(const Workbench &bench, QObject *window)
    : QObject(window), m_bench(&bench)
{
}

NumberNames NumberNameSource::names() const
{
    if (!m_bench)
        return {};
    const Document &document = m_bench->session().committed().document;
    return namesBefore(document, document.numbers.size());
}

NumberNames numberNamesFor(const QWidget *field)
{
    for (const QWidget *widget = field; widget; widget = widget->parentWidget())
        for (const QObject *child : widget->children())
            if (const auto *source = dynamic_cast<const NumberNameSource *>(child))
                return source->names();
    return {};
}

} // namespace fff::ui
