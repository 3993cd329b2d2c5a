// Slits that the mill's tool does not go into, that the kerf closes, that are too tight or too
// wide.
#pragma once

#include "core/analysis/finder.h"
#include "core/assembly/slits.h"

namespace fff {

/// How wide a slit is at its narrowest, mm: between its bumps, or a short closed one along itself.
double narrowest(const Slit &slit);

/// Calls visit(width, place) for each slit of a section, and for each gap between tabs or fingers
/// that follow each other: mm, and a point in the section's plane.
template <class Visit>
void visitOpenings(const std::vector<Slit> &slits, Visit visit)
{
    for (std::size_t i = 0; i < slits.size(); ++i) {
        const Slit &slit = slits[i];
        if (slit.role == SlitRole::Slit)
            visit(narrowest(slit), slit.inner);
        if (i == 0 || slit.role != SlitRole::Tab || slits[i - 1].role != SlitRole::Tab ||
            slits[i - 1].joint != slit.joint || slits[i - 1].overlap != slit.overlap)
            continue;
        const Vec2 apart = slit.inner - slits[i - 1].inner;
        visit(apart.norm() - 0.5 * (slit.width + slits[i - 1].width),
              Vec2(slit.inner - 0.5 * apart));
    }
}

/// Whether nothing stays of a slit of this width, mm, when the path runs half the kerf inside it. A
/// path of less than a micron is none.
bool isClosedBy(double kerf, double width);

/// Of kNarrowSlit, mm.
struct NarrowSlit
{
    double width = 0.0;
    double tool = 0.0;     // its diameter, or the kerf
    bool isClosed = false; // by the kerf: there is no slit
};
/// Of kTightSlits, mm.
struct TightSlits
{
    double by = 0.0;    // narrower than what goes into them
    double bumps = 0.0; // height of one; 0: there are none
};

/// What is narrower by more than this, mm, presses harder than any material gives; a positive
/// one of more than that leaves what is in a slit to rattle and lean.
inline constexpr double kTightest = 0.3, kWidest = 0.5;

extern const FindingKind kTightSlits, kWideSlits; // of a stock
extern const FindingKind kNarrowSlit;
extern const ActionKind kWidenSlits; // of the stock of its sections

/// One a stock, in their order, about the sections that have such slits, at the narrowest: of those
/// that its kerf closes, or else, where its slits end round, of those that are narrower than its
/// tool; or else of all that are too tight.
void findNarrowSlits(const Looked &at, std::vector<Finding> &found);

} // namespace fff
