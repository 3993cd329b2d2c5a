#include "core/io/svg_reader.h"

#include "core/base/tolerances.h"
#include "core/geometry/contour.h"
#include "core/io/loaded_document.h"
#include "core/io/svg_clip.h"
#include "core/io/svg_shapes.h"
#include "core/io/svg_source.h"
#include "core/io/svg_values.h"

#include <QtCore/QCoreApplication>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <memory>
#include <optional>
#include <pugixml.hpp>
#include <set>

namespace fff::io {

namespace {

/// `use` inside `use`, and groups inside groups, so deep.
constexpr int kDeepest = 256;

/// An element takes as long as so many points, if it draws nothing.
constexpr std::size_t kElementPoints = 4;

constexpr double kMillimetresPerPixel = 25.4 / 96.0;

/// What goes on from an element to those in it.
struct State
{
    SvgTransform transform = SvgTransform::Identity(); // to the root's user units
    std::string fill, stroke;
    bool isVisible = true;
    Vec2 viewport = Vec2::Zero();                      // what percentages are of
    std::vector<std::shared_ptr<const SvgClip>> clips; // in mm; all of them clip
    int depth = 0;
};

class Reader
{
public:
    Reader(std::string_view bytes, std::string name) : m_source(bytes, std::move(name)) {}

    Result<SvgDrawing> read();

private:
    SvgTransform rootTransform(const pugi::xml_node &svg, State &state) const;
    void enter(const pugi::xml_node &node, State &state);
    void clip(const pugi::xml_node &node, State &state);
    std::optional<Box2> boxOf(const pugi::xml_node &node, const State &state);
    void children(const pugi::xml_node &node, const State &state);
    void element(const pugi::xml_node &node, State state);
    void draw(const pugi::xml_node &node, State state);
    void nested(const pugi::xml_node &node, State state, const Vec2 &size);
    void use(const pugi::xml_node &node, State state);
    void measurePicture(const pugi::xml_node &node, const State &state);
    void add(const pugi::xml_node &node, const State &state, const SvgSubpath &path);
    void addLine(std::vector<Vec2> points, const State &state);

