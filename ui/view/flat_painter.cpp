#include "ui/view/flat_painter.h"

#include "core/templates/flat_template.h"
#include "core/templates/template_curves.h"
#include "core/templates/template_picture.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fff::ui {

namespace {

constexpr double kOverFace = 0.2;  // mm that it lies before the face of its section
constexpr int kLinesAcross = 2048; // px, of the picture of a drawing
constexpr double kDrawnLine = 4.0; // px
const QColor kDrawnColour(0x1b, 0x62, 0xc9);

struct FlatVertex
{
    std::array<float, 3> position;
    std::array<float, 2> place;
};

QImage linesOf(const TemplateCurves &curves, int most)
{
    const double scale = most / std::max(curves.size.maxCoeff(), 1e-9);
    const auto pixels = [&](double size) {
        return std::clamp(static_cast<int>(std::lround(size * scale)), 1, most);
    };
    const int width = pixels(curves.size.x()), height = pixels(curves.size.y());
    QImage image(width, height, QImage::Format_RGBA8888_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(kDrawnColour, kDrawnLine, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    const auto at = [&](const Vec2 &p) {
        return QPointF(width * (0.5 + p.x() / std::max(curves.size.x(), 1e-9)),
                       height * (0.5 - p.y() / std::max(curves.size.y(), 1e-9)));
    };
    for (const CurvePath &line : curves.lines) {
        QPainterPath path;
        const std::vector<Vec2> &points = line.points();
        path.moveTo(at(points.front()));
        for (std::size_t i = 1; i + 2 < points.size(); i += 3)
            path.cubicTo(at(points[i]), at(points[i + 1]), at(points[i + 2]));
        painter.drawPath(path);
    }
    return image;
}

double depthOf(const SceneFlat &flat, const Vec3 &towardsEye)
{
    return 0.25 *
           towardsEye.dot(flat.corners[0] + flat.corners[1] + flat.corners[2] + flat.corners[3]);
}

} // namespace

std::vector<SceneFlat> flatsOf(const Model &model)
{
    std::vector<SceneFlat> flats;
    for (const TemplatePointer &one : model.document.templates) {
        if (one->isHidden || !(one->picture || one->curves))
            continue;
        const std::optional<Similarity> placement = worldPlacement(*one, model);
        if (!placement)
            continue;
        SceneFlat flat{one->picture, one->curves, cornersOf(*one, *placement), Vec3::Zero(),
                       one->opacity};
        if (const Section *on = model.find(one->on); on && one->on != SectionRef())
            flat.over =
                (0.5 * model.document.stockOf(*on).thickness + kOverFace) * on->frame.normal();
        flats.push_back(std::move(flat));
    }
    return flats;
}

QImage imageOf(const SceneFlat &flat, int most)
{
    if (flat.curves)
        return linesOf(*flat.curves, std::min(most, kLinesAcross));
    const TemplatePicture &picture = *flat.picture;
    QImage image(picture.rgba.data(), picture.width, picture.height, 4 * picture.width,
                 QImage::Format_RGBA8888);
    if (std::max(picture.width, picture.height) <= most)
        return image.copy();
    // The window waits for it: of the largest not every pixel is looked at.
    if (std::max(picture.width, picture.height) > 2 * most)
        image = image.scaled(2 * most, 2 * most, Qt::KeepAspectRatio, Qt::FastTransformation);
    return image.scaled(most, most, Qt::KeepAspectRatio, Qt::SmoothTransformation)
        .convertToFormat(QImage::Format_RGBA8888);
}

FlatPainter::FlatPainter(Gl &gl) : m_gl(gl), m_program(loadProgram("picture", "picture"))
{
    m_gl.glGenVertexArrays(1, &m_array);
    m_gl.glGenBuffers(1, &m_vertices);
    m_gl.glBindVertexArray(m_array);
    m_gl.glBindBuffer(GL_ARRAY_BUFFER, m_vertices);
    m_gl.glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(FlatVertex),
                               reinterpret_cast<const void *>(offsetof(FlatVertex, position)));
    m_gl.glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(FlatVertex),
                               reinterpret_cast<const void *>(offsetof(FlatVertex, place)));
    m_gl.glEnableVertexAttribArray(0);
    m_gl.glEnableVertexAttribArray(1);
    m_gl.glBindVertexArray(0);
}

