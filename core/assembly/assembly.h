// From a model to its joints and slits.
#pragma once

#include "core/assembly/joint.h"

#include <memory>

namespace fff {

/// Keeps crossings by both (Shape, Frame) pairs, so that an edit of one section computes those of
/// that section only and undo computes none. Holds shapes weakly; bounded (least recently used goes
/// first). Not for several threads at once.
class CrossingCache
{
public:
    CrossingCache();
    ~CrossingCache();
    CrossingCache(CrossingCache &&) noexcept;
    CrossingCache &operator=(CrossingCache &&) noexcept;

    struct Data;
    Data &data() { return *m_data; }

private:
    std::unique_ptr<Data> m_data;
};

/// All joints and slits of the model. Deterministic: the same model gives the same result with any
/// cache. Cost: a sweep over all boxes, plus the crossings that the cache does not hold.
Assembly assemble(const Model &model, CrossingCache &cache);

/// Groups of sections that joints hold together, as indices into the model; the largest group
/// first, then by their first section. A section without joints is a group of its own.
std::vector<std::vector<int>> connectedGroups(std::size_t sectionCount,
                                              const std::vector<Joint> &joints);

} // namespace fff