    SvgSource m_source;
    SvgDrawing m_drawing;
    std::vector<Contour> *m_clipped = nullptr;   // where shapes go while a clip path is read
    Box2 *m_measured = nullptr;                  // the same while an element's box is looked for
    double m_millimetres = kMillimetresPerPixel; // of the root's user unit
};

std::string lower(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return text;
}

bool isPaint(const std::string &paint, bool otherwise)
{
    return paint.empty() ? otherwise : paint != "none" && paint != "transparent";
}

const std::set<std::string> kShapes{"path", "rect",     "circle", "ellipse",
                                    "line", "polyline", "polygon"};

bool isText(const std::string &name)
{
    return name == "text" || name == "flowRoot" || name == "foreignObject";
}

/// Of a drawing without lines, which may have what is passed over.
const char *whatIsMissing(const SvgDrawing &drawing)
{
    if (drawing.texts > 0)
        return QT_TRANSLATE_NOOP("Error", "lines; text must be turned into paths first");
    if (drawing.pictures > 0)
        return QT_TRANSLATE_NOOP("Error", "lines; a picture must be traced first");
    return QT_TRANSLATE_NOOP("Error", "lines, shapes or paths");
}

/// Where a cubic with these values turns back, between its ends.
std::vector<double> turnsOf(double v0, double v1, double v2, double v3)
{
    const double a = v3 - 3.0 * v2 + 3.0 * v1 - v0, b = 2.0 * (v2 - 2.0 * v1 + v0), c = v1 - v0;
    const double root = std::sqrt(std::max(b * b - 4.0 * a * c, 0.0));
    const double q = -0.5 * (b + std::copysign(root, b)); // loses no digits
    std::vector<double> turns;
    for (const double t : {q / a, c / q})
        if (t > 0.0 && t < 1.0) // neither for what is not finite
            turns.push_back(t);
    return turns;
}

/// Of the curves themselves, not of their handles.
Box2 boundsOf(const SvgSubpath &path, const SvgTransform &transform)
{
    Box2 box;
    for (std::size_t i = 0; i + 3 < path.points.size(); i += 3) {
        const CubicBezier curve{transform * path.points[i], transform * path.points[i + 1],
                                transform * path.points[i + 2], transform * path.points[i + 3]};
        box.extend(curve.p0);
        box.extend(curve.p3);
        for (const int axis : {0, 1})
            for (const double t :
                 turnsOf(curve.p0[axis], curve.p1[axis], curve.p2[axis], curve.p3[axis]))
                box.extend(curve.at(t));
    }
    return box;
}

/// The id in "url(#id)".
std::string urlTarget(const std::string &text)
{
    const std::size_t hash = text.find('#'), end = text.find_first_of(")'\"", hash);
    return hash == std::string::npos || !text.starts_with("url") || end == std::string::npos
               ? std::string()
               : text.substr(hash + 1, end - hash - 1);
}

/// To px of the root, and how long one is.
SvgTransform Reader::rootTransform(const pugi::xml_node &svg, State &state) const
{
    const std::string width = svg.attribute("width").value();
    const std::string height = svg.attribute("height").value();
    const std::optional<SvgViewBox> box = svgViewBox(svg.attribute("viewBox").value());
    const Vec2 whole = box ? box->size : Vec2(100.0, 100.0);
    const auto sideOf = [](const std::string &text, double otherwise) {
        const bool isRelative = text.find('%') != std::string::npos;
        const std::optional<double> side = svgLength(text, otherwise);
        return side && *side > 0.0 && !isRelative ? *side : otherwise;
    };
    const Vec2 size(sideOf(width, whole.x()), sideOf(height, whole.y()));
    state.viewport = box ? box->size : size;
    return box ? fitted(*box, size, svg.attribute("preserveAspectRatio").value())
               : SvgTransform::Identity();
}

/// mm a px, as the program meant that wrote it.
double millimetresPerPixel(const pugi::xml_node &svg, std::string_view bytes)
{
    if (isTrueLength(svg.attribute("width").value()))
        return kMillimetresPerPixel;
    if (bytes.substr(0, 2000).find("Adobe Illustrator") != std::string_view::npos)
        return 25.4 / 72.0;
    const std::string inkscape = svg.attribute("inkscape:version").value();
    if (inkscape.starts_with("0.") && inkscape < "0.92")
        return 25.4 / 90.0;
    return kMillimetresPerPixel;
}

/// What the element says of itself and all that is in it.
void Reader::enter(const pugi::xml_node &node, State &state)
{
    if (const std::string fill = m_source.property(node, "fill");
        !fill.empty() && fill != "inherit")
        state.fill = lower(fill);
    if (const std::string stroke = m_source.property(node, "stroke");
        !stroke.empty() && stroke != "inherit")
        state.stroke = lower(stroke);
    if (const std::string visible = m_source.property(node, "visibility"); !visible.empty())
        state.isVisible = visible == "visible" || visible == "inherit";
    const std::string transform = m_source.property(node, "transform");
    if (!transform.empty() && transform != "none") {
        if (const std::optional<SvgTransform> own = svgTransform(transform))
            state.transform = state.transform * *own;
        else
            m_source.fail(ErrorCode::BadValue, node,
                          {quoted(transform), QT_TRANSLATE_NOOP("Error", "a transform")});
    }
    clip(node, state);
}

void Reader::clip(const pugi::xml_node &node, State &state)
{
    const std::string target = urlTarget(m_source.property(node, "clip-path"));
    const pugi::xml_node found = m_source.named(target);
    if (target.empty() || !found || m_clipped || m_measured || m_source.error())
        return;
    const bool isOfBox =
        std::strcmp(found.attribute("clipPathUnits").value(), "objectBoundingBox") == 0;
    const std::optional<Box2> box = isOfBox ? boxOf(node, state) : std::nullopt;
    if (isOfBox && !box)
        return;
    std::vector<Contour> contours;
    m_clipped = &contours;
    State inside = state;
    inside.isVisible = true;
    inside.fill.clear();
    inside.clips.clear();
    ++inside.depth;
    enter(found, inside);
    if (box) {
        inside.transform.translate(box->min).scale(box->size());
        inside.viewport = Vec2::Ones();
    }
    children(found, inside);
    m_clipped = nullptr;
    state.clips.push_back(std::make_shared<const SvgClip>(std::move(contours)));
}

/// Of what the element draws, in its own user units, before anything is cut off. Nothing where it
/// has no width or no height: what is in units of such a box does not count (SVG 1.1, 7.11).
std::optional<Box2> Reader::boxOf(const pugi::xml_node &node, const State &state)
{
    Box2 box;
    m_measured = &box;
    State inside = state;
    inside.transform = SvgTransform::Identity();
    if (node == m_source.root())
        children(node, inside);
    else
        draw(node, inside);
    m_measured = nullptr;
    const bool isFlat = box.isEmpty() || !(box.size().minCoeff() > 0.0);
    return isFlat ? std::nullopt : std::optional(box);
}

void Reader::children(const pugi::xml_node &node, const State &state)
{
    for (const pugi::xml_node &child : node.children())
        if (child.type() == pugi::node_element && !m_source.error())
            element(child, state);
}

void Reader::element(const pugi::xml_node &node, State state)
{
    if (++state.depth > kDeepest) {
        m_source.fail(ErrorCode::BadCount, node,
                      {std::to_string(state.depth), std::to_string(kDeepest),
                       QT_TRANSLATE_NOOP("Error", "groups in groups")});
        return;
    }
    static const std::set<std::string> kGroups{"image", "g", "a", "switch", "svg", "use"};
    const std::string name = localName(node);
    m_source.count(node, kElementPoints);
    const bool isDrawn = kShapes.contains(name) || isText(name) || kGroups.contains(name);
    if (!isDrawn || m_source.property(node, "display") == "none")
        return;
    enter(node, state);
    if (!m_source.error())
        draw(node, std::move(state));
}

/// What the element is, when what it says of itself is known.
void Reader::draw(const pugi::xml_node &node, State state)
{
    const std::string name = localName(node);
    const bool isPassedOver = state.isVisible && !m_clipped && !m_measured;
    if (isText(name)) {
        m_drawing.texts += isPassedOver ? 1 : 0;
    } else if (name == "image") {
        m_drawing.pictures += isPassedOver ? 1 : 0;
        if (m_measured)
            measurePicture(node, state);
    } else if (name == "use") {
        use(node, state);
    } else if (name == "svg") {
        const Vec2 &all = state.viewport;
        state.transform.translate(
            Vec2(m_source.length(node, "x", all.x()), m_source.length(node, "y", all.y())));
        nested(node, state,
               {m_source.length(node, "width", all.x(), all.x()),
                m_source.length(node, "height", all.y(), all.y())});
    } else if (name == "switch") {
        // The first one that any program can show.
        for (const pugi::xml_node &child : node.children())
            if (child.type() == pugi::node_element && !child.attribute("requiredExtensions") &&
                localName(child) != "foreignObject")
                return element(child, state);
    } else if (kShapes.contains(name)) {
        for (const SvgSubpath &path : svgShape(m_source, node, state.viewport))
            add(node, state, path);
    } else {
        children(node, state);
    }
}

/// In a box of its own.
void Reader::nested(const pugi::xml_node &node, State state, const Vec2 &size)
{
    if (!(size.minCoeff() > 0.0))
        return;
    state.viewport = size;
    if (const auto box = svgViewBox(node.attribute("viewBox").value())) {
        state.transform =
            state.transform * fitted(*box, size, node.attribute("preserveAspectRatio").value());
        state.viewport = box->size;
    }
    children(node, state);
}

void Reader::use(const pugi::xml_node &node, State state)
{
    std::string target = node.attribute("href").value();
    if (target.empty())
        target = node.attribute("xlink:href").value();
    if (!target.starts_with('#'))
        return;
    const pugi::xml_node used = m_source.named(target.substr(1));
    if (!used)
        return;
    const Vec2 &all = state.viewport;
    state.transform.translate(
        Vec2(m_source.length(node, "x", all.x()), m_source.length(node, "y", all.y())));
    if (localName(used) != "symbol") {
        element(used, state);
        return;
    }
    enter(used, state);
    nested(used, state,
           {m_source.length(node, "width", all.x(), all.x()),
            m_source.length(node, "height", all.y(), all.y())});
}

void Reader::measurePicture(const pugi::xml_node &node, const State &state)
{
    const Vec2 &all = state.viewport;
    const Vec2 at(m_source.length(node, "x", all.x()), m_source.length(node, "y", all.y()));
    const Vec2 size(m_source.length(node, "width", all.x()),
                    m_source.length(node, "height", all.y()));
    if (size.minCoeff() > 0.0)
        for (const Vec2 &corner : {Vec2(0.0, 0.0), Vec2(1.0, 0.0), Vec2(0.0, 1.0), Vec2(1.0, 1.0)})
            m_measured->extend(state.transform * Vec2(at + corner.cwiseProduct(size)));
}

/// Of closed lines what is enclosed by all clips, of open ones what lies in them.
void Reader::add(const pugi::xml_node &node, const State &state, const SvgSubpath &path)
{
    m_source.count(node, path.points.size());
    if (m_measured && !m_source.error()) {
        m_measured->extend(boundsOf(path, state.transform));
        return;
    }
    const bool isFilled = isPaint(state.fill, true), isStroked = isPaint(state.stroke, false);
    if (m_source.error() || !state.isVisible || !(isFilled || isStroked || m_clipped))
        return;
    std::vector<Vec2> points = path.points;
    for (Vec2 &p : points) {
        p = state.transform * p;
        // y upwards; the lower left comes to 0 when all is there.
        p = m_millimetres * Vec2(p.x(), -p.y());
        if (!p.allFinite() || p.cwiseAbs().maxCoeff() > kMaxCoordinate) {
            m_source.fail(ErrorCode::BadValue, node,
                          {shortNumber(p.cwiseAbs().maxCoeff()) + " mm",
                           QT_TRANSLATE_NOOP("Error", "places within a kilometre")});
            return;
        }
    }
    if (path.isClosed)
        points.back() = points.front();
    if (m_clipped) {
        if (points.back() != points.front()) {
            const CubicBezier closing = CubicBezier::line(points.back(), points.front());
            points.insert(points.end(), {closing.p1, closing.p2, closing.p3});
        }
        const Result<CurvePath> closed = CurvePath::fromPoints(std::move(points));
        Result<Contour> contour = closed ? closed->ring() : tl::unexpected(closed.error());
        if (!contour)
            return m_source.fail(contour.error().code, {}, contour.error().args);
        m_clipped->push_back(*std::move(contour));
        return;
    }
    addLine(std::move(points), state);
}

void Reader::addLine(std::vector<Vec2> points, const State &state)
{
    Result<CurvePath> path = CurvePath::fromPoints(std::move(points));
    if (!path)
        return;
    std::vector<CurvePath> paths{*std::move(path)};
    for (const std::shared_ptr<const SvgClip> &clip : state.clips) {
        std::vector<CurvePath> left;
        for (const CurvePath &one : paths) {
            Result<std::vector<CurvePath>> pieces = clip->clipped(one);
            if (!pieces)
                return m_source.fail(pieces.error().code, {}, pieces.error().args);
            std::move(pieces->begin(), pieces->end(), std::back_inserter(left));
        }
        paths = std::move(left);
    }
    for (CurvePath &one : paths)
        m_drawing.lines.push_back({std::move(one), state.stroke, isPaint(state.fill, true)});
}

Result<SvgDrawing> Reader::read()
{
    if (!m_source.parse())
        return tl::unexpected(*m_source.error());
    const pugi::xml_node svg = m_source.root();
    m_drawing.isCuttingFile = m_source.isCuttingFile();
    State state;
    const bool isCut = svg.attribute("width") || svg.attribute("viewBox");
    state.transform = isCut ? rootTransform(svg, state) : SvgTransform::Identity();
    m_millimetres = millimetresPerPixel(svg, m_source.bytes());
    m_drawing.isTrueSize = isTrueLength(svg.attribute("width").value());
    State inside = state;
    enter(svg, inside);
    if (!m_source.error())
        children(svg, inside);
    if (m_source.error())
        return tl::unexpected(*m_source.error());
    if (m_drawing.lines.empty())
        return failure(ErrorCode::BadValue, m_source.name(), {"", whatIsMissing(m_drawing)});
    Box2 box;
    for (const SvgDrawing::Line &line : m_drawing.lines)
        for (const Vec2 &p : line.path.flatten(kCutChord))
            box.extend(p);
    for (SvgDrawing::Line &line : m_drawing.lines) {
        std::vector<Vec2> points = line.path.points();
        for (Vec2 &p : points)
            p -= box.min;
        if (Result<CurvePath> moved = CurvePath::fromPoints(std::move(points)))
            line.path = *std::move(moved);
    }
    return std::move(m_drawing);
}

} // namespace

Result<SvgDrawing> readSvg(std::string_view bytes, const std::string &name)
{
    return Reader(bytes, name).read();
}

} // namespace fff::io
