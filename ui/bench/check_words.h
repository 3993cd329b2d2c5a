// What checks look like to a person: words, glyph, colour. For the Checks dock and the badges.
#pragma once

#include "core/analysis/mends.h"

#include <QColor>
#include <QString>

#include <array>

namespace fff::ui {

struct CheckWords
{
    QString title; // "Falls over forwards"
    QString text;  // "The centre of mass lies 45.4 mm in front of the feet."
};

/// In the unit that is set. `model` is the one that was checked.
CheckWords checkWords(const Finding &finding, const Model &model);

/// The verdict in a few words, for a badge.
QString verdictText(const Finding &finding);

/// What a link says: "Move it to Body".
QString mendText(const Mend &mend, const Finding &finding, const Model &model);

/// Name of an icon; the outlines differ, not the colours alone.
QString checkGlyph(Severity severity);
QColor checkColour(Severity severity);
/// Whether it comes before another one, in badges and rows alike: what is wrong first, then what is
/// not known, what is good, and what is only worth a remark; of the same weight by subject.
bool comesBefore(const Finding &a, const Finding &b);
/// That have a badge, in that order.
inline constexpr std::array kBadgeSubjects{Subject::Stability, Subject::Connection,
                                           Subject::Assembly,  Subject::Strength,
                                           Subject::Joints,    Subject::Size};
/// "Problem", "Warning", "Good", "Unknown": what the glyph says to those who hear it.
QString severityWord(Severity severity);

} // namespace fff::ui
