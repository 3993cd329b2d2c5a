#include "ui/bench/number_names.h"

#include "ui/bench/workbench.h"

#include <QHash>
#include <QWidget>

#include <algorithm>

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

NumberNames namesBefore(const Document &document, std::size_t index)
{
    QHash<QString, NamedValue> known; // by the name in lower case
    const auto valueOf = [](const QHash<QString, NamedValue> &values, const QString &name) {
        const auto found = values.constFind(name.toLower());
        return found == values.cend() ? std::optional<NamedValue>() : *found;
    };
    for (std::size_t i = 0; i < std::min(index, document.numbers.size()); ++i) {
        const NamedNumber &number = document.numbers[i];
        // Whether it is a length follows from those before.
        const Expression read = readAny(QString::fromStdString(number.expression), QLocale::c(),
                                        [&](const QString &name) { return valueOf(known, name); });
        const QString name = QString::fromStdString(number.name).toLower();
        if (!known.contains(name))
            known.insert(name, {number.value, read.isLength});
    }
    return
        [known = std::move(known), valueOf](const QString &name) { return valueOf(known, name); };
}

} // namespace fff::ui
