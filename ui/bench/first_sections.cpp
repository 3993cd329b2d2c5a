#include "ui/bench/first_sections.h"

#include "core/session/check_list.h"
#include "core/session/session.h"

#include <utility>

namespace fff::ui {

namespace {

/// With more of them a person knows what they are about.
constexpr std::size_t kMostFirst = 3;

bool isBegun(const Document &document)
{
    return document.sections.size() <= kMostFirst && document.operations.empty();
}

} // namespace

FirstSections::FirstSections(const Session &session, CheckList &list,
                             std::function<bool()> isDrawing, QObject *parent)
    : QObject(parent), m_session(session), m_list(list), m_isDrawing(std::move(isDrawing))
{
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPause);
    connect(&m_pause, &QTimer::timeout, this, &FirstSections::leaveAlone);
    connect(&session, &Session::modelChanged, this, &FirstSections::follow);
}

void FirstSections::follow(const Model &before, const Model &after)
{
    // What was opened is as somebody left it, and edits of what is there may do harm.
    const bool isDrawn = m_session.history()->index() > 0 || m_session.hasPreview();
    const bool hasNew = after.document.sections.size() > before.document.sections.size();
    if (!isDrawn || !isBegun(after.document))
        return takeAsIs();
    if (!hasNew && !m_pause.isActive())
        return;
    m_list.setBeginning(true);
    m_pause.start();
}

void FirstSections::leaveAlone()
{
    if (m_isDrawing())
        m_pause.start();
    else
        takeAsIs();
}

void FirstSections::takeAsIs()
{
    m_pause.stop();
    m_list.setBeginning(false);
}

} // namespace fff::ui
