// Balances a model and strains its bodies, under so much of what hangs on it.
#pragma once

#include "core/analysis/strength.h"

#include <span>

namespace fff {

/// Of each body, whether its forces are known: it is in equilibrium, whether or not all the rest
/// is.
std::vector<char> bodiesWithForces(const Equilibrium &equilibrium, std::size_t bodies);

/// What holds a model up under these loads: feet need no friction unless something pushes sideways.
Support supportOf(const Structure &loaded, const StrengthRules &rules);

/// A structure, the solutions that count, and the bodies' stresses under them.
class Straining
{
public:
    Straining(const Analysis &analysis, const StrengthRules &rules, StrengthCaches &caches,
              const LongWork &work = {})
        : m_analysis(analysis), m_rules(rules), m_caches(caches), m_work(work)
    {
    }

    bool isStopped() const { return m_work.isStopped(); }

    /// Its forces under its own weight and so much of the loads.
    void balance(double scale, Strength &strength) const;
    /// The stresses of all bodies under these forces.
    void stress(double scale, Strength &strength) const;
    /// Of these bodies alone, without the lines that are shown; the others' are left as they are.
    void stress(double scale, std::span<const int> bodies, Strength &strength) const;
    /// Of those that are strained nearly as much as the worst; of the others what the grid says.
    void stressOfWorst(double scale, Strength &strength) const;

private:
    void bend(double scale, const Structure &loaded, Strength &strength) const;
    const Stock &stockOf(int body) const;
    std::shared_ptr<const SectionCuts> cutsOf(int body) const;
    const CutShares &sharesOf(int body, const std::shared_ptr<const SectionCuts> &cuts,
                              const std::vector<AppliedForce> &forces, double thickness) const;
    SheetMaterial sheetOf(int body, const Structure &structure) const;
    enum class Detail { Grid, Refined, WithLines };
    /// Lists of necks that are used again, one for each case: a body more costs no memory.
    using Rooms = std::vector<std::vector<NeckStress>>;
    void lookForNecks(int index, BodyStrength &body) const;
    void strain(int index, const std::vector<const std::vector<AppliedForce> *> &cases,
                const Structure &structure, Detail detail, Rooms &rooms, BodyStrength &body) const;
    void strain(double scale, std::span<const int> bodies, Detail detail, Strength &strength) const;

    const Analysis &m_analysis;
    const StrengthRules &m_rules;
    StrengthCaches &m_caches;
    LongWork m_work;
};

} // namespace fff
