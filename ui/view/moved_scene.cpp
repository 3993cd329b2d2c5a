#include "ui/view/moved_scene.h"

#include "ui/view/bent_mesh.h"

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

Box3 boxOf(const SlabMesh &mesh, const SceneSection &section)
{
    Box3 box;
    for (const SlabVertex &vertex : mesh.vertices)
        box.extend(section.frame.toWorld(Vec2(vertex.position[0], vertex.position[1])) +
                   0.5 * section.thickness * vertex.position[2] * section.frame.normal());
    return box;
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
        const StressField *field = movement.bent ? movement.bent->fields[i].get() : nullptr;
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
                moved = movement.bent->moved(index, k);
            }
        }
    }
    return moved;
}

} // namespace

void MovedScene::bend(const Movement &movement, double times)
{
    if (m_bent == movement.bent && m_times == times)
        return;
    m_bent = movement.bent;
    m_times = times;
    m_meshes.assign(movement.analysis->bodies.size(), nullptr);
    for (std::size_t i = 0; m_bent && i < m_meshes.size(); ++i) {
        if (!m_bent->fields[i])
            continue;
        const StressField &field = *m_bent->fields[i];
        const Body &body = movement.analysis->bodies.at(static_cast<int>(i));
        std::vector<Vec3> moved;
        moved.reserve(field.points.size());
        for (std::size_t k = 0; k < field.points.size(); ++k) {
            const Vec3 to = times * m_bent->moved(static_cast<int>(i), k);
            moved.emplace_back(to.dot(body.frame().x), to.dot(body.frame().y),
                               to.dot(body.frame().normal()));
        }
        m_meshes[i] =
            std::make_shared<const SlabMesh>(bentMesh(field, moved, 0.5 * body.thickness()));
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
    bend(movement, times);
    m_scene = {};
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const int index = static_cast<int>(i);
        const auto of = static_cast<std::size_t>(bodies.sectionOf(index));
        SceneSection section = scene.sections[of];
        if (m_meshes[i]) {
            section.mesh = m_meshes[i];
            section.bounds = boxOf(*section.mesh, section);
            section.marks.clear(); // they are on what is flat
            section.fields.clear();
            if (!scene.sections[of].fields.empty())
                section.fields = {movement.bent->fields[i]};
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
