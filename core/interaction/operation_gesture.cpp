#include "core/interaction/operation_gesture.h"

#include "core/model/operation_edits.h"
#include "core/operations/operation_kind.h"
#include "core/operations/operation_words.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

//: %1 is the name of an operation, %2 a number
constexpr Text kMovingBeginning =
    FFF_TEXT("Hint", "Release to start %1 here: %2\u202f%. <kbd>Esc</kbd> cancels.");
//: %1 is the name of an operation, %2 a number
constexpr Text kMovingEnd =
    FFF_TEXT("Hint", "Release to end %1 here: %2\u202f%. <kbd>Esc</kbd> cancels.");

} // namespace

OperationGesture::OperationGesture(const OperationMarks &marks, int handle,
                                   const PointerEvent &press, const GestureContext &context)
    : m_marks(marks), m_handle(static_cast<std::size_t>(handle))
{
    const OperationHandle &own = m_marks.handles[m_handle];
    const Operation &operation = *context.model.document.find(own.operation);
    const ParameterSpec &spec = *operationKind(operation.kind)->parameter(own.key);
    m_name = operation.name;
    m_step = spec.step;
    m_least = std::max(spec.least, m_marks.track.front().second);
    m_most = std::min(spec.most, m_marks.track.back().second);
    const bool isAscending = std::is_sorted(
        m_marks.handles.begin(), m_marks.handles.end(),
        [](const OperationHandle &a, const OperationHandle &b) { return a.value < b.value; });
    const bool mayPass = m_marks.isRing() || !isAscending;
    for (std::size_t i = 0; i < m_marks.handles.size() && !mayPass; ++i) {
        if (i < m_handle)
            m_least = std::max(m_least, m_marks.handles[i].value);
        if (i > m_handle)
            m_most = std::min(m_most, m_marks.handles[i].value);
    }
    m_grip =
        valueOnTrack(m_marks.track, context.camera, context.viewport, press.position) - own.value;
    m_marks.hovered = handle;
}

double OperationGesture::valueAt(const PointerEvent &event, const GestureContext &context) const
{
    const double value =
        valueOnTrack(m_marks.track, context.camera, context.viewport, event.position) - m_grip;
    return std::clamp(m_step * std::round(value / m_step), m_least, std::max(m_least, m_most));
}

GestureReply OperationGesture::handle(const PointerEvent &event, GestureContext &context)
{
    GestureReply reply;
    const OperationHandle &own = m_marks.handles[m_handle];
    const double value = event.isFollowed && m_shown ? *m_shown : valueAt(event, context);
    if (m_shown != value) {
        Operation next = *context.model.document.find(own.operation);
        next.parameters.insert_or_assign(own.key, value);
        Result<Document> edited = setOperation(context.model.document, std::move(next));
        if (edited) {
            m_shown = value;
            m_last = *std::move(edited);
        }
    }
    if (event.type == PointerEvent::Type::Release) {
        reply.state = GestureReply::State::Over;
        if (m_shown && *m_shown != own.value) {
            reply.commit =
                GestureReply::Commit{steps::changed(*context.model.document.find(own.operation),
                                                    own.key, own.value, *m_shown),
                                     std::move(m_last)};
        }
        return reply;
    }
    if (m_shown)
        reply.preview = m_last;
    OperationMarks shown = m_marks;
    if (m_shown) {
        shown.handles[m_handle].value = *m_shown;
        shown.handles[m_handle].at = placeOnTrack(m_marks.track, *m_shown);
    }
    context.overlay.selected.put(std::move(shown));
    return reply;
}

GestureReply OperationGesture::cancel(GestureContext &)
{
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    return reply;
}

Hint OperationGesture::hint() const
{
    const OperationHandle &own = m_marks.handles[m_handle];
    const double tenths = std::round(1000.0 * m_shown.value_or(own.value));
    return {own.key == "from" ? kMovingBeginning : kMovingEnd,
            {Named{m_name}, Decimal{0.1 * tenths, 1}}};
}

} // namespace fff
