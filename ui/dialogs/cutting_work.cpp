#include "ui/dialogs/cutting_work.h"

#include "core/analysis/analysed.h"
#include "core/fabrication/nested_layout.h"
#include "core/session/scheduler.h"
#include "core/session/session.h"
#include "core/session/sheet_nesting.h"

#include <QThreadPool>

#include <mutex>

namespace fff::ui {

namespace {

/// Less of a sheet nobody puts aside, mm.
constexpr double kLeastWhole = 30.0;

std::vector<SheetPaths> withWholes(std::vector<SheetPaths> sheets, const Nested &nested)
{
    const std::vector<double> heights =
        takenHeights(*nested.layout, nested.parts->parts, nested.question->nesting.layout);
    for (std::size_t i = 0; i < sheets.size() && i < heights.size(); ++i)
        if (heights[i] > 0.0 && sheets[i].size.height() - heights[i] >= kLeastWhole)
            sheets[i].wholeFrom = heights[i];
    return sheets;
}

std::vector<SheetPaths> pathsWith(const Nested &nested, const CutFinish &finish,
                                  bool hasJointColours)
{
    if (!nested.cutting)
        return {};
    if (finish.isPlain() && !hasJointColours)
        return withWholes(sheetPaths(nested.cutting->drawing), nested);
    CuttingDrawing drawing = nested.cutting->drawing; // its parts' lines are shared
    for (CuttingSheet &sheet : drawing.sheets)
        sheet.finish = finish;
    drawing.hasJointColours = hasJointColours;
    return withWholes(sheetPaths(drawing), nested);
}

} // namespace

/// A dialog that is closed does not wait for what is worked out for it: that comes to nobody.
struct CuttingWork::Mail
{
    std::mutex mutex;
    CuttingWork *to = nullptr; // null: gone
};

CuttingWork::CuttingWork(const Session &session, SheetNesting &nesting, QObject *parent)
    : QObject(parent), m_session(session), m_nesting(&nesting), m_mail(std::make_shared<Mail>())
{
    m_mail->to = this;
    connect(&session, &Session::modelChanged, this, [this] { Q_EMIT changed(); }); // it is older
    connect(&nesting, &SheetNesting::changed, this, [this] {
        begin();
        Q_EMIT changed();
    });
    begin();
}

CuttingWork::~CuttingWork()
{
    if (m_nesting) {
        m_nesting->disconnect(this); // whoever hears of changes here is half gone
        setWanted(false);
    }
    const std::scoped_lock lock(m_mail->mutex);
    m_mail->to = nullptr;
}

void CuttingWork::setWanted(bool isWanted)
{
    m_nesting->setWanted(this, isWanted);
}

void CuttingWork::setLook(const CutFinish &finish, bool hasJointColours)
{
    m_finish = finish;
    m_hasJointColours = hasJointColours;
    begin();
}

bool CuttingWork::isAsked(const Made &made) const
{
    return made.finish == m_finish && made.hasJointColours == m_hasJointColours;
}

const Cutting *CuttingWork::cutting() const
{
    return m_made ? m_made->nested->cutting.get() : nullptr;
}

std::optional<Error> CuttingWork::whyNot() const
{
    // The analysis that it would be made of is not there, and will not come.
    if (const auto why = m_session.scheduler().whyNot(kNested.name))
        return why;
    return m_made && !isWorking() ? m_made->nested->why : std::nullopt;
}

bool CuttingWork::isWorking() const
{
    if (m_session.scheduler().whyNot(kNested.name))
        return false;
    return m_isRunning || !m_made || m_made->nested != m_nesting->result() || !isAsked(*m_made) ||
           !m_nesting->isCurrent();
}

void CuttingWork::begin()
{
    if (m_isRunning)
        return; // what is newest by then follows when it is done
    const std::shared_ptr<const Nested> nested = m_nesting->result();
    if (!nested || (m_made && m_made->nested == nested && isAsked(*m_made)))
        return;
    m_isRunning = true;
    QThreadPool::globalInstance()->start([mail = m_mail, nested, finish = m_finish,
                                          isColoured = m_hasJointColours] {
        auto made = std::make_shared<const Made>(Made{nested->analysis, nested, finish, isColoured,
                                                      pathsWith(*nested, finish, isColoured)});
        const std::scoped_lock lock(mail->mutex);
        if (CuttingWork *to = mail->to)
            QMetaObject::invokeMethod(
                to, [to, made] { to->take(made); }, Qt::QueuedConnection);
    });
}

void CuttingWork::take(std::shared_ptr<const Made> made)
{
    m_isRunning = false;
    m_made = std::move(made);
    begin();
    Q_EMIT changed();
}

} // namespace fff::ui
