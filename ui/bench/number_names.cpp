#include "ui/bench/number_names.h"

#include "core/base/letters.h"
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
    return [numbers = namesBefore(document, document.numbers.size()),
            values = m_bench->session().committed().evaluation.values.names()](
               std::string_view name) -> std::optional<NamedValue> {
        const Worth *worth = values(foldedName(name));
        const bool isLength = worth && worth->powers == kLengthPowers;
        if (worth && worth->type == Worth::Type::Number && (isLength || worth->powers.isNone()))
            return NamedValue{worth->number, isLength};
        return numbers(name);
    };
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
