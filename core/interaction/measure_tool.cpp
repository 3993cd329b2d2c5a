#include "core/interaction/measure_tool.h"

#include "core/base/tolerances.h"
#include "core/interaction/measure_words.h"
#include "core/operations/scaled_model.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// A line shorter than this says nothing about the size of anything, mm.
constexpr double kShortest = 1e-3;

const Dimension *find(const Document &document, DimensionId id)
{
    const auto found = std::find_if(document.dimensions.begin(), document.dimensions.end(),
                                    [id](const Dimension &d) { return d.id == id; });
    return found == document.dimensions.end() ? nullptr : &*found;
}

} // namespace

bool MeasureTool::takes(const PointerEvent &press, GestureContext &context) const
{
    return dimensionAt(press.position, context).isValid() ||
           measuredPlaceAt(press.position, !press.modifiers.control, context).has_value();
}

bool MeasureTool::takesControl(const PointerEvent &press, GestureContext &context) const
{
    return takes(press, context);
}

GestureReply MeasureTool::press(const PointerEvent &event, GestureContext &context)
{
    m_wanted.reset();
    if (!m_from) {
        if (const DimensionId id = dimensionAt(event.position, context); id.isValid()) {
            m_dimension = id;
            follow(context);
            return {};
        }
    }
    if (!m_place)
        return {};
    if (m_from) { // the second of two clicks
        if ((m_place->point - m_from->point).norm() >= kShortest)
            m_line = Ends{*m_from, *m_place};
        m_from.reset();
        return {};
    }
    m_dimension = {};
    m_line.reset();
    m_from = m_place;
    m_press = event.position;
    m_isDrag = false;
    return {};
}

GestureReply MeasureTool::handle(const PointerEvent &event, GestureContext &context)
{
    m_place = measuredPlaceAt(event.position, !event.modifiers.control, context);
    m_hovered = m_from ? DimensionId() : dimensionAt(event.position, context);
    if (event.isPress()) {
        press(event, context);
        return shown();
    }
    if (m_press && !m_isDrag)
        m_isDrag = (event.position - *m_press).norm() > context.settings.dragThreshold;
    if (event.type == PointerEvent::Type::Release && m_press) {
        m_press.reset();
        if (m_isDrag && m_place && m_from) {
            if ((m_place->point - m_from->point).norm() >= kShortest)
                m_line = Ends{*m_from, *m_place};
            m_from.reset();
        }
    }
    return shown();
}

/// The line that stays is where its sections are.
void MeasureTool::follow(const GestureContext &context)
{
    if (const Dimension *dimension = find(context.model.document, m_dimension)) {
        const auto from = placeOf(context.model, dimension->from);
        const auto to = placeOf(context.model, dimension->to);
        m_line.reset();
        if (from && to && (*to - *from).norm() >= kShortest)
            m_line = Ends{{*from, dimension->from}, {*to, dimension->to}};
        return;
    }
    m_dimension = {};
    if (!m_line)
        return;
    const auto from = placeOf(context.model, m_line->from.anchor);
    const auto to = placeOf(context.model, m_line->to.anchor);
    if (!from || !to || (*to - *from).norm() < kShortest) {
        m_line.reset();
        return;
    }
    m_line->from.point = *from;
    m_line->to.point = *to;
}

GestureReply MeasureTool::shown() const
{
    GestureReply reply;
    if (m_wanted && m_wanted->scaled)
        reply.preview = *m_wanted->scaled;
    return reply;
}

void MeasureTool::mark(GestureContext &context, bool hasCursor)
{
    Signs &signs = context.overlay.held;
    const auto show = [&](const Vec3 &from, const Vec3 &to) {
        signs.add(sign::Line{SignRole::Measured, {from, to}, true});
        signs.add(sign::Label{SignRole::Measured, {from, to}, sign::Way{to - from, m_isDimension}});
    };
    if (m_from && m_place)
        show(m_from->point, m_place->point);
    else if (m_line && m_wanted)
        show(factor() * m_line->from.point, factor() * m_line->to.point);
    else if (m_line)
        show(m_line->from.point, m_line->to.point);
    if (hasCursor && m_place)
        signs.add(sign::Handle{SignRole::Place, m_place->point});
    context.hovered.dimension = m_dimension.isValid() ? m_dimension : m_hovered;
}

GestureReply MeasureTool::interrupt(GestureContext &)
{
    m_from.reset();
    m_press.reset();
    return shown();
}

GestureReply MeasureTool::cancel(GestureContext &)
{
    GestureReply reply;
    if (m_wanted) {
        m_wanted.reset();
    } else if (m_from || m_line) {
        m_from.reset();
        m_press.reset();
        m_line.reset();
        m_dimension = {};
    } else {
        reply.state = GestureReply::State::Over;
    }
    return reply;
}

GestureReply MeasureTool::modelChanged(GestureContext &context)
{
    m_from.reset();
    m_press.reset();
    m_place.reset();
    m_wanted.reset();
    follow(context);
    return {};
}

std::vector<ToolNumber> MeasureTool::numbers() const
{
    if (!m_isDimension || !m_line)
        return {};
    return {{ToolNumber::Kind::Wanted, m_wanted ? m_wanted->length : m_line->length()}};
}

GestureReply MeasureTool::setNumbers(const std::vector<ToolNumber> &numbers,
                                     GestureContext &context)
{
    for (const ToolNumber &number : numbers)
        if (number.kind == ToolNumber::Kind::Wanted && m_line && m_isDimension &&
            number.value >= kShortest && number.value <= kMaxCoordinate)
            m_wanted = Wanted{number.value,
                              scaledModel(context.model.document, number.value / m_line->length())};
    return shown();
}

GestureReply MeasureTool::dropNumbers(GestureContext &)
{
    m_wanted.reset();
    return {};
}

GestureReply MeasureTool::key(ToolKey key, GestureContext &)
{
    GestureReply reply;
    if (key != ToolKey::Enter || !m_wanted || !m_line)
        return reply;
    const double factor = this->factor();
    Result<Document> scaled = std::move(m_wanted->scaled);
    m_wanted.reset();
    if (!scaled) {
        reply.note = notScaled(scaled.error());
        return reply;
    }
    for (MeasuredPlace *end : {&m_line->from, &m_line->to}) {
        end->point *= factor;
        end->anchor.at *= factor;
    }
    reply.commit = {scaledBy(factor), *std::move(scaled)};
    return reply;
}

std::vector<std::string_view> MeasureTool::commands() const
{
    if (!m_line)
        return {};
    std::vector<std::string_view> commands{m_dimension.isValid() ? "measure.remove"
                                                                 : "measure.keep"};
    if (!m_isDimension)
        commands.push_back(kDimension);
    return commands;
}

std::optional<MeasureTool::Line> MeasureTool::line() const
{
    if (!m_line || m_dimension.isValid())
        return std::nullopt;
    return Line{m_line->from.anchor, m_line->to.anchor};
}

Hint MeasureTool::hint() const
{
    if (m_from)
        return hints::kSecondPlace;
    if (m_line)
        return m_isDimension ? hints::kDimensionType : hints::kMeasured;
    return m_isDimension ? hints::kDimensionFrom : hints::kMeasureFrom;
}

Hint notScaled(const Error &error)
{
    if (error.place.empty())
        return Hint::refusal(hints::kNotScaled);
    return Hint::refusal(hints::kNotScaledSoFar, {Named{error.place}});
}

Step scaledBy(double factor)
{
    //: %1 is a number of percent
    return {FFF_TEXT("Step", "Scale the model to %1 %"),
            {static_cast<int>(std::lround(100.0 * factor))}};
}

} // namespace fff
