#include "ui/view/steps_page_data.h"

#include "core/base/tolerances.h"
#include "core/fabrication/marks.h"
#include "core/io/full_stop.h"
#include "core/io/json_writer.h"
#include "ui/view/view_style.h"

#include <QByteArray>
#include <QtEndian>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>

namespace fff::ui {

namespace {

using JsonLayout = io::JsonWriter::Layout;

constexpr double kUnit = 0.01;     // mm
constexpr double kPlaceUnit = 1e4; // of a mm, in which places are written
constexpr double kAxisUnit = 1e7;
constexpr double kMost = std::numeric_limits<std::int16_t>::max();

template <class Integer>
std::string base64(const std::vector<Integer> &numbers)
{
    QByteArray bytes(static_cast<qsizetype>(numbers.size() * sizeof(Integer)), '\0');
    for (std::size_t i = 0; i < numbers.size(); ++i)
        qToLittleEndian(numbers[i], bytes.data() + i * sizeof(Integer));
    return bytes.toBase64().toStdString();
}

/// In units about a middle.
struct Scale
{
    Vec2 middle = Vec2::Zero();
    double unit = kUnit;

    explicit Scale(const Box2 &box)
        : middle(box.center()), unit(std::max(kUnit, 0.5 * box.size().maxCoeff() / kMost))
    {
    }
    void add(std::vector<std::int16_t> &to, const Vec2 &point) const
    {
        const Vec2 at = (point - middle) / unit;
        for (const double v : {at.x(), at.y()})
            to.push_back(static_cast<std::int16_t>(std::lround(std::clamp(v, -kMost, kMost))));
    }
};

struct Shape3d
{
    std::size_t look = 0;
    double thickness = 0.0, unit = kUnit;
    std::string points, triangles;
    bool isWide = false;

    auto operator<=>(const Shape3d &) const = default;
};

std::string trianglesOf(const Triangulation &triangulation, bool isWide)
{
    std::vector<std::uint32_t> corners;
    for (const auto &triangle : triangulation.triangles)
        for (const int corner : triangle)
            corners.push_back(static_cast<std::uint32_t>(corner));
    return isWide ? base64(corners)
                  : base64(std::vector<std::uint16_t>(corners.begin(), corners.end()));
}

Shape3d shapeOf(const Body &body, std::size_t look, const Scale &scale)
{
    const Triangulation &triangulation = body.cut()->triangulations()->at(body.piece());
    std::vector<std::int16_t> points;
    for (const Vec2 &point : triangulation.points)
        scale.add(points, point);
    const bool isWide = triangulation.points.size() > std::numeric_limits<std::uint16_t>::max();
    return {look,  body.thickness(), scale.unit, base64(points), trianglesOf(triangulation, isWide),
            isWide};
}

double rounded(double value, double unit)
{
    return std::round(value * unit) / unit;
}

void writeRow(io::JsonWriter &json, const Vec3 &v, double unit)
{
    for (int i = 0; i < 3; ++i)
        json.value(rounded(v[i], unit));
}

void writeEngraving(io::JsonWriter &json, const Engraving &engraving, const Scale &scale)
{
    std::vector<std::int16_t> points;
    std::vector<std::size_t> counts;
    const auto add = [&](std::span<const Vec2> line) {
        for (const Vec2 &point : line)
            scale.add(points, point);
        counts.push_back(line.size());
    };
    for (const auto *lines : {&engraving.lines.engraved, &engraving.lines.scored})
        for (const CurvePath &line : *lines)
            add(line.flatten(kDrawChord));
    for (std::size_t i = 0; i < engraving.strokes.size(); ++i)
        add(engraving.strokes[i]);
    if (engraving.hasNumber) {
        const Vec2 at = engraving.boxes.back().center() - scale.middle;
        json.member("numberAt", Vec2(rounded(at.x(), kPlaceUnit), rounded(at.y(), kPlaceUnit)));
    }
    json.key("engraved");
    json.beginObject(JsonLayout::Line);
    json.member("points", base64(points));
    json.key("counts");
    json.beginArray(JsonLayout::Line);
    for (const std::size_t count : counts)
        json.value(count);
    json.endArray();
    json.endObject();
}

/// All parts, and the shapes that they have.
class Parts
{
public:
    explicit Parts(const AssemblySteps &steps) : m_steps(steps)
    {
        const Analysis &analysis = *steps.analysis;
        m_parts = makeParts(analysis.model, analysis.assembly, analysis.bodies);
        for (std::size_t i = 0; i < steps.bodies.size(); ++i)
            add(static_cast<int>(i));
    }

