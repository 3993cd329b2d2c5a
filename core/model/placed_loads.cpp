#include "core/model/placed_loads.h"

#include "core/geometry/polygon.h"

#include <Eigen/LU>

#include <algorithm>
#include <map>
#include <tuple>

namespace fff {

namespace {

/// From the frame of what a section is a copy of to its own.
struct Way
{
    Eigen::Matrix2d matrix = Eigen::Matrix2d::Identity();
    Vec2 shift = Vec2::Zero();
    bool isMirrored = false;

    Vec2 operator()(const Vec2 &p) const { return matrix * p + shift; }
    /// The same from one step before.
    void goOnFrom(const CopyOf &copy)
    {
        shift += matrix * copy.shift;
        matrix = matrix * copy.matrix;
        isMirrored = isMirrored != copy.isMirrored;
    }
};

/// visit(what it is a copy of, way), the nearest first.
template <class Visit>
void forEachSource(const Section &section, const Visit &visit)
{
    Way way;
    for (const CopyOf *copy = section.copyOf ? &*section.copyOf : nullptr; copy;
         copy = copy->before.get()) {
        way.goOnFrom(*copy);
        visit(copy->section, way);
    }
}

/// A push keeps its direction on the copy, and its force.
Vec3 pushBy(const Way &way, const Vec3 &push)
{
    Vec2 inPlane = way.matrix * push.head<2>();
    if (const double size = inPlane.norm(); size > 0.0)
        inPlane *= push.head<2>().norm() / size;
    return {inPlane.x(), inPlane.y(), way.isMirrored ? -push.z() : push.z()};
}

/// What is on a section and goes along to its copies.
using Sources = std::map<SectionRef, std::vector<int>>;

Sources sourcesOf(const std::vector<Load> &loads)
{
    Sources of;
    for (std::size_t i = 0; i < loads.size(); ++i)
        if (loads[i].isRepeated)
            of[loads[i].section].push_back(static_cast<int>(i));
    return of;
}

/// visit(load, position, push): those of its sources where it has material.
template <class Visit>
void forEachCarried(const std::vector<Load> &loads, const Sources &of, const Section &copy,
                    const Visit &visit)
{
    forEachSource(copy, [&](const SectionRef &source, const Way &way) {
        const auto found = of.find(source);
        if (found == of.end())
            return;
        for (const int i : found->second) {
            const Load &load = loads[static_cast<std::size_t>(i)];
            const Vec2 position = way(load.position);
            if (locate(position, copy.shape->region()) != Side::Outside)
                visit(i, position, pushBy(way, load.push));
        }
    });
}

} // namespace

std::vector<PlacedLoad> placedLoads(const Model &model)
{
    const std::vector<Load> &loads = model.document.loads;
    std::vector<PlacedLoad> placed;
    if (loads.empty())
        return placed;
    for (std::size_t i = 0; i < loads.size(); ++i)
        if (const int section = model.indexOf(loads[i].section); section >= 0)
            placed.push_back(
                {static_cast<int>(i), section, loads[i].position, loads[i].push, false});
    const Sources of = sourcesOf(loads);
    for (std::size_t s = model.drawnCount(); s < model.sectionCount(); ++s)
        forEachCarried(loads, of, *model.section(s),
                       [&](int load, const Vec2 &position, const Vec3 &push) {
                           placed.push_back({load, static_cast<int>(s), position, push, true});
                       });
    std::sort(placed.begin(), placed.end(), [](const PlacedLoad &a, const PlacedLoad &b) {
        return std::tie(a.load, a.section) < std::tie(b.load, b.section);
    });
    return placed;
}

int copiesCarrying(const Model &model, const Load &load)
{
    int count = 0;
    const std::vector<Load> one{load};
    const Sources of = sourcesOf(one);
    for (std::size_t s = model.drawnCount(); s < model.sectionCount(); ++s)
        forEachCarried(one, of, *model.section(s),
                       [&count](int, const Vec2 &, const Vec3 &) { ++count; });
    return count;
}

std::vector<Load> carriedLoads(const Document &document, const Section &copy)
{
    std::vector<Load> carried;
    forEachCarried(document.loads, sourcesOf(document.loads), copy,
                   [&](int load, const Vec2 &position, const Vec3 &push) {
                       carried.push_back(document.loads[static_cast<std::size_t>(load)]);
                       carried.back().section = copy.ref();
                       carried.back().position = position;
                       carried.back().push = push;
                   });
    return carried;
}

std::optional<Load> asOnCopy(const Model &model, const Load &load, const SectionRef &on,
                             const Vec2 &position, const Vec3 &push)
{
    std::optional<Load> source;
    const auto become = [&](const Vec2 &at, const Vec3 &by) {
        source = load;
        source->position = at;
        source->push = by;
    };
    if (on == load.section) {
        become(position, push);
        return source;
    }
    if (const Section *copy = model.find(on))
        forEachSource(*copy, [&](const SectionRef &ref, const Way &way) {
            if (!(ref == load.section) || source || way.matrix.determinant() == 0.0)
                return;
            const Eigen::Matrix2d back = way.matrix.inverse();
            become(back * (position - way.shift), pushBy({back, {}, way.isMirrored}, push));
        });
    return source;
}

} // namespace fff
