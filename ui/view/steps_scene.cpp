#include "ui/view/steps_scene.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace fff::ui {

namespace {

constexpr std::size_t kMostPlaces = 12; // that are tried for a number
constexpr double kNumberReach = 9.0;    // px, from its middle
constexpr double kBesideWay = 22.0;     // px, a number from the arrow
constexpr int kAllRound = 5;            // nothing of it lies over anything else

double areaOf(const Triangulation &triangulation, const std::array<int, 3> &triangle)
{
    const auto at = [&](int i) {
        return triangulation
            .points[static_cast<std::size_t>(triangle[static_cast<std::size_t>(i)])];
    };
    return 0.5 * cross(at(1) - at(0), at(2) - at(0));
}

Vec2 middleOf(const Triangulation &triangulation, const std::array<int, 3> &triangle)
{
    Vec2 sum = Vec2::Zero();
    for (const int i : triangle)
        sum += triangulation.points[static_cast<std::size_t>(i)];
    return sum / 3.0;
}

/// Its centroid, where that is in it, and the middles of its largest triangles.
std::vector<Vec2> numberPlaces(const Region &region, const Triangulation &triangulation)
{
    std::vector<std::array<int, 3>> largest = triangulation.triangles;
    Vec2 first = Vec2::Zero();
    double area = 0.0;
    for (const auto &triangle : largest) {
        first += areaOf(triangulation, triangle) * middleOf(triangulation, triangle);
        area += areaOf(triangulation, triangle);
    }
    const std::size_t count = std::min(kMostPlaces, largest.size());
    std::partial_sort(largest.begin(), largest.begin() + static_cast<std::ptrdiff_t>(count),
                      largest.end(), [&](const auto &a, const auto &b) {
                          return areaOf(triangulation, a) > areaOf(triangulation, b);
                      });
    std::vector<Vec2> places;
    if (area > 0.0 && locate(Vec2(first / area), region) == Side::Inside)
        places.push_back(first / area);
    for (std::size_t i = 0; i < count; ++i)
        places.push_back(middleOf(triangulation, largest[i]));
    return places;
}

} // namespace

StepsScene::StepsScene(AssemblyStepsPointer steps) : m_steps(std::move(steps))
{
    const Analysis &analysis = *m_steps->analysis;
    for (std::size_t i = 0; i < m_steps->bodies.size(); ++i) {
        const auto index = static_cast<std::size_t>(m_steps->bodies.sectionOf(static_cast<int>(i)));
        const Body &body = m_steps->bodies[i];
        const Section &section = *analysis.model.section(index);
        const CutSectionPointer &cut = body.cut();
        const Region &outline = body.outline().region;
        Item item;
        // Parts of a divided section go their own ways.
        item.section.cut =
            cut->parts().size() == 1
                ? cut
                : std::make_shared<const CutSection>(std::vector<CurvedRegion>{body.outline()});
        item.section.shape = section.shape;
        item.section.frame = section.frame;
        item.section.thickness = analysis.model.stockOf(index).thickness;
        item.section.look = stockLook(analysis.model.stockOf(index));
        Box2 box;
        for (const Vec2 &p : outline.outer) {
            box.extend(p);
            item.section.bounds.extend(section.frame.toWorld(p));
        }
        item.extent = box.size().minCoeff();
        const Vec3 half = 0.5 * item.section.thickness * section.frame.normal().cwiseAbs();
        item.section.bounds.min -= half;
        item.section.bounds.max += half;
        item.numberPlaces = numberPlaces(outline, cut->triangulations()->at(body.piece()));
        item.tree = &cut->trees()[body.piece()];
        m_items.push_back(std::move(item));
    }
}

StepsPicture StepsScene::at(double time, double drawnApart, const Camera &camera,
                            const Vec2 &viewport) const
{
    const Playback &playback = m_steps->playback;
    const std::vector<PartPlace> places = playback.at(time, drawnApart);
    StepsPicture picture{sceneOf(places, drawnApart), {}};
    if (const int step = playback.stepAt(time); step >= 0)
        addWay(picture, step, drawnApart);
    addNumbers(picture, places, camera, viewport);
    return picture;
}

StepsPicture StepsScene::before(int step, const Camera &camera, const Vec2 &viewport) const
{
    const std::vector<PartPlace> places = m_steps->playback.before(step);
    StepsPicture picture{sceneOf(places, 0.0), {}};
    addWay(picture, step, 0.0);
    addNumbers(picture, places, camera, viewport);
    return picture;
}

StepsPicture StepsScene::finished(const Camera &camera, const Vec2 &viewport) const
{
    const std::vector<PartPlace> places = finishedPlaces();
    StepsPicture picture{sceneOf(places, 0.0), {}};
    addNumbers(picture, places, camera, viewport);
    return picture;
}

Scene StepsScene::sceneAt(double time, double drawnApart) const
{
    return sceneOf(m_steps->playback.at(time, drawnApart), drawnApart);
}

Scene StepsScene::sceneBefore(int step) const
{
    return sceneOf(m_steps->playback.before(step), 0.0);
}

Scene StepsScene::finishedScene() const
{
    return sceneOf(finishedPlaces(), 0.0);
}

std::vector<PartPlace> StepsScene::finishedPlaces() const
{
    std::vector<PartPlace> places = m_steps->playback.at(m_steps->playback.stepCount());
    for (PartPlace &place : places)
        place.isMoving = false;
    return places;
}

