// Draws pictures and drawings that sections are drawn after, where they lie.
#pragma once

#include "core/model/model.h"
#include "ui/view/frame_view.h"
#include "ui/view/gl.h"

#include <QImage>

#include <array>
#include <memory>
#include <vector>

namespace fff::ui {

/// One that is to be seen: either of them is there.
struct SceneFlat
{
    TemplatePicturePointer picture;
    TemplateCurvesPointer curves;
    std::array<Vec3, 4> corners; // world, mm: lower left, lower right, upper right, upper left
    Vec3 over = Vec3::Zero();    // mm: it lies so far before the plane on either side, so that what
                                 // it lies on does not hide it
    double opacity = kPictureOpacity;

    bool operator==(const SceneFlat &) const = default;
};

/// Those that are not hidden, whose bytes are known, and whose section is there.
std::vector<SceneFlat> flatsOf(const Model &model);

/// What is drawn of them: upright, not larger than so many pixels either way. Lines are drawn.
QImage imageOf(const SceneFlat &flat, int most);

class FlatPainter
{
public:
    explicit FlatPainter(Gl &gl);
    ~FlatPainter(); // context current
    FlatPainter(const FlatPainter &) = delete;
    FlatPainter &operator=(const FlatPainter &) = delete;

    bool isReady() const { return m_program != nullptr; }
    /// Uploads those that are new, forgets those that are gone.
    void update(const std::vector<SceneFlat> &flats);
    bool isAny() const { return !m_flats.empty(); }
    /// Onto what is bound, over what is farther away; the farthest first.
    void draw(const FrameView &view);

private:
    struct Uploaded
    {
        TemplatePicturePointer picture;
        TemplateCurvesPointer curves;
        GLuint texture = 0;
    };
    GLuint upload(const SceneFlat &flat);
    const Uploaded *find(const SceneFlat &flat) const;

    Gl &m_gl;
    std::unique_ptr<QOpenGLShaderProgram> m_program;
    GLuint m_array = 0, m_vertices = 0;
    std::vector<SceneFlat> m_flats;
    std::vector<Uploaded> m_uploaded;
};

} // namespace fff::ui
