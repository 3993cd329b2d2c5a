#include "ui/bench/measures.h"

#include "core/fabrication/summary.h"

#include <QCoreApplication>
#include <QStringList>

namespace fff::ui {

namespace {

struct MeasureText
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::MeasureText)
};

} // namespace

Measures::Measures(const Session &session)
    : m_model(session.model()), m_analysis(session.analysis())
{
}

/// The cut of just this section, or null while none is known. Mostly it stands where it stood.
const CutSection *Measures::cutOf(int section) const
{
    const auto index = static_cast<std::size_t>(section);
    const Model &known = m_analysis.model;
    int at = section;
    if (index >= known.sectionCount() || known.section(index) != m_model.section(index))
        at = known.indexOf(m_model.ref(index));
    const auto there = static_cast<std::size_t>(at);
    return at >= 0 && there < m_analysis.cuts.size() &&
                   known.section(there) == m_model.section(index)
               ? m_analysis.cuts[there].get()
               : nullptr;
}

double Measures::area(int section) const
{
    const CutSection *cut = cutOf(section);
    return cut ? cut->area() : m_model.section(static_cast<std::size_t>(section))->shape->area();
}

double Measures::mass(int section) const
{
    constexpr double kCubicMetresPerCubicMillimetre = 1e-9;
    const Stock &stock = m_model.stockOf(static_cast<std::size_t>(section));
    return area(section) * stock.thickness * stock.density * kCubicMetresPerCubicMillimetre;
}

double Measures::mass() const
{
    double sum = 0.0;
    for (std::size_t i = 0; i < m_model.sectionCount(); ++i)
        sum += mass(static_cast<int>(i));
    return sum;
}

Vec3 Measures::size() const
{
    const Box3 box = slabBounds(m_model);
    return box.isEmpty() ? Vec3::Zero() : box.size();
}

Vec2 Measures::contourSize(int section) const
{
    return m_model.section(static_cast<std::size_t>(section))->shape->bounds().size();
}

QString massText(double kilograms, const QLocale &locale)
{
    const double grams = kilograms * 1000.0;
    if (grams >= 1000.0)
        return MeasureText::tr("%1\u202fkg").arg(locale.toString(kilograms, 'f', 2));
    return MeasureText::tr("%1\u202fg").arg(locale.toString(grams, 'f', grams < 10.0 ? 1 : 0));
}

QString areaText(double squareMillimetres, const QLocale &locale)
{
    if (settings().unit() == LengthUnit::Inch) {
        const double inch = millimetresPer(LengthUnit::Inch);
        return MeasureText::tr("%1\u202fin²")
            .arg(locale.toString(squareMillimetres / (inch * inch), 'f', 2));
    }
    return MeasureText::tr("%1\u202f"
                           "cm²")
        .arg(locale.toString(squareMillimetres / 100.0, 'f', 1));
}

QString sizeText(std::initializer_list<double> millimetres, int digits, const QLocale &locale)
{
    QStringList numbers;
    for (double length : millimetres)
        numbers += lengthNumber(length, digits, digits, locale);
    return QStringLiteral("%1\u202f%2")
        .arg(numbers.join(QStringLiteral(" × ")), unitSign(settings().unit()));
}

UnitWords unitsInUse()
{
    const QLocale locale;
    UnitWords units = metricUnits();
    units.length = [locale](double mm) { return lengthText(mm, 0, 1, locale); };
    units.width = [locale](double mm) { return lengthText(mm, 2, 3, locale); };
    units.size = [locale](const Vec2 &mm) { return sizeText({mm.x(), mm.y()}, 0, locale); };
    units.mass = [locale](double kg) { return massText(kg, locale); };
    return units;
}

} // namespace fff::ui
