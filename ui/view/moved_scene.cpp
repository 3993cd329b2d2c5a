#include "ui/view/moved_scene.h"

#include "ui/view/bent_slab.h"

#include <Eigen/Geometry>

#include <limits>

namespace fff::ui {

namespace {

/// Turned by the whole of its angle, so that what goes far does not grow.
Frame movedFrame(const Frame &frame, const Vec3 &centroid, const RigidMotion &motion, double times)
{
    const Vec3 rotation = times * motion.rotation;
    const double angle = rotation.norm();
    const Eigen::Matrix3d turn = angle > 0.0
                                     ? Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix()
                                     : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
    return {centroid + turn * (frame.origin - centroid) + times * motion.translation,
            turn * frame.x, turn * frame.y};
}

/// How far a place of a section moves, mm: of one that bends, as the nearest of its points.
Vec3 movedAt(const Movement &movement, int section, const Vec3 &at)
{
    const Bodies &bodies = movement.analysis->bodies;
    double nearest = std::numeric_limits<double>::infinity();
    Vec3 moved = Vec3::Zero();
    for (int piece = 0; piece < bodies.countOf(section); ++piece) {
        const int index = bodies.firstOf(section) + piece;
        const auto i = static_cast<std::size_t>(index);
        const Body &body = bodies.at(index);
        const StressField *field = movement.bent ? movement.bent->drawn[i].get() : nullptr;
        if (!field) {
            const double away = distanceBetween(body.box(), Box3{at, at});
            if (away < nearest) {
                nearest = away;
                moved = movement.motions[i].translation +
                        movement.motions[i].rotation.cross(at - movement.centroids[i]);
            }
            continue;
        }
        for (std::size_t k = 0; k < field->points.size(); ++k) {
            const double away = (body.frame().toWorld(field->points[k]) - at).norm();
            if (away < nearest) {
                nearest = away;
                moved = movement.bent->moved(index, *field, k);
            }
        }
    }
    return moved;
}

} // namespace

MovedScene::Reach MovedScene::reachOf(const BentSlab &slab, const Frame &frame, double half)
{
    const auto inWorld = [&](const std::array<float, 3> &v) -> Vec3 {
        return v[0] * frame.x + v[1] * frame.y + half * v[2] * frame.normal();
    };
    Reach reach;
    for (std::size_t i = 0; i < slab.flat.vertices.size(); ++i) {
        reach.flat.extend(frame.origin + inWorld(slab.flat.vertices[i].position));
        reach.way.extend(inWorld(slab.motions[i].by));
    }
    return reach;
}

void MovedScene::bend(const Movement &movement)
{
    if (m_bent == movement.bent)
        return;
    m_bent = movement.bent;
    m_slabs.assign(movement.analysis->bodies.size(), nullptr);
    m_reaches.assign(m_slabs.size(), {});
    for (std::size_t i = 0; m_bent && i < m_slabs.size(); ++i) {
        if (!m_bent->drawn[i])
            continue;
        const StressField &field = *m_bent->drawn[i];
        const Body &body = movement.analysis->bodies.at(static_cast<int>(i));
        std::vector<Vec3> moved;
        moved.reserve(field.points.size());
        for (std::size_t k = 0; k < field.points.size(); ++k) {
            const Vec3 to = m_bent->moved(static_cast<int>(i), field, k);
            moved.emplace_back(to.dot(body.frame().x), to.dot(body.frame().y),
                               to.dot(body.frame().normal()));
        }
        const double half = 0.5 * body.thickness();
        m_slabs[i] = std::make_shared<const BentSlab>(bentSlab(field, moved, half));
        m_reaches[i] = reachOf(*m_slabs[i], body.frame(), half);
    }
}

const Scene &MovedScene::at(const Scene &scene, const Model &model, const Movement &movement,
                            double times)
{
    const Bodies &bodies = movement.analysis->bodies;
    const Model &before = movement.analysis->model;
    if (scene.sections.size() != model.sectionCount() ||
        before.sectionCount() != model.sectionCount())
        return scene;
    bend(movement);
    m_slabs.resize(bodies.size()); // without any that bends there are none
    m_scene = {};
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const int index = static_cast<int>(i);
        const auto of = static_cast<std::size_t>(bodies.sectionOf(index));
        SceneSection section = scene.sections[of];
        if (m_slabs[i]) {
            section.bent = m_slabs[i];
            section.bentTimes = times;
            section.bounds = {m_reaches[i].flat.min + times * m_reaches[i].way.min,
                              m_reaches[i].flat.max + times * m_reaches[i].way.max};
            section.marks.clear(); // they are on what is flat
            section.fields.clear();
            if (!scene.sections[of].fields.empty())
                section.fields = {movement.bent->drawn[i]};
        } else if (bodies.countOf(bodies.sectionOf(index)) > 1 &&
                   index != bodies.firstOf(bodies.sectionOf(index))) {
            continue; // the first of its pieces is drawn with all of them
        } else {
            section.frame =
                movedFrame(section.frame, movement.centroids[i], movement.motions[i], times);
            const Vec3 reach = Vec3::Constant(times * movement.most);
            section.bounds.min -= reach;
            section.bounds.max += reach;
        }
        section.covers = nullptr;
        section.guests.clear();
        m_scene.bounds.extend(section.bounds);
        m_scene.sections.push_back(std::move(section));
    }
    for (SceneThing thing : scene.things) {
        thing.at += times * movedAt(movement, thing.section, thing.at);
        m_scene.things.push_back(std::move(thing));
    }
    return m_scene;
}

} // namespace fff::ui
