#include "ui/properties/turning_choices.h"

#include <QCoreApplication>

#include <algorithm>
#include <iterator>

namespace fff::ui {

namespace {

struct TurningTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::ExportRows)
};

constexpr nest::Turning kOffered[] = {nest::Turning::Free, nest::Turning::Quarter,
                                      nest::Turning::Half, nest::Turning::None};

} // namespace

Choices turningChoices(nest::Turning current)
{
    const auto *const found = std::find(std::begin(kOffered), std::end(kOffered), current);
    return {{{TurningTexts::tr("Any angle"), {}},
             {TurningTexts::tr("Quarter turns"), {}},
             {TurningTexts::tr("Half turns"), {}},
             {TurningTexts::tr("As drawn"), {}}},
            static_cast<int>(found - std::begin(kOffered))};
}

nest::Turning turningOf(int choice)
{
    return kOffered[static_cast<std::size_t>(choice)];
}

} // namespace fff::ui
