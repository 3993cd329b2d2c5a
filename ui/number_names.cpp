#include "ui/number_names.h"

#include <QWidget>

#include <algorithm>

namespace fff::ui {

NumberNames numberNamesFor(const QWidget *field)
{
    for (const QWidget *widget = field; widget; widget = widget->parentWidget())
        for (const QObject *child : widget->children())
            if (const auto *source = dynamic_cast<const NumberNameSource *>(child))
                return source->names();
    return {};
}

std::optional<NamedValue> namedValue(const Document &document, const QString &name,
                                     std::size_t before)
{
    for (std::size_t i = 0; i < std::min(before, document.numbers.size()); ++i) {
        const NamedNumber &number = document.numbers[i];
        if (name.compare(QString::fromStdString(number.name), Qt::CaseInsensitive) != 0)
            continue;
        const Expression read = readAny(QString::fromStdString(number.expression), QLocale::c(),
                                        namesBefore(document, i));
        return NamedValue{number.value, read.isLength};
    }
    return std::nullopt;
}

NumberNames namesBefore(const Document &document, std::size_t index)
{
    return [&document, index](const QString &name) { return namedValue(document, name, index); };
}

} // namespace fff::ui
