// Models that something is wrong with, a kind for each link that mends.
#pragma once

#include "core/analysis/finding_action.h"

#include <cstdint>
#include <span>

namespace fff::test {

struct BrokenKind
{
    const char *name; // of the link, and of what is wrong
    const ActionKind *link;
    const FindingKind *finding;           // under which it is to be offered
    Document (*make)(std::uint64_t seed); // all of it from the seed
};

/// Each link, under each kind of finding that is a case of its own.
std::span<const BrokenKind> brokenKinds();

// What of them is in other files, by kind.
Document pulledModel(std::uint64_t seed);
Document overloadedBench(std::uint64_t seed);
Document overloadedNeck(std::uint64_t seed);
Document overloadedSlit(std::uint64_t seed);
Document brokenSlit(std::uint64_t seed);
Document pushedAlong(std::uint64_t seed);
Document pushedAcross(std::uint64_t seed);
Document leaningModel(std::uint64_t seed);
Document topplingModel(std::uint64_t seed);
Document unsteadyModel(std::uint64_t seed);
Document onShortLegs(std::uint64_t seed);
Document offTheGround(std::uint64_t seed);

} // namespace fff::test
