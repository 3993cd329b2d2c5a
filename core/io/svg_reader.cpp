#include "core/io/svg_reader.h"

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/geometry/line_clip.h"
#include "core/io/loaded_document.h"
#include "core/io/svg_values.h"

#include <QtCore/QCoreApplication>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <set>

namespace fff::io {

namespace {

/// `use` inside `use`, and groups inside groups, so deep.
constexpr int kDeepest = 256;

constexpr double kMillimetresPerPixel = 25.4 / 96.0;

/// What goes on from an element to those in it.
struct State
{
    SvgTransform transform = SvgTransform::Identity(); // to the root's user units
    std::string fill, stroke;
    bool isVisible = true;
    Vec2 viewport = Vec2::Zero();            // what percentages are of
    std::vector<std::vector<Contour>> clips; // mm; all of them clip
    int depth = 0;
};

class Reader
{
public:
    Reader(std::string_view bytes, std::string name) : m_bytes(bytes), m_name(std::move(name)) {}

    Result<SvgDrawing> read();

private:
    using Styles = std::map<std::string, std::string>;

    std::string placeOf(const pugi::xml_node &node) const { return placeAt(node.offset_debug()); }
    std::string placeAt(std::ptrdiff_t offset) const;
    void fail(ErrorCode code, const std::string &place, std::vector<std::string> args = {});
    void index(const pugi::xml_node &node);
    std::string property(const pugi::xml_node &node, const char *name) const;
    double length(const pugi::xml_node &node, const char *name, double percentOf,
                  double otherwise = 0.0);
    SvgTransform rootTransform(const pugi::xml_node &svg, State &state) const;
    void enter(const pugi::xml_node &node, State &state);
    void clip(const pugi::xml_node &node, State &state);
    void children(const pugi::xml_node &node, const State &state);
    void element(const pugi::xml_node &node, State state);
    void nested(const pugi::xml_node &node, State state, const Vec2 &size);
    void use(const pugi::xml_node &node, State state);
    std::vector<SvgSubpath> shape(const pugi::xml_node &node, const State &state);
    std::vector<SvgSubpath> rectangle(const pugi::xml_node &node, const State &state);
    std::vector<SvgSubpath> ellipse(const pugi::xml_node &node, const State &state);
    std::vector<SvgSubpath> corners(const pugi::xml_node &node, bool isClosed);
    void count(const pugi::xml_node &node, std::size_t points);
    void add(const pugi::xml_node &node, const State &state, const SvgSubpath &path);
    void addLine(std::vector<Vec2> points, const State &state);

    std::string_view m_bytes;
    std::string m_name;
    std::map<std::string, pugi::xml_node> m_byId;
    std::map<std::string, Styles> m_rules;
    SvgDrawing m_drawing;
    std::vector<Contour> *m_clipped = nullptr;   // where shapes go while a clip path is read
    double m_millimetres = kMillimetresPerPixel; // of the root's user unit
    std::size_t m_points = 0;
    std::optional<Error> m_error;
};

std::string localName(const pugi::xml_node &node)
{
    const std::string name = node.name();
    const std::size_t colon = name.find(':');
    return colon == std::string::npos || name.substr(0, colon) == "svg"
               ? name.substr(colon == std::string::npos ? 0 : colon + 1)
               : name;
}

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

/// The id in "url(#id)".
std::string urlTarget(const std::string &text)
{
    const std::size_t hash = text.find('#'), end = text.find_first_of(")'\"", hash);
    return hash == std::string::npos || !text.starts_with("url") || end == std::string::npos
               ? std::string()
               : text.substr(hash + 1, end - hash - 1);
}

/// A straight edge, unless it would have no length.
void lineTo(std::vector<Vec2> &points, const Vec2 &to)
{
    if (points.empty()) {
        points.push_back(to);
    } else if (points.back() != to) {
        const CubicBezier curve = CubicBezier::line(points.back(), to);
        points.insert(points.end(), {curve.p1, curve.p2, to});
    }
}

/// What stands there, on that line, short.
std::string shownAt(std::string_view bytes, std::ptrdiff_t offset)
{
    constexpr std::size_t kShown = 20;
    const auto from = static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0));
    const std::string_view rest = bytes.substr(std::min(from, bytes.size()), kShown);
    return std::string(rest.substr(0, rest.find_first_of("\r\n")));
}