    void writeLooks(io::JsonWriter &json) const
    {
        json.beginArray();
        for (const StockId id : m_stocks) {
            const StockLook look = stockLook(*m_steps.analysis->model.document.find(id));
            json.beginObject(JsonLayout::Line);
            json.member("face", look.face.name().toStdString());
            json.member("side", look.side.name().toStdString());
            json.member("alpha", look.alpha);
            json.endObject();
        }
        json.endArray();
    }

    void writeShapes(io::JsonWriter &json) const
    {
        json.beginArray();
        for (const Shape3d *shape : m_shapes) {
            json.beginObject(JsonLayout::Line);
            json.member("look", shape->look);
            json.member("thickness", shape->thickness);
            json.member("unit", shape->unit);
            json.member("points", shape->points);
            json.member("triangles", shape->triangles);
            json.member("isWide", shape->isWide);
            json.endObject();
        }
        json.endArray();
    }

    void writeParts(io::JsonWriter &json) const
    {
        json.beginArray();
        for (std::size_t i = 0; i < m_parts.size(); ++i) {
            const Body &body = m_steps.bodies[i];
            const Scale scale(bounds(body.outline().region.outer));
            json.beginObject(JsonLayout::Line);
            json.member("number", m_parts[i].number);
            json.member("shape", m_shapeOf[i]);
            json.key("place");
            json.beginArray(JsonLayout::Line);
            writeRow(json, body.frame().toWorld(scale.middle), kPlaceUnit);
            writeRow(json, body.frame().x, kAxisUnit);
            writeRow(json, body.frame().y, kAxisUnit);
            json.endArray();
            const auto &marks = m_steps.sectionOf(static_cast<int>(i)).marks;
            writeEngraving(json, engrave(m_parts[i], marks), scale);
            json.endObject();
        }
        json.endArray();
    }

private:
    void add(int index)
    {
        const Body &body = m_steps.bodies.at(index);
        const StockId stock = m_parts[static_cast<std::size_t>(index)].stock;
        const auto known = std::find(m_stocks.begin(), m_stocks.end(), stock);
        const auto look = static_cast<std::size_t>(known - m_stocks.begin());
        if (known == m_stocks.end())
            m_stocks.push_back(stock);
        const Scale scale(bounds(body.outline().region.outer));
        const auto [place, isNew] =
            m_known.emplace(shapeOf(body, look, scale), static_cast<int>(m_shapes.size()));
        if (isNew)
            m_shapes.push_back(&place->first);
        m_shapeOf.push_back(place->second);
    }

    const AssemblySteps &m_steps;
    std::vector<Part> m_parts;
    std::vector<StockId> m_stocks; // by their looks' indices
    std::map<Shape3d, int> m_known;
    std::vector<const Shape3d *> m_shapes; // in the order of their first parts
    std::vector<int> m_shapeOf;            // of each part
};

void writeSteps(io::JsonWriter &json, const AssemblySteps &steps)
{
    json.beginArray();
    for (int i = 0; i < steps.playback.stepCount(); ++i) {
        json.beginObject(JsonLayout::Line);
        json.member("title", stepTitle(steps, i).toStdString());
        json.member("text", stepSentence(steps, i).toStdString());
        json.key("parts");
        json.beginArray(JsonLayout::Line);
        for (const int part : steps.playback.plan().steps[static_cast<std::size_t>(i)].parts)
            json.value(part);
        json.endArray();
        json.key("way");
        json.beginArray(JsonLayout::Line);
        for (const Vec3 &corner : steps.playback.way(i)) {
            json.beginArray(JsonLayout::Line);
            writeRow(json, corner, kPlaceUnit);
            json.endArray();
        }
        json.endArray();
        json.endObject();
    }
    json.endArray();
}

} // namespace

QString stepSentence(const AssemblySteps &steps, int step)
{
    QString text = stepText(steps, step);
    if (!text.isEmpty())
        text[0] = text[0].toUpper();
    return withFullStop(text);
}

std::string stepsPageData(const AssemblySteps &steps, const std::map<std::string, QString> &texts,
                          const Camera &looking)
{
    const Parts parts(steps);
    io::JsonWriter json;
    json.beginObject();
    json.key("texts");
    json.beginObject();
    for (const auto &[key, text] : texts)
        json.member(key, text.toStdString());
    json.endObject();
    json.key("view");
    json.beginArray(JsonLayout::Line);
    writeRow(json, looking.backward(), kAxisUnit);
    json.endArray();
    json.key("looks");
    parts.writeLooks(json);
    json.key("shapes");
    parts.writeShapes(json);
    json.key("parts");
    parts.writeParts(json);
    json.key("steps");
    writeSteps(json, steps);
    json.endObject();
    // Within a text only; so no name of a section looks like "</script" or "<!--".
    return QByteArray::fromStdString(json.take()).replace('<', "\\u003c").toStdString();
}

} // namespace fff::ui
