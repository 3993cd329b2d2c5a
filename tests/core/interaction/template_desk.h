// A desk with templates: a picture on each plane, and a mesh.
#pragma once

#include "core/interaction/tool.h"
#include "core/model/template_edits.h"
#include "core/templates/flat_template.h"
#include "core/templates/template_mesh.h"
#include "core/templates/template_picture.h"
#include "tests/core/interaction/desk.h"
#include "tests/core/templates/made_meshes.h"

#include <functional>
#include <memory>

namespace fff::test {

/// Dark where it is said so, else white; places are px from the upper left.
inline TemplatePicturePointer pictureOf(int width, int height,
                                        const std::function<bool(double x, double y)> &isDark)
{
    auto picture = std::make_shared<TemplatePicture>();
    picture->width = width;
    picture->height = height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto shade = static_cast<std::uint8_t>(isDark(x + 0.5, y + 0.5) ? 20 : 250);
            for (const std::uint8_t value : {shade, shade, shade, std::uint8_t(255)})
                picture->rgba.push_back(value);
        }
    return picture;
}

inline TemplatePicturePointer discPicture(int across = 200, double radius = 70.0)
{
    return pictureOf(across, across, [=](double x, double y) {
        return std::hypot(x - 0.5 * across, y - 0.5 * across) < radius;
    });
}

inline Template pictureTemplate(TemplatePicturePointer picture, double scale = 0.5)
{
    Template one;
    one.kind = TemplateKind::Picture;
    one.name = "Disc";
    one.file = "disc.png";
    one.picture = std::move(picture);
    one.scale = scale;
    one.opacity = kPictureOpacity;
    return one;
}

inline Template ballTemplate(double radius = 60.0)
{
    Template one;
    one.name = "Ball";
    one.file = "ball.stl";
    one.mesh = makeTemplateMesh(mended(sphere(radius, 30, 40)).value().mesh, {}).value();
    one.frame.origin = {0.0, kFirstPlaneHeight, 0.0};
    return one;
}

class TemplateDesk : public Desk
{
public:
    /// A section stands behind it all, out of the way, so that presses draw no first one.
    explicit TemplateDesk(const Template &one)
    {
        Document document =
            withSection(session.committed().document, polygonShape(rectangle(-30, 0, 30, 40)),
                        test::front(-200.0));
        session.reset(addTemplate(std::move(document), one).value());
        interaction.settings().snaps = false;
        look(0.0, 0.0);
    }
    /// From the front, turned so far to the side and up, radians.
    void look(double aside, double up)
    {
        Camera camera = interaction.camera();
        camera.orientation = Eigen::Quaterniond(Eigen::AngleAxisd(aside, Vec3::UnitY())) *
                             Eigen::Quaterniond(Eigen::AngleAxisd(-up, Vec3::UnitX()));
        camera.millimetresPerPixel = 0.4;
        camera.target = worldFrame(one(), session.committed())->origin;
        interaction.setCamera(camera);
    }
    const Template &one() const { return *session.committed().document.templates.front(); }
    const Template &shown() const { return *session.model().document.templates.front(); }
    void change(const std::function<void(Template &)> &change)
    {
        Template next = one();
        change(next);
        session.commit(QStringLiteral("Change"),
                       setTemplate(session.committed().document, next).value());
    }
    void hold()
    {
        run("template.transform");
        wait(10.0);
    }
    const GizmoMarks *marks() const { return interaction.overlay().find<GizmoMarks>(); }
    const Gizmo &gizmo() const { return marks()->gizmo; }
    GizmoLook look() const { return {gizmo(), interaction.camera(), kViewport}; }
    /// Where a ring is held: a place on it that nothing else has.
    Vec2 onRing(int axis) const
    {
        const GizmoPart parts[] = {GizmoPart::TurnX, GizmoPart::TurnY, GizmoPart::TurnZ};
        for (const Vec2 &place : look().ring(axis))
            if (look().partAt(place, 10.0) == parts[axis])
                return place;
        return Vec2(-1, -1);
    }
};

} // namespace fff::test