FlatPainter::~FlatPainter()
{
    for (const Uploaded &one : m_uploaded)
        m_gl.glDeleteTextures(1, &one.texture);
    m_gl.glDeleteVertexArrays(1, &m_array);
    m_gl.glDeleteBuffers(1, &m_vertices);
}

GLuint FlatPainter::upload(const SceneFlat &flat)
{
    constexpr int kMostAcross = 2048; // px: on the screen no more is seen of it
    GLint most = kMostAcross;
    m_gl.glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    const QImage image = imageOf(flat, std::min(most, kMostAcross));
    const bool isPremultiplied = image.format() == QImage::Format_RGBA8888_Premultiplied;
    const QImage plain = isPremultiplied ? image.convertToFormat(QImage::Format_RGBA8888) : image;
    GLuint texture = 0;
    m_gl.glGenTextures(1, &texture);
    m_gl.glBindTexture(GL_TEXTURE_2D, texture);
    m_gl.glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    m_gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, plain.width(), plain.height(), 0, GL_RGBA,
                      GL_UNSIGNED_BYTE, plain.constBits());
    m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    m_gl.glGenerateMipmap(GL_TEXTURE_2D);
    m_gl.glBindTexture(GL_TEXTURE_2D, 0);
    return texture;
}

const FlatPainter::Uploaded *FlatPainter::find(const SceneFlat &flat) const
{
    const auto found = std::find_if(m_uploaded.begin(), m_uploaded.end(), [&](const Uploaded &u) {
        return u.picture == flat.picture && u.curves == flat.curves;
    });
    return found == m_uploaded.end() ? nullptr : &*found;
}

void FlatPainter::update(const std::vector<SceneFlat> &flats)
{
    m_flats = flats;
    std::erase_if(m_uploaded, [&](const Uploaded &one) {
        const bool isSeen = std::any_of(flats.begin(), flats.end(), [&](const SceneFlat &flat) {
            return flat.picture == one.picture && flat.curves == one.curves;
        });
        if (!isSeen)
            m_gl.glDeleteTextures(1, &one.texture);
        return !isSeen;
    });
    for (const SceneFlat &flat : flats)
        if (!find(flat))
            m_uploaded.push_back({flat.picture, flat.curves, upload(flat)});
}

void FlatPainter::draw(const FrameView &view)
{
    const Vec3 back = view.camera.backward();
    std::vector<const SceneFlat *> order;
    for (const SceneFlat &flat : m_flats)
        order.push_back(&flat);
    std::stable_sort(order.begin(), order.end(), [&](const SceneFlat *a, const SceneFlat *b) {
        return depthOf(*a, back) < depthOf(*b, back);
    });
    m_program->bind();
    m_program->setUniformValue("toClip", toFloat(view.toClip));
    m_program->setUniformValue("image", 0);
    m_gl.glEnable(GL_DEPTH_TEST);
    m_gl.glDisable(GL_CULL_FACE);
    m_gl.glEnable(GL_BLEND);
    m_gl.glActiveTexture(GL_TEXTURE0);
    m_gl.glBindVertexArray(m_array);
    m_gl.glBindBuffer(GL_ARRAY_BUFFER, m_vertices);
    for (const SceneFlat *flat : order) {
        const Vec3 over = flat->over.dot(back) < 0.0 ? Vec3(-flat->over) : flat->over;
        std::array<FlatVertex, 4> corners;
        constexpr std::array<std::array<float, 2>, 4> places{
            {{0.0F, 1.0F}, {1.0F, 1.0F}, {0.0F, 0.0F}, {1.0F, 0.0F}}};
        constexpr std::array<std::size_t, 4> strip{0, 1, 3, 2};
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec3 at = flat->corners[strip[i]] + over;
            corners[i] = {{static_cast<float>(at.x()), static_cast<float>(at.y()),
                           static_cast<float>(at.z())},
                          places[i]};
        }
        m_gl.glBufferData(GL_ARRAY_BUFFER, sizeof(corners), corners.data(), GL_STREAM_DRAW);
        m_gl.glBindTexture(GL_TEXTURE_2D, find(*flat)->texture);
        m_program->setUniformValue("opacity", static_cast<float>(flat->opacity));
        m_gl.glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }
    m_gl.glBindTexture(GL_TEXTURE_2D, 0);
    m_gl.glBindVertexArray(0);
    m_gl.glDisable(GL_BLEND);
}

} // namespace fff::ui
