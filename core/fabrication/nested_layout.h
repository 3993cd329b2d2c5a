// Parts on sheets by their true outlines: closer together than their boxes would be.
#pragma once

#include "core/base/long_work.h"
#include "core/fabrication/layout.h"
#include "core/nesting/problem.h"

namespace fff {

/// A part that lies where a person, or an earlier layout, has put it.
struct PinnedPart
{
    int part = 0;              // index into the parts
    int sheet = 0;             // as Sheet::index: of its stock
    Vec2 turn = Vec2::UnitX(); // as a Placement's
    Vec2 offset = Vec2::Zero();
    bool yields = false; // to those that do not, where both cannot stay

    bool operator==(const PinnedPart &) const = default;
};

struct NestOptions
{
    LayoutOptions layout; // `turnsFreely` is not looked at:
    nest::Turning turning = nest::Turning::Free;
    std::vector<nest::Turning> turnings; // of each part, where there is one, in place of that
    bool fillsHoles = true;              // parts may lie in holes of others
    std::vector<PinnedPart> pinned;      // the others lie around them
    /// Of all parts that are not pinned: where they lay while they, or the spacing, were a little
    /// different. To begin with, where that is no worse (nest::nestPieces()).
    std::vector<PinnedPart> before;

    std::uint64_t seed = 1;
    std::int64_t work = 0; // for all stocks together, see nest::Options
    bool usesThreads = true;

    bool operator==(const NestOptions &) const = default;
};

struct NestedLayout
{
    Layout layout;
    std::int64_t work = 0; // that was done
    std::vector<int>
        loosened; // pinned parts that could not stay: too near to others, off the sheet
};

/// As layOut(), for the same sheets with the same margin and spacing; before them come the stock's
/// offcuts and sheets of other sizes, as many as there are. Holes and bays of parts are room, too.
/// Each stock by itself, with a share of the work that goes by its number of parts. What fits no
/// sheet as it may be turned is oversized. Never more sheets than layOut() takes, where its turns
/// are allowed, all sheets are whole ones and nothing is pinned.
///
/// A pinned part stays to the last bit, at any angle, as long as it is sound there; holes of it are
/// no room then. Of two that are too near to each other the later one is laid with the rest, or
/// that which yields.
///
/// Deterministic for the same parts, options and seed unless it is stopped; then what is best so
/// far is given out. Proven before: outlines are off the edge by the margin, and off each other by
/// the spacing (nesting/proof.h).
NestedLayout nestOut(const std::vector<Part> &parts, const Model &model, const NestOptions &options,
                     const LongWork &longWork = {});

/// How high each sheet is taken, mm: all of it, but of each stock's last one, if it is rectangular,
/// only as high as parts lie there, with the margin: the rest is whole. 0 of oversized parts.
std::vector<double> takenHeights(const Layout &layout, const std::vector<Part> &parts,
                                 const LayoutOptions &options);
/// What a layout takes of its sheets so, mm². The less of it, the better: first of whole sheets,
/// since offcuts are there to be used up.
struct TakenArea
{
    double wholes = 0.0, offcuts = 0.0;

    auto operator<=>(const TakenArea &) const = default;
};
TakenArea takenArea(const Layout &layout, const std::vector<Part> &parts,
                    const LayoutOptions &options);
/// How much of that parts cover, 0 … 1; 0 without sheets.
double filledShare(const Layout &layout, const std::vector<Part> &parts,
                   const LayoutOptions &options);

} // namespace fff
