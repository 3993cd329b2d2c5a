// Sizes and masses of the model that is shown, for people: with its slits cut where the newest
// analysis knows them, and in the words of the locale.
#pragma once

#include "core/session/message_text.h"
#include "core/session/session.h"
#include "ui/base/lengths.h"

#include <QLocale>

namespace fff::ui {

/// To be asked at once: refers to the session's model and analysis.
class Measures
{
public:
    explicit Measures(const Session &session);

    double area(int section) const;      // mm²
    double mass(int section) const;      // kg
    double mass() const;                 // of all sections, kg
    Vec3 size() const;                   // of all slabs, mm; zero without sections
    Vec2 contourSize(int section) const; // mm, along the frame's axes

private:
    const CutSection *cutOf(int section) const;

    const Model &m_model;
    const Analysis &m_analysis;
};

QString massText(double kilograms, const QLocale &locale);         // "78 g", "1.25 kg"
QString areaText(double squareMillimetres, const QLocale &locale); // "54.2 cm²", "8.40 in²"
/// "84.0 × 84.4 mm", in the unit that is set; the digits are those for millimetres.
QString sizeText(std::initializer_list<double> millimetres, int digits, const QLocale &locale);

/// How sentences say lengths and masses: in the unit that is set.
UnitWords unitsInUse();

} // namespace fff::ui
