// Which links carry what statics alone tells, from others or from nothing at all.
#pragma once

#include "core/physics/plate_attachment.h"
#include "core/physics/structure.h"

#include <vector>

namespace fff {

/// Links in a row share one unknown wrench: between two of them is a member that nothing else
/// holds.
struct LinkChains
{
    /// The wrench on a link's a, about its point: `side` times that of its chain, moved to there,
    /// and what comes besides.
    struct Link
    {
        int chain = -1;    // −1: there is nothing unknown about it
        double side = 0.0; // 1 or −1; 0 without a chain
        WrenchVector rest = WrenchVector::Zero();
    };

    std::vector<Link> links;
    std::vector<Vec3> points;     // of each chain, what its wrench is about
    std::vector<bool> isBalanced; // of each member: it is in equilibrium whatever the chains carry
    std::vector<WrenchVector> rest; // of each member, about its centroid: weight, loads, and what
                                    // its links carry besides the chains
};

/// A force and a moment about one point, about another.
WrenchVector movedTo(const Vec3 &to, const Vec3 &from, const WrenchVector &wrench);

/// Members that hang on one link, and what hangs on these, tell what that link carries; what is
/// left and held by two links, all of the second that the first carries.
LinkChains linkChains(const Structure &structure);

} // namespace fff
