#include "ui/properties/driven_field.h"

#include "core/interaction/value_editing.h"
#include "core/model/origin.h"
#include "core/values/number_text.h"
#include "ui/base/expression_text.h"
#include "ui/base/lengths.h"
#include "ui/bench/measures.h"
#include "ui/bench/workbench.h"

#include <QCoreApplication>
#include <QLocale>

namespace fff::ui {

namespace {

struct DrivenFieldTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::DrivenField)
};

const Document &shownDocument(const Workbench &bench)
{
    return bench.session().model().document;
}

const Document &committedDocument(const Workbench &bench)
{
    return bench.session().committed().document;
}

} // namespace

Reading windowReading(const QLocale &locale)
{
    Reading reading;
    reading.lengthUnit = millimetresPer(settings().unit());
    reading.commas = commasOf(locale);
    return reading;
}

QStringList valueNames(const Workbench &bench)
{
    QStringList names;
    for (const ValuePointer &known : shownDocument(bench).values.list)
        names += QString::fromStdString(known->value.name);
    return names;
}

QString tryEdit(Workbench &bench, SectionEdit edit)
{
    if (!edit)
        return messageText(edit.error().words, unitsInUse());
    bench.editSections(std::move(edit));
    return {};
}

PlaceNow selectedSectionPlace(const Workbench &bench, DrivenPlace::Of of, const char *field,
                              int index)
{
    return [&bench, of, field = std::string(field), index]() -> std::optional<DrivenPlace> {
        const std::vector<SectionRef> &selected = bench.interaction().selection();
        const std::optional<Origin> origin =
            selected.size() == 1 ? originOf(bench.session().model(), selected.front())
                                 : std::nullopt;
        if (!origin)
            return std::nullopt;
        return DrivenPlace{
            .of = of, .id = origin->section->id.value, .index = index, .field = field};
    };
}

Followed followedAt(Workbench &bench, PlaceNow place, Prepared prepared)
{
    return {[&bench, place]() -> QString {
                const std::optional<DrivenPlace> at = place();
                const Binding *binding = at ? bindingOf(shownDocument(bench), *at) : nullptr;
                return binding ? QString::fromStdString(binding->typed) : QString();
            },
            [&bench, place, prepared](const QString &text) -> QString {
                const std::optional<DrivenPlace> at = place();
                if (!at)
                    return DrivenFieldTexts::tr("Only one number at a time can follow a value.");
                const Result<Document> document = prepared
                                                      ? prepared(committedDocument(bench))
                                                      : Result<Document>(committedDocument(bench));
                if (!document)
                    return DrivenFieldTexts::tr("This number cannot follow a value.");
                return tryEdit(bench, numberBound(*document, *at, text.toStdString(),
                                                  windowReading(QLocale())));
            },
            [&bench, place] {
                if (const std::optional<DrivenPlace> at = place())
                    bench.editSections(numberReleased(committedDocument(bench), *at));
            },
            [&bench] { return valueNames(bench); }};
}

Followed followedBy(Workbench &bench, ValueId value)
{
    const auto type = [&bench, value](std::string text) -> QString {
        const Value *known = committedDocument(bench).values.find(value);
        if (!known)
            return {};
        Value next = *known;
        next.typed = std::move(text);
        next.reading = windowReading(QLocale());
        return tryEdit(bench, valueChanged(committedDocument(bench), std::move(next)));
    };
    return {[&bench, value]() -> QString {
                const Values &values = shownDocument(bench).values;
                const int index = values.indexOf(value);
                if (index < 0)
                    return {};
                const KnownValue &known = *values.list[static_cast<std::size_t>(index)];
                const bool isMade = !known.typed || !known.typed->isConstant();
                return isMade ? QString::fromStdString(known.value.typed) : QString();
            },
            [type](const QString &text) { return type(text.toStdString()); },
            [&bench, value, type] {
                const Value *known = committedDocument(bench).values.find(value);
                const Worth *worth = bench.session().committed().evaluation.values.worth(value);
                if (known && worth)
                    type(exactText(*worth, known->kind));
            },
            [&bench] { return valueNames(bench); }};
}

} // namespace fff::ui
