// What may lie between the truth of a reference case and ours: read from the index of its folder,
// its own file, and, where both are silent, what the issue of physics says of all.
#pragma once

#include "tests/core/physics/reference_case.h"

#include <QDir>

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace fff::test {

/// Ours / truth − 1 has to be in there.
struct Band
{
    double low = -0.05, high = 0.05;

    bool operator==(const Band &) const = default;
};

/// Of one named cut.
struct CutRule
{
    std::optional<Band> beam, plate; // none: that of all
    bool isTold = false;             // "informational": shown, not judged
};

struct Tolerances
{
    double mass = 1e-3;     // share
    double centre = 0.1;    // mm
    double reaction = 1e-3; // share of the largest, of determinate structures
    double wrench = 1e-3;   // "
    double resultant = 0.5; // mm; margins too
    double equilibrium = 1e-9;
    /// Where nothing is named, beams may be as careful as they like, but not bolder.
    Band beam{-0.05, std::numeric_limits<double>::infinity()};
    bool isBeamTold = false;             // beams need not know any of it
    double plate = 0.05;                 // share, of the accurate mode
    double elastic = 0.05;               // share of the largest foot, of sections that bend
    std::optional<double> elasticNewton; // N, of every foot; then `elastic` is of the largest alone
    bool isElasticNamed = false;         // it says something of them
    bool isElasticOfContact = false;     // it says which truth: of slits without play,
    bool isElasticOfPlay = false;        // of those with it
    bool isDeterminate = false, isIndeterminate = false; // the index says so
    bool isSymmetric = false; // however many feet there are, loads are shared in one way
    std::map<std::string, CutRule> cuts;
    /// The largest stress of a cut, and within which share of it.
    std::optional<double> peak;
    double peakShare = 0.1;
    /// Beam statics by the solver's own resultants over its stress, where that is known.
    std::map<std::string, double> statics;
    std::vector<std::string> unknown; // keys that nobody here knows: told, not judged

    Band beamOf(const std::string &cut) const;
    Band plateOf(const std::string &cut) const;
    bool isTold(const std::string &cut) const;
};

class ReferenceIndex
{
public:
    /// No index is none: all is judged by what its file and the defaults say.
    explicit ReferenceIndex(const QDir &folder);

    /// Keys that are numbers count as such; texts are read as people wrote them: clauses between
    /// semicolons with "[-10%,+30%]", "5%", "within 0.25 N", "peak 3.32", "informational", of the
    /// cuts that they name (by the name or its first word), else of all.
    Tolerances of(const ReferenceCase &found) const;

private:
    QJsonObject m_entries; // by the ids of their cases
};

} // namespace fff::test
