// Models for laws of strength: samples, those that are shared, and random drawings, all of them
// drawn (nothing is generated) and with something on them.
#pragma once

#include "core/analysis/strength.h"
#include "core/model/document.h"

#include <QString>

#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace fff::test {

/// Made anew with every call, the same each time. Empty for a name that is not there.
Document lawModel(const QString &name);
/// Samples and shared models by their files' names, then so many "drawing N" and
/// "crate N".
std::vector<QString> lawModels(int drawings, int crates);

/// Where a neck is and what it says of itself, for a person who looks for the reason.
QString told(const std::optional<NeckStress> &neck);

/// Of a section's bodies the worst.
struct SectionUse
{
    double neck = 0.0, corner = 0.0;
    QString neckTold, cornerTold;
};

/// A model's answer, as laws compare it.
struct StrengthAnswer
{
    HoldVerdict verdict = HoldVerdict::NotWorkedOut;
    Balance balance = Balance::NoContact;
    int indeterminacy = 0;
    double neckUse = 0.0, cornerUse = 0.0;
    std::map<std::int64_t, SectionUse> uses; // by section
    std::vector<std::pair<Vec3, Vec3>> feet; // where and what, of the first solution
    double weight = 0.0;                     // N that the ground has to carry
};

StrengthAnswer answerOf(const Analysis &analysis, const Strength &strength);
StrengthAnswer answerOf(const Document &document, const StrengthRules &rules = {});

/// How far two answers may be apart.
struct LawBound
{
    double share = 0.0; // of the larger use, of the weight for what feet carry
    double least = 0.2; // a use that is smaller is taken for this: below, nothing is coloured
    double feet = 0.01; // mm between them
    bool isSame = true; // the same feet: else those of a model that meets the ground elsewhere
};

using MapOfVectors = std::function<Vec3(const Vec3 &)>;

/// A sentence that says what is not the same; empty when all is. Verdicts are compared where no use
/// is that near to where they change, feet where it stands. place, force: from those of feet of the
/// first to those of the second.
QString differenceOf(const StrengthAnswer &first, const StrengthAnswer &second,
                     const LawBound &bound, const MapOfVectors &place = {},
                     const MapOfVectors &force = {});

} // namespace fff::test