std::string Reader::placeAt(std::ptrdiff_t offset) const
{
    const auto end = m_bytes.begin() + std::clamp<std::ptrdiff_t>(offset, 0, std::ssize(m_bytes));
    const std::string line = std::to_string(1 + std::count(m_bytes.begin(), end, '\n'));
    return m_name.empty() ? line : m_name + ":" + line;
}

void Reader::fail(ErrorCode code, const std::string &place, std::vector<std::string> args)
{
    if (!m_error)
        m_error = Error{code, place, std::move(args)};
}

void Reader::index(const pugi::xml_node &root)
{
    struct Walker : pugi::xml_tree_walker
    {
        std::map<std::string, pugi::xml_node> *ids = nullptr;
        std::string styles;
        bool isOurs = false;
        bool for_each(pugi::xml_node &node) override
        {
            if (const pugi::xml_attribute id = node.attribute("id"))
                ids->emplace(id.value(), node);
            if (localName(node) == "style")
                styles += node.text().get();
            isOurs = isOurs || std::strcmp(node.name(), "fff:cutting") == 0;
            return true;
        }
    };
    Walker walker;
    walker.ids = &m_byId;
    pugi::xml_node node = root;
    node.traverse(walker);
    m_rules = svgRules(walker.styles);
    m_drawing.isCuttingFile = walker.isOurs;
}

/// As the style attribute says, then the rules of a style element, then the attribute of its own.
std::string Reader::property(const pugi::xml_node &node, const char *name) const
{
    const Styles own = svgDeclarations(node.attribute("style").value());
    if (const auto found = own.find(name); found != own.end())
        return found->second;
    const auto ruled = [&](const std::string &selector) -> const std::string * {
        const auto rule = m_rules.find(selector);
        if (rule == m_rules.end())
            return nullptr;
        const auto found = rule->second.find(name);
        return found == rule->second.end() ? nullptr : &found->second;
    };
    if (const std::string id = node.attribute("id").value(); !id.empty())
        if (const std::string *value = ruled("#" + id))
            return *value;
    std::string classes = node.attribute("class").value();
    const std::string *last = nullptr;
    for (std::size_t from = 0; from < classes.size();) {
        const std::size_t end = std::min(classes.find_first_of(" \t\r\n", from), classes.size());
        if (const std::string *value = ruled("." + classes.substr(from, end - from)))
            last = value;
        from = end + 1;
    }
    if (!last)
        last = ruled(localName(node));
    return last ? *last : node.attribute(name).value();
}

double Reader::length(const pugi::xml_node &node, const char *name, double percentOf,
                      double otherwise)
{
    const pugi::xml_attribute attribute = node.attribute(name);
    if (!attribute || std::strcmp(attribute.value(), "auto") == 0)
        return otherwise;
    const std::optional<double> value = svgLength(attribute.value(), percentOf);
    if (!value)
        fail(ErrorCode::BadValue, placeOf(node),
             {attribute.value(), QT_TRANSLATE_NOOP("Error", "a length")});
    return value.value_or(otherwise);
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
    if (const std::string fill = property(node, "fill"); !fill.empty() && fill != "inherit")
        state.fill = lower(fill);
    if (const std::string stroke = property(node, "stroke"); !stroke.empty() && stroke != "inherit")
        state.stroke = lower(stroke);
    if (const std::string visible = property(node, "visibility"); !visible.empty())
        state.isVisible = visible == "visible" || visible == "inherit";
    const std::string transform = property(node, "transform");
    if (!transform.empty() && transform != "none") {
        if (const std::optional<SvgTransform> own = svgTransform(transform))
            state.transform = state.transform * *own;
        else
            fail(ErrorCode::BadValue, placeOf(node),
                 {transform, QT_TRANSLATE_NOOP("Error", "a transform")});
    }
    clip(node, state);
}

void Reader::clip(const pugi::xml_node &node, State &state)
{
    const std::string target = urlTarget(property(node, "clip-path"));
    const auto found = m_byId.find(target);
    if (target.empty() || found == m_byId.end() || m_clipped || m_error)
        return;
    std::vector<Contour> contours;
    m_clipped = &contours;
    State inside = state;
    inside.isVisible = true;
    inside.fill.clear();
    inside.clips.clear();
    ++inside.depth;
    enter(found->second, inside);
    children(found->second, inside);
    m_clipped = nullptr;
    state.clips.push_back(std::move(contours));
}

