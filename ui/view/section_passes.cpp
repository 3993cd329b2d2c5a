#include "ui/view/section_passes.h"

#include "ui/view/render_options.h"
#include "ui/view/view_style.h"

#include <algorithm>

namespace fff::ui {

namespace {

constexpr double kGhostFace = 0.26, kGhostEdge = 0.40; // opacity
constexpr double kSelectedTint = 0.12;                 // of the accent, over the stock
constexpr double kXrayFace = 0.20, kXrayEdge = 0.60;
constexpr double kHiddenOutline = 0.4; // opacity
constexpr double kMarkNearer = 0.02;   // mm towards the eye, to lie on the face
/// Layers of what lets light through: behind so many, next to nothing is seen.
constexpr int kAcrylicLayers = 4, kXrayLayers = 6;

QColor scaled(const QColor &c, double factor)
{
    const auto f = static_cast<float>(factor);
    return QColor::fromRgbF(f * c.redF(), f * c.greenF(), f * c.blueF());
}

QColor mixed(const QColor &colour, const QColor &behind, double alpha)
{
    const auto a = static_cast<float>(alpha);
    const auto mix = [a](float c, float b) { return a * c + (1.0f - a) * b; };
    return QColor::fromRgbF(mix(colour.redF(), behind.redF()),
                            mix(colour.greenF(), behind.greenF()),
                            mix(colour.blueF(), behind.blueF()));
}

} // namespace

SectionPasses::SectionPasses(Gl &gl, ScreenPass &pass, const SlabBuffers &slabs)
    : m_gl(gl), m_painter(gl, slabs), m_layers(gl, pass), m_caps(gl), m_marks(gl), m_fields(gl)
{
}

bool SectionPasses::isReady() const
{
    return m_painter.isReady() && m_layers.isReady() && m_caps.isReady() && m_fields.isReady();
}

void SectionPasses::begin(const Scene &scene, const FrameView &view, const ViewStyle &style,
                          const RenderOptions &options)
{
    m_scene = &scene;
    m_style = &style;
    m_options = &options;
    m_view = view;
    m_painter.begin(view, scene);
    m_marks.update(scene);
    m_fields.update(scene, options.leastStress);
}

SectionPasses::Kind SectionPasses::kindOf(std::size_t index) const
{
    const SceneSection &section = m_scene->sections[index];
    if (!m_painter.isSeen(index))
        return Kind::None;
    if (section.isGhost)
        return Kind::Ghost;
    if (m_options->isXray)
        return Kind::Translucent;
    return section.look.alpha < 1.0 && !isFrosted() ? Kind::Translucent : Kind::Opaque;
}

/// Of the coarsest picture what lets light through lets through the background's alone: without
/// layers it costs as much as what is opaque.
bool SectionPasses::isFrosted() const
{
    return m_options->quality == FrameQuality::Coarse && !m_options->isXray;
}

std::vector<std::size_t> SectionPasses::sectionsOf(Kind kind) const
{
    std::vector<std::size_t> sections;
    for (std::size_t i = 0; i < m_scene->sections.size(); ++i) {
        if (kindOf(i) == kind)
            sections.push_back(i);
    }
    return sections;
}

SlabLook SectionPasses::lookOf(std::size_t index, double alpha) const
{
    const SceneSection &section = m_scene->sections[index];
    if (section.isProblem && section.isDoubtful)
        return {m_style->warningFace, m_style->warningSide, alpha, m_style->warningHatch};
    if (section.isProblem)
        return {m_style->problemFace, m_style->problemSide, alpha, m_style->problemHatch};
    if (section.isMade)
        return {m_style->madeFace, m_style->madeSide, alpha, QColor()};
    const SlabLook look{scaled(section.look.face, m_style->faceBrightness), section.look.side,
                        alpha, QColor()};
    if (!isFrosted() || section.look.alpha >= 1.0 || section.isGhost)
        return look;
    return {mixed(look.face, m_style->bottom, section.look.alpha),
            mixed(look.side, m_style->bottom, section.look.alpha), alpha, QColor()};
}

EdgeLook SectionPasses::edgesOf(std::size_t index, double alpha) const
{
    const SceneSection &section = m_scene->sections[index];
    const QColor &problem = section.isDoubtful ? m_style->warning : m_style->problem;
    const bool isMarked = section.isProblem || section.isFaulty;
    return {premultiplied(isMarked ? problem : m_style->edge, alpha), m_style->edgeWidth,
            section.isFaulty ? m_style->problemWidth : m_style->silhouetteWidth, 0.02};
}

/// Its own, and what is drawn on it.
void SectionPasses::drawEdges(std::size_t index, double alpha)
{
    m_painter.edges(index, edgesOf(index, alpha));
    for (const MarkBuffers::Lines *lines : m_marks.lines(index)) {
        const double width =
            lines->kind == Mark::Kind::Scored ? m_style->scoredWidth : m_style->engravedWidth;
        m_painter.edges(index, lines->edges,
                        {premultiplied(m_style->edge, alpha), width, width, kMarkNearer});
    }
}

/// Pixels that a line reaches over its surface: so many slopes the surface is set back.
float SectionPasses::setBack() const
{
    return static_cast<float>(0.5 * m_style->silhouetteWidth * m_view.ratio() + 0.5);
}

/// Around what knows of the cut: a program that does not may lose anything.
void SectionPasses::setClipped(bool on)
{
    if (on && m_options->clip)
        m_gl.glEnable(GL_CLIP_DISTANCE0);
    else
        m_gl.glDisable(GL_CLIP_DISTANCE0);
}

void SectionPasses::drawOpaque()
{
    m_gl.glEnable(GL_DEPTH_TEST);
    m_gl.glEnable(GL_CULL_FACE);
    m_gl.glEnable(GL_POLYGON_OFFSET_FILL);
    setClipped(true);
    for (const std::size_t i : sectionsOf(Kind::Opaque)) {
        // Faces give way to the lines on them; and where two sections lie in one plane, one of them
        // does to the other, always the same.
        m_gl.glPolygonOffset(setBack(), 1.0f + 4.0f * static_cast<float>(i % 8));
        m_painter.fill(i, lookOf(i, 1.0));
    }
    drawFields();
    setClipped(false);
    if (m_options->clip) {
        m_gl.glPolygonOffset(setBack(), 1.0f);
        m_caps.update(*m_scene, *m_options->clip, *m_style);
        m_caps.fill(m_view);
    }
    m_gl.glDisable(GL_POLYGON_OFFSET_FILL);
    m_gl.glDisable(GL_CULL_FACE);
}

/// Between the face that they are on and the lines on it. What lets light through has them, too:
/// as they are opaque they hide what is behind them, and are seen through what is before them.
void SectionPasses::drawFields()
{
    // Slopes: before its own face, or of what lets light through almost the face itself, since that
    // is compared at another resolution.
    constexpr float kOverFace = 0.25f, kOverLayer = 0.3f;
    m_gl.glEnable(GL_BLEND);
    for (std::size_t i = 0; i < m_scene->sections.size(); ++i) {
        const Kind kind = kindOf(i);
        if (kind != Kind::Opaque && kind != Kind::Translucent)
            continue;
        const bool isOpaque = kind == Kind::Opaque;
        const std::size_t place = isOpaque ? i % 8 : 0;
        m_gl.glPolygonOffset(isOpaque ? setBack() - kOverFace : kOverLayer,
                             -1.0f + 4.0f * static_cast<float>(place));
        m_fields.draw(m_scene->sections[i], m_view,
                      {m_style->isForColourBlind, m_options->leastStress, m_options->stressAlpha});
    }
    m_gl.glDisable(GL_BLEND);
}

void SectionPasses::drawOpaqueEdges()
{
    m_gl.glEnable(GL_DEPTH_TEST);
    m_gl.glEnable(GL_BLEND);
    m_gl.glDepthMask(GL_FALSE);
    setClipped(true);
    for (const std::size_t i : sectionsOf(Kind::Opaque))
        drawEdges(i, 1.0);
    if (m_options->clip)
        m_painter.edges(m_caps.edges(), {premultiplied(m_style->edge), m_style->silhouetteWidth,
                                         m_style->silhouetteWidth, 0.05});
    setClipped(false);
    m_gl.glDepthMask(GL_TRUE);
    m_gl.glDisable(GL_BLEND);
}

bool SectionPasses::hasLayers() const
{
    return !sectionsOf(Kind::Translucent).empty() || !sectionsOf(Kind::Ghost).empty();
}

void SectionPasses::drawLayers(RenderTarget &image, const RenderTarget &opaque)
{
    drawTranslucent(image);
    if (sectionsOf(Kind::Ghost).empty())
        return;
    drawGhosts(image);
    image.copyDepthFrom(opaque); // a ghost covers no outline
}

void SectionPasses::drawTranslucent(RenderTarget &image)
{
    const std::vector<std::size_t> sections = sectionsOf(Kind::Translucent);
    if (sections.empty())
        return;
    const bool isXray = m_options->isXray;
    const auto drawAll = [&] {
        setClipped(true);
        m_gl.glEnable(GL_CULL_FACE);
        for (const std::size_t i : sections)
            m_painter.fill(i, lookOf(i, isXray ? kXrayFace : m_scene->sections[i].look.alpha));
        m_gl.glDisable(GL_CULL_FACE);
        for (const std::size_t i : sections)
            drawEdges(i, isXray ? kXrayEdge : 1.0);
        setClipped(false);
    };
    if (m_options->quality == FrameQuality::Full) {
        m_layers.draw(image, m_painter, isXray ? kXrayLayers : kAcrylicLayers, drawAll);
    } else if (isXray) {
        // All of them in any order: most are of one colour, which comes to the same.
        m_gl.glEnable(GL_DEPTH_TEST);
        m_gl.glDepthMask(GL_FALSE);
        m_gl.glEnable(GL_BLEND);
        drawAll();
        m_gl.glDisable(GL_BLEND);
        m_gl.glDepthMask(GL_TRUE);
    }
    if (isXray)
        return;
    // Their depths, so that outlines and ghosts behind them are told from those before them.
    image.bind();
    m_gl.glEnable(GL_POLYGON_OFFSET_FILL);
    m_gl.glPolygonOffset(setBack(), 1.0f);
    drawDepths(sections);
    if (m_options->quality != FrameQuality::Full) {
        // The nearest ones alone.
        m_gl.glEnable(GL_BLEND);
        m_gl.glDepthMask(GL_FALSE);
        drawAll();
        m_gl.glDepthMask(GL_TRUE);
        m_gl.glDisable(GL_BLEND);
    }
    m_gl.glDisable(GL_POLYGON_OFFSET_FILL);
    // Half of a line at a silhouette lies beyond its slab; what shines through was drawn over it.
    drawOpaqueEdges();
}

/// Only the nearest of them, once, so that many ghosts are no thicker than one.
void SectionPasses::drawGhosts(RenderTarget &image)
{
    const std::vector<std::size_t> ghosts = sectionsOf(Kind::Ghost);
    image.bind();
    m_gl.glEnable(GL_POLYGON_OFFSET_FILL);
    m_gl.glPolygonOffset(setBack(), 1.0f);
    drawDepths(ghosts);
    m_gl.glEnable(GL_BLEND);
    m_gl.glEnable(GL_CULL_FACE);
    m_gl.glDepthMask(GL_FALSE);
    setClipped(true);
    for (const std::size_t i : ghosts)
        m_painter.fill(i, lookOf(i, kGhostFace));
    m_gl.glDisable(GL_POLYGON_OFFSET_FILL);
    m_gl.glDisable(GL_CULL_FACE);
    for (const std::size_t i : ghosts)
        drawEdges(i, kGhostEdge);
    setClipped(false);
    m_gl.glDepthMask(GL_TRUE);
    m_gl.glDisable(GL_BLEND);
}

/// Nothing that is seen.
void SectionPasses::drawDepths(const std::vector<std::size_t> &sections)
{
    m_gl.glEnable(GL_DEPTH_TEST);
    m_gl.glEnable(GL_CULL_FACE);
    m_gl.glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    setClipped(true);
    for (const std::size_t i : sections)
        m_painter.fill(i, {});
    setClipped(false);
    m_gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    m_gl.glDisable(GL_CULL_FACE);
}

void SectionPasses::drawOutlines()
{
    m_gl.glEnable(GL_DEPTH_TEST);
    m_gl.glEnable(GL_BLEND);
    m_gl.glDepthMask(GL_FALSE);
    setClipped(true);
    // Wide lines reach far over slanted surfaces: nearer by as many pixels.
    const double pixel = m_view.camera.millimetresPerPixel;
    const auto outline = [&](std::size_t i, const QColor &colour, double alpha, double width,
                             double nearer) {
        m_painter.edges(i, {premultiplied(colour, alpha), width, width, nearer + width * pixel});
    };
    const std::vector<SceneSection> &sections = m_scene->sections;
    for (std::size_t i = 0; i < sections.size(); ++i) {
        if (!(sections[i].isHovered || sections[i].isSibling) || sections[i].isSelected)
            continue;
        if (m_style->casesHover && m_style->casing.isValid())
            outline(i, m_style->casing, 1.0, m_style->hoverWidth + 2.0, 0.2);
        outline(i, m_style->accent,
                sections[i].isHovered ? m_style->hoverAlpha : m_style->siblingAlpha,
                m_style->hoverWidth, 0.3);
    }
    // Selected ones are seen through what is before them, but faintly.
    m_gl.glDepthFunc(GL_GREATER);
    for (std::size_t i = 0; i < sections.size(); ++i) {
        if (sections[i].isSelected)
            outline(i, m_style->accent, kHiddenOutline, 1.4, 0.4);
    }
    m_gl.glDepthFunc(GL_LEQUAL);
    m_gl.glEnable(GL_CULL_FACE);
    for (std::size_t i = 0; i < sections.size(); ++i)
        if (sections[i].isSelected)
            m_painter.fill(i, {m_style->accent, m_style->accent, kSelectedTint, QColor()});
    m_gl.glDisable(GL_CULL_FACE);
    for (std::size_t i = 0; i < sections.size(); ++i) {
        if (!sections[i].isSelected)
            continue;
        if (m_style->casing.isValid())
            outline(i, m_style->casing, 1.0, m_style->selectionWidth + 2.0, 0.3);
        outline(i, m_style->accent, 1.0, m_style->selectionWidth, 0.4);
    }
    setClipped(false);
    m_gl.glDepthMask(GL_TRUE);
    m_gl.glDisable(GL_DEPTH_TEST);
    m_gl.glDisable(GL_BLEND);
}

} // namespace fff::ui
