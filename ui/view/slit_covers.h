// Which walls of a section's slits nobody can see, because the slab that the slit is for fills
// them.
#pragma once

#include "core/analysis/analysis.h"

#include <vector>

namespace fff::ui {

/// A stretch of a slit that its guest fills from wall to wall, over the host's whole thickness:
/// both side walls along it and the wall at its inner end are hidden. Frame coordinates of the
/// host, mm.
struct SlitCover
{
    Vec2 inner = Vec2::Zero();      // middle of the slit's inner end
    Vec2 direction = Vec2::UnitX(); // unit, from there to the mouth
    double halfWidth = 0.0;
    double length = 0.0; // of the stretch, from the inner end; in steps of kCoverStep

    bool operator==(const SlitCover &other) const
    {
        return inner == other.inner && direction == other.direction &&
               halfWidth == other.halfWidth && length == other.length;
    }
};

/// So that sections that look alike have equal covers in spite of rounding, and of an oblique edge
/// of what they stand on; what is not covered of it is too short to be seen. mm.
inline constexpr double kCoverStep = 5e-3;

struct SectionCovers
{
    std::vector<SlitCover> covers;
    std::vector<int> guests; // of each: index in the model of the analysis
};

/// The covers of one section of the analysis, in the order of its slits. A slit that its guest does
/// not touch (at an angle, with play) has none.
SectionCovers slitCovers(const Analysis &analysis, std::size_t section);

/// The same, made from those of an earlier analysis: only covers of slits that differ are looked
/// for, and where the guest differs near them.
class CoverUpdate
{
public:
    /// Both models have the same sections at the same indices; both analyses outlive it.
    CoverUpdate(const Analysis &now, const Analysis &before);
    ~CoverUpdate();

    /// Whether nothing of the section, nor of what fills its slits, is other than it was: then its
    /// covers are the same.
    bool isKept(std::size_t section) const;
    /// known, guests: the covers of the section before and whom they are for.
    SectionCovers of(std::size_t section, const std::vector<SlitCover> &known,
                     const std::vector<int> &guests) const;

private:
    struct Change;

    const Analysis &m_now, &m_before;
    std::vector<Change> m_changes; // of each section
};

} // namespace fff::ui
