#include "ui/measures.h"

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

Measures::Measures(const Session &session) : m_model(session.model())
{
    const Analysis &analysis = session.analysis();
    const std::size_t count = std::min(analysis.model.sectionCount(), analysis.cuts.size());
    for (std::size_t i = 0; i < count; ++i)
        m_cuts[analysis.model.section(i).get()] = analysis.cuts[i];
}

double Measures::area(int section) const
{
    const SectionPointer &pointer = m_model.section(static_cast<std::size_t>(section));
    const auto known = m_cuts.find(pointer.get());
    return known != m_cuts.end() && known->second ? known->second->area() : pointer->shape->area();
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

} // namespace fff::ui