Scene StepsScene::sceneOf(const std::vector<PartPlace> &places, double drawnApart) const
{
    Scene scene;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!places[i].isThere)
            continue;
        SceneSection section = m_items[i].section;
        section.frame.origin += places[i].offset;
        section.bounds.min += places[i].offset;
        section.bounds.max += places[i].offset;
        section.isSelected = places[i].isMoving;
        scene.sections.push_back(std::move(section));
    }
    if (m_reachOf != drawnApart) {
        m_reach = m_steps->playback.reach(drawnApart);
        m_reachOf = drawnApart;
    }
    scene.bounds = m_reach; // the same at all times, so that the ground stays as it is
    return scene;
}

void StepsScene::addWay(StepsPicture &picture, int step, double drawnApart) const
{
    const std::vector<Vec3> &way = m_steps->playback.way(step);
    if (way.size() < 2)
        return;
    const Vec3 middle = m_steps->playback.middleOf(step, drawnApart);
    for (const Vec3 &corner : way)
        picture.marks.way.push_back(middle + corner);
}

void StepsScene::addNumbers(StepsPicture &picture, const std::vector<PartPlace> &places,
                            const Camera &camera, const Vec2 &viewport) const
{
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!places[i].isThere)
            continue;
        if (places[i].isMoving) {
            const Vec2 place = placeBesideWay(i, picture.marks.way, camera, viewport);
            picture.marks.numbers.push_back({onFace(place, i, places[i].offset, camera, viewport),
                                             m_items[i].extent,
                                             AssemblySteps::numberOf(static_cast<int>(i)), true});
            continue;
        }
        int best = 0;
        Vec2 bestPlace = Vec2::Zero();
        for (const Vec2 &place : m_items[i].numberPlaces) {
            const int room = best < kAllRound ? roomAt(place, i, places, camera, viewport) : 0;
            if (room > best) {
                best = room;
                bestPlace = place;
            }
        }
        if (best > 0)
            picture.marks.numbers.push_back(
                {onFace(bestPlace, i, places[i].offset, camera, viewport), m_items[i].extent,
                 AssemblySteps::numberOf(static_cast<int>(i)), false});
    }
}

Vec2 StepsScene::placeBesideWay(std::size_t part, const std::vector<Vec3> &way,
                                const Camera &camera, const Vec2 &viewport) const
{
    const std::vector<Vec2> &places = m_items[part].numberPlaces;
    if (places.empty())
        return Vec2::Zero();
    if (way.size() < 2)
        return places.front();
    const Vec2 tip = camera.toScreen(way.back(), viewport);
    const Vec2 last = tip - camera.toScreen(way[way.size() - 2], viewport);
    if (last.norm() < 1.0)
        return places.front();
    double best = -1.0;
    Vec2 bestPlace = places.front();
    for (const Vec2 &place : places) {
        const Vec2 at =
            camera.toScreen(onFace(place, part, Vec3::Zero(), camera, viewport), viewport);
        const double beside = std::min(std::abs(cross(last, at - tip)) / last.norm(), kBesideWay);
        if (beside > best + 1.0) {
            best = beside;
            bestPlace = place;
        }
    }
    return bestPlace;
}

/// On the face that is seen.
Vec3 StepsScene::onFace(const Vec2 &place, std::size_t part, const Vec3 &offset,
                        const Camera &camera, const Vec2 &viewport) const
{
    const SceneSection &section = m_items[part].section;
    const Vec3 at = section.frame.toWorld(place) + offset, normal = section.frame.normal();
    const double side = camera.towardsEye(at, viewport).dot(normal) < 0.0 ? -0.5 : 0.5;
    return at + side * section.thickness * normal;
}

int StepsScene::roomAt(const Vec2 &place, std::size_t part, const std::vector<PartPlace> &places,
                       const Camera &camera, const Vec2 &viewport) const
{
    const auto isSeen = [&](const Vec2 &p) {
        const Vec3 at = onFace(p, part, places[part].offset, camera, viewport);
        return m_items[part].tree->locate(p) == Side::Inside &&
               !isCovered(at, part, places, camera.towardsEye(at, viewport));
    };
    if (!isSeen(place))
        return 0;
    const Vec3 middle = onFace(place, part, places[part].offset, camera, viewport);
    const double reach = kNumberReach * camera.scaleAt(middle, viewport);
    int room = 1;
    for (const Vec2 &side : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)})
        room += isSeen(place + reach * side) ? 1 : 0;
    return room;
}

bool StepsScene::isCovered(const Vec3 &at, std::size_t part, const std::vector<PartPlace> &places,
                           const Vec3 &towardsEye) const
{
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (i == part || !places[i].isThere)
            continue;
        // Its middle stands for it: a number at an edge that is just covered is still read.
        const Frame &frame = m_items[i].section.frame;
        const Vec3 from = at - places[i].offset - frame.origin;
        const double speed = towardsEye.dot(frame.normal());
        const double distance = -from.dot(frame.normal());
        if (!(distance * speed > 0.0))
            continue; // behind, or seen on edge
        const Vec3 hit = from + distance / speed * towardsEye;
        if (m_items[i].tree->locate(Vec2(hit.dot(frame.x), hit.dot(frame.y))) == Side::Inside)
            return true;
    }
    return false;
}

} // namespace fff::ui