void Reader::children(const pugi::xml_node &node, const State &state)
{
    for (const pugi::xml_node &child : node.children())
        if (child.type() == pugi::node_element && !m_error)
            element(child, state);
}

void Reader::element(const pugi::xml_node &node, State state)
{
    static const std::set<std::string> kShapes{"path", "rect",     "circle", "ellipse",
                                               "line", "polyline", "polygon"};
    if (++state.depth > kDeepest) {
        fail(ErrorCode::BadCount, placeOf(node),
             {std::to_string(state.depth), std::to_string(kDeepest),
              QT_TRANSLATE_NOOP("Error", "groups in groups")});
        return;
    }
    const std::string name = localName(node);
    count(node, 1);
    const bool isText = name == "text" || name == "flowRoot" || name == "foreignObject";
    const bool isDrawn = kShapes.contains(name) || isText || name == "image" || name == "g" ||
                         name == "a" || name == "switch" || name == "svg" || name == "use";
    if (!isDrawn || property(node, "display") == "none")
        return;
    enter(node, state);
    if (m_error)
        return;
    if (isText) {
        m_drawing.texts += state.isVisible && !m_clipped ? 1 : 0;
    } else if (name == "image") {
        m_drawing.pictures += state.isVisible && !m_clipped ? 1 : 0;
    } else if (name == "use") {
        use(node, state);
    } else if (name == "svg") {
        const Vec2 &all = state.viewport;
        state.transform.translate(Vec2(length(node, "x", all.x()), length(node, "y", all.y())));
        nested(node, state,
               {length(node, "width", all.x(), all.x()), length(node, "height", all.y(), all.y())});
    } else if (name == "switch") {
        // The first one that any program can show.
        for (const pugi::xml_node &child : node.children())
            if (child.type() == pugi::node_element && !child.attribute("requiredExtensions") &&
                localName(child) != "foreignObject")
                return element(child, state);
    } else if (kShapes.contains(name)) {
        for (const SvgSubpath &path : shape(node, state))
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
    const auto found = target.starts_with('#') ? m_byId.find(target.substr(1)) : m_byId.end();
    if (found == m_byId.end())
        return;
    const Vec2 &all = state.viewport;
    state.transform.translate(Vec2(length(node, "x", all.x()), length(node, "y", all.y())));
    const pugi::xml_node used = found->second;
    if (localName(used) != "symbol") {
        element(used, state);
        return;
    }
    enter(used, state);
    nested(used, state,
           {length(node, "width", all.x(), all.x()), length(node, "height", all.y(), all.y())});
}

std::vector<SvgSubpath> Reader::rectangle(const pugi::xml_node &node, const State &state)
{
    const Vec2 &all = state.viewport;
    const Vec2 at(length(node, "x", all.x()), length(node, "y", all.y()));
    const Vec2 size(length(node, "width", all.x()), length(node, "height", all.y()));
    if (!(size.minCoeff() > 0.0))
        return {};
    double rx = length(node, "rx", all.x(), -1.0), ry = length(node, "ry", all.y(), -1.0);
    if (rx < 0.0)
        rx = std::max(ry, 0.0);
    if (ry < 0.0)
        ry = rx;
    const Vec2 radii(std::min(rx, 0.5 * size.x()), std::min(ry, 0.5 * size.y()));
    SvgSubpath path;
    path.isClosed = true;
    const Vec2 right(size.x(), 0.0), down(0.0, size.y());
    const auto line = [&path](const Vec2 &to) { lineTo(path.points, to); };
    constexpr double kQuarter = 1.5707963267948966;
    const bool isRound = radii.minCoeff() > 0.0;
    const Vec2 inset = isRound ? radii : Vec2(Vec2::Zero());
    const Vec2 corners[] = {at + right, at + right + down, at + down, at};
    const Vec2 inwards[] = {{-1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}};
    line(at + Vec2(inset.x(), 0.0));
    for (int i = 0; i < 4; ++i) {
        const Vec2 centre = corners[i] + inwards[i].cwiseProduct(inset);
        const double from = (i - 1) * kQuarter;
        const Vec2 begin = centre + inset.cwiseProduct(Vec2(std::cos(from), std::sin(from)));
        line(isRound ? begin : corners[i]);
        if (isRound)
            appendArc(centre, radii, 0.0, from, kQuarter, path.points);
    }
    path.points.back() = path.points.front();
    return {path};
}

std::vector<SvgSubpath> Reader::ellipse(const pugi::xml_node &node, const State &state)
{
    const Vec2 &all = state.viewport;
    const double diagonal = all.norm() / std::sqrt(2.0);
    const Vec2 centre(length(node, "cx", all.x()), length(node, "cy", all.y()));
    Vec2 radii = Vec2::Constant(length(node, "r", diagonal));
    if (localName(node) == "ellipse") {
        const double rx = length(node, "rx", all.x(), -1.0), ry = length(node, "ry", all.y(), -1.0);
        radii = {rx < 0.0 ? ry : rx, ry < 0.0 ? rx : ry};
    }
    if (!(radii.minCoeff() > 0.0))
        return {};
    SvgSubpath path{{centre + Vec2(radii.x(), 0.0)}, true};
    appendArc(centre, radii, 0.0, 0.0, 6.283185307179586, path.points);
    path.points.back() = path.points.front();
    return {path};
}

std::vector<SvgSubpath> Reader::corners(const pugi::xml_node &node, bool isClosed)
{
    SvgNumbers numbers(node.attribute("points").value());
    SvgSubpath path;
    path.isClosed = isClosed;
    while (!numbers.isAtEnd()) {
        const std::optional<double> x = numbers.number();
        const std::optional<double> y = x ? numbers.number() : std::nullopt;
        if (!y) {
            fail(ErrorCode::BadValue, placeOf(node),
                 {std::string(numbers.rest().substr(0, 20)),
                  QT_TRANSLATE_NOOP("Error", "pairs of numbers")});
            return {};
        }
        lineTo(path.points, {*x, *y});
    }
    if (isClosed && !path.points.empty())
        lineTo(path.points, Vec2(path.points.front()));
    return path.points.size() < 4 ? std::vector<SvgSubpath>() : std::vector<SvgSubpath>{path};
}

std::vector<SvgSubpath> Reader::shape(const pugi::xml_node &node, const State &state)
{
    const std::string name = localName(node);
    if (name == "rect")
        return rectangle(node, state);
    if (name == "circle" || name == "ellipse")
        return ellipse(node, state);
    if (name == "polyline" || name == "polygon")
        return corners(node, name == "polygon");
    if (name == "line") {
        const Vec2 &all = state.viewport;
        const Vec2 from(length(node, "x1", all.x()), length(node, "y1", all.y()));
        const Vec2 to(length(node, "x2", all.x()), length(node, "y2", all.y()));
        const CubicBezier curve = CubicBezier::line(from, to);
        return from == to ? std::vector<SvgSubpath>()
                          : std::vector<SvgSubpath>{{{from, curve.p1, curve.p2, to}, false}};
    }
    const std::string data = property(node, "d");
    if (data.empty() || data == "none")
        return {};
    SvgPathData path = svgPath(data);
    if (!path.isWhole)
        fail(ErrorCode::BadValue, placeOf(node),
             {path.rest.substr(0, 20), QT_TRANSLATE_NOOP("Error", "path data")});
    return std::move(path.subpaths);
}

/// Elements count, too: copies of copies of nothing would take as long.
void Reader::count(const pugi::xml_node &node, std::size_t points)
{
    m_points += points;
    if (m_points > kMostSvgPoints)
        fail(ErrorCode::BadCount, placeOf(node),
             {std::to_string(m_points), std::to_string(kMostSvgPoints),
              QT_TRANSLATE_NOOP("Error", "points")});
}

/// Of closed lines what is enclosed by all clips, of open ones what lies in them.
void Reader::add(const pugi::xml_node &node, const State &state, const SvgSubpath &path)
{
    count(node, path.points.size());
    const bool isFilled = isPaint(state.fill, true), isStroked = isPaint(state.stroke, false);
    if (m_error || !state.isVisible || !(isFilled || isStroked || m_clipped))
        return;
    std::vector<Vec2> points = path.points;
    for (Vec2 &p : points) {
        p = state.transform * p;
        // y upwards; the lower left comes to 0 when all is there.
        p = m_millimetres * Vec2(p.x(), -p.y());
        if (!p.allFinite() || p.cwiseAbs().maxCoeff() > kMaxCoordinate) {
            fail(ErrorCode::BadValue, placeOf(node),
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
        points.pop_back();
        if (Result<Contour> contour = Contour::fromPoints(std::move(points)))
            m_clipped->push_back(*std::move(contour));
        return;
    }
    addLine(std::move(points), state);
}

/// What of the contour lies in the clip: the contour without what is outside, and what of the clip
/// is a hole in that.
std::vector<Contour> clippedContour(const Contour &contour, const std::vector<Contour> &clip)
{
    std::vector<Contour> outside, inside;
    for (const CurvedRegion &region : subtractContours(contour, {}, clip, kCutChord)) {
        outside.push_back(region.outer);
        for (const Contour &hole : region.holes)
            inside.push_back(hole.reversed());
    }
    if (outside.empty())
        return {contour};
    for (const CurvedRegion &region : subtractContours(contour, {}, outside, kCutChord)) {
        inside.push_back(region.outer);
        inside.insert(inside.end(), region.holes.begin(), region.holes.end());
    }
    return inside;
}

bool contains(const std::vector<Contour> &clip, const Box2 &box)
{
    return std::any_of(clip.begin(), clip.end(), [&box](const Contour &contour) {
        const Polygon corners = contour.polygon(kCutChord);
        Region region{corners, {}};
        if (corners.size() != 4)
            return false;
        return locate(box.min, region) != Side::Outside &&
               locate(box.max, region) != Side::Outside &&
               locate({box.min.x(), box.max.y()}, region) != Side::Outside &&
               locate({box.max.x(), box.min.y()}, region) != Side::Outside;
    });
}

void Reader::addLine(std::vector<Vec2> points, const State &state)
{
    Result<CurvePath> path = CurvePath::fromPoints(std::move(points));
    if (!path)
        return;
    const bool isFilled = isPaint(state.fill, true);
    std::vector<CurvePath> paths{*std::move(path)};
    for (const std::vector<Contour> &clip : state.clips) {
        std::vector<CurvePath> left;
        for (const CurvePath &one : paths) {
            if (contains(clip, one.bounds())) {
                left.push_back(one);
            } else if (one.isClosed()) {
                std::vector<Vec2> closed = one.points();
                closed.pop_back();
                const Result<Contour> contour = Contour::fromPoints(std::move(closed));
                for (const Contour &piece :
                     contour ? clippedContour(*contour, clip) : std::vector<Contour>())
                    left.push_back(CurvePath::around(piece));
            } else {
                for (const Contour &contour : clip)
                    for (const Polygon &piece :
                         clippedLine(one.flatten(kCutChord), {contour.polygon(kCutChord), {}}))
                        if (Result<CurvePath> cut = CurvePath::fromLine(piece))
                            left.push_back(*std::move(cut));
            }
        }
        paths = std::move(left);
    }
    for (CurvePath &one : paths)
        m_drawing.lines.push_back({std::move(one), state.stroke, isFilled});
}

Result<SvgDrawing> Reader::read()
{
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(
        m_bytes.data(), m_bytes.size(), pugi::parse_default | pugi::parse_ws_pcdata_single);
    if (!parsed)
        return failure(ErrorCode::BadSyntax, placeAt(parsed.offset),
                       {shownAt(m_bytes, parsed.offset), QT_TRANSLATE_NOOP("Error", "XML")});
    const pugi::xml_node svg = document.document_element();
    if (localName(svg) != "svg")
        return failure(ErrorCode::BadSyntax, placeOf(svg),
                       {svg.name(), QT_TRANSLATE_NOOP("Error", "an SVG drawing")});
    index(svg);
    State state;
    const bool isCut = svg.attribute("width") || svg.attribute("viewBox");
    state.transform = isCut ? rootTransform(svg, state) : SvgTransform::Identity();
    m_millimetres = millimetresPerPixel(svg, m_bytes);
    State inside = state;
    enter(svg, inside);
    if (!m_error)
        children(svg, inside);
    if (m_error)
        return tl::unexpected(*m_error);
    if (m_drawing.lines.empty() && m_drawing.texts == 0 && m_drawing.pictures == 0)
        return failure(ErrorCode::BadValue, m_name,
                       {"", QT_TRANSLATE_NOOP("Error", "lines, shapes or paths")});
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
