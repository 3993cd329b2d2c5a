// Sizes and masses of the model that is shown, for people: with its slits cut where the newest
// analysis knows them, and in the words of the locale.
#pragma once

#include "core/session/session.h"

#include <QLocale>

#include <unordered_map>

namespace fff::ui {

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
    const Model &m_model;
    std::unordered_map<const Section *, CutSectionPointer> m_cuts;
};

/// With at least and at most so many digits: "3.0", "3.175". A real minus sign.
QString numberText(double value, int least, int most, const QLocale &locale);
QString massText(double kilograms, const QLocale &locale);         // "78 g", "1.25 kg"
QString areaText(double squareMillimetres, const QLocale &locale); // "54.2 cm²"
/// "84.0 × 84.4 mm"
QString sizeText(std::initializer_list<double> millimetres, int decimals, const QLocale &locale);

} // namespace fff::ui
