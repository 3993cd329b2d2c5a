#include "tests/tools/samples/contours.h"
#include "tests/tools/samples/maker.h"
#include "tests/tools/samples/samples.h"

#include "core/geometry/arc_length.h"
#include "core/geometry/contour_points.h"

namespace fff::samples {

namespace {

/// From the nose along the back to the tail and back under it; counter-clockwise the other way.
Contour spine()
{
    return flowing({{{-150, 166}}, {{-140, 177}}, {{-124, 180}}, {{-110, 172}},     {{-100, 154}},
                    {{-86, 134}},  {{-66, 121}},  {{-40, 120}},  {{0, 127}},        {{34, 122}},
                    {{62, 107}},   {{92, 86}},    {{122, 70}},   {{150, 66}, true}, {{122, 60}},
                    {{90, 72}},    {{60, 87}},    {{34, 97}},    {{0, 98.5}},       {{-40, 96}},
                    {{-70, 101}},  {{-96, 120}},  {{-114, 144}}, {{-124, 157}},     {{-138, 158}}});
}

/// The plane square to the boundary of the spine near this point; up is outwards.
Frame acrossAt(const Contour &contour, const Vec2 &near)
{
    const NearestPlace nearest = nearestPlace(contour, near);
    const Vec2 point = nearest.position, tangent = directionAt(contour, nearest.at);
    Vec2 out(tangent.y(), -tangent.x());
    if (contour.signedArea() < 0.0)
        out = -out;
    return {{point.x(), point.y(), 0.0}, -Vec3::UnitZ(), {out.x(), out.y(), 0.0}};
}

/// A vertebra with its processes: so wide to each side, so deep in, so far out.
Contour vertebra(double wide, double in, double out)
{
    return flowingBothSides({{{0, -in}},
                             {{0.6 * wide, -in}},
                             {{wide, -0.2 * in}, true},
                             {{0.62 * wide, 0.35 * out}},
                             {{0.4 * wide, out}},
                             {{0, 0.8 * out}}});
}

/// A pair of ribs.
Contour ribs(double wide, double in, double out)
{
    return flowingBothSides({{{0, -in}},
                             {{10, -in}},
                             {{0.72 * wide, -2}},
                             {{wide, 0.36 * out}},
                             {{0.66 * wide, out}, true},
                             {{0.70 * wide, 0.4 * out}},
                             {{0.48 * wide, 12}},
                             {{0, 9}}});
}

Contour legs(double top, double shoulder, double out)
{
    return flowingBothSides({{{0, top}},
                             {{11, top - 1}},
                             {{18, shoulder + 12}},
                             {{out - 5, shoulder - 4}},
                             {{out, 0.62 * shoulder}},
                             {{out - 3, 0.3 * shoulder}},
                             {{out + 1, 9}},
                             {{out + 4, 0}, true},
                             {{out - 19, 0}, true},
                             {{out - 17, 9}},
                             {{out - 15, 0.3 * shoulder}},
                             {{out - 17, 0.56 * shoulder}},
                             {{12, shoulder - 14}},
                             {{0, shoulder - 10}}});
}

} // namespace

/// A long-necked dinosaur: vertebrae of the neck, ribs and vertebrae of the tail are blends.
void dinosaur(const std::string &folder)
{
    Maker maker;
    const Contour bone = spine();
    const SectionRef root = maker.add("Spine", facingFront(0.0), bone, {circle({-130, 169}, 3.5)});
    maker.addOn(root, "Front legs", facingRight(-46.0), legs(109, 84, 36));
    maker.addOn(root, "Hind legs", facingRight(42.0), legs(108, 84, 38));
    const auto across = [&](const char *name, const Vec2 &near, const Contour &contour) {
        return maker.addOn(root, name, acrossAt(bone, near), contour);
    };
    const SectionRef head = across("Neck", {-102, 158}, vertebra(12, 7, 9));
    const SectionRef shoulder = across("Shoulder", {-60, 119}, vertebra(20, 11, 17));
    const SectionRef front = across("Rib", {-34, 96}, ribs(25, 12, 44)),
                     belly = across("Belly rib", {-2, 98}, ribs(32, 13, 54)),
                     last = across("Last rib", {30, 98}, ribs(26, 11, 40));
    const SectionRef hip = across("Hip", {55, 111}, vertebra(19, 10, 15)),
                     tip = across("Tail", {132, 68}, vertebra(8, 3.5, 5));
    maker.apply("blend", "Vertebrae of the neck",
                {{"sections", {head, shoulder}}, {"along", {root}}}, {{"count", 6.0}});
    maker.apply("blend", "Ribs", {{"sections", {front, belly, last}}, {"along", {root}}},
                {{"count", 2.0}});
    maker.apply("blend", "Vertebrae of the tail", {{"sections", {hip, tip}}, {"along", {root}}},
                {{"count", 7.0}});
    maker.write(folder, "dinosaur");
}

} // namespace fff::samples
