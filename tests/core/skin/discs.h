// Sections for skins: discs of one sphere and the like.
#pragma once

#include "core/model/section.h"
#include "tests/core/shapes.h"

namespace fff::test {

inline SectionPointer sectionOf(const Contour &contour, const Vec3 &origin, const Vec3 &x,
                                const Vec3 &y, std::vector<Contour> holes = {})
{
    auto section = std::make_shared<Section>();
    section->shape = Shape::make(contour, std::move(holes)).value();
    section->frame = makeFrame(origin, x, y).value();
    return section;
}

/// Of the sphere about the origin, so far from it along the normal.
inline SectionPointer disc(double radius, const Vec3 &normal, double height)
{
    const Vec3 n = normal.normalized(), x = n.unitOrthogonal();
    return sectionOf(circle({0.0, 0.0}, std::sqrt(radius * radius - height * height)), height * n,
                     x, n.cross(x));
}

/// As many planes along each of the three axes as heights are given.
inline std::vector<SectionPointer> sphere(double radius, const std::vector<double> &along)
{
    std::vector<SectionPointer> discs;
    for (const Vec3 &normal : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())})
        for (const double height : along)
            discs.push_back(disc(radius, normal, height * radius));
    return discs;
}

inline std::vector<SectionPointer> moved(const std::vector<SectionPointer> &sections,
                                         const Eigen::Isometry3d &motion)
{
    std::vector<SectionPointer> all;
    for (const SectionPointer &section : sections) {
        auto copy = std::make_shared<Section>(*section);
        copy->frame = {motion * section->frame.origin, motion.linear() * section->frame.x,
                       motion.linear() * section->frame.y};
        all.push_back(std::move(copy));
    }
    return all;
}

} // namespace fff::test
