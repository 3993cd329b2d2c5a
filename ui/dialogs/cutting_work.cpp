#include "ui/dialogs/cutting_work.h"

#include "core/analysis/analysed.h"
#include "core/session/scheduler.h"
#include "core/session/session.h"

#include <QThreadPool>

#include <mutex>

namespace fff::ui {

/// A dialog that is closed does not wait for what is worked out for it: that comes to nobody.
struct CuttingWork::Mail
{
    std::mutex mutex;
    CuttingWork *to = nullptr; // null: gone
};

namespace {

bool areTheSameOptions(const CuttingOptions &a, const CuttingOptions &b)
{
    return a.layout == b.layout && a.compensatesKerf == b.compensatesKerf &&
           a.hasReference == b.hasReference;
}

} // namespace

CuttingWork::CuttingWork(const Session &session, QObject *parent)
    : QObject(parent), m_session(session), m_mail(std::make_shared<Mail>())
{
    m_mail->to = this;
    connect(&session, &Session::modelChanged, this, [this] { Q_EMIT changed(); }); // it is older
    connect(&session.scheduler(), &Scheduler::published, this, [this](std::string_view stage) {
        if (stage != kAnalysed.name)
            return;
        begin();
        Q_EMIT changed();
    });
    begin();
}

CuttingWork::~CuttingWork()
{
    const std::scoped_lock lock(m_mail->mutex);
    m_mail->to = nullptr;
}

void CuttingWork::setOptions(const CuttingOptions &options)
{
    if (areTheSameOptions(options, m_options))
        return;
    m_options = options;
    begin();
    Q_EMIT changed();
}

const Cutting *CuttingWork::cutting() const
{
    return m_made && m_made->cutting ? &*m_made->cutting : nullptr;
}

std::optional<Error> CuttingWork::whyNot() const
{
    // The analysis that it would be made of is not there, and will not come.
    if (const auto why = m_session.scheduler().whyNot(kAnalysed.name))
        return why;
    return m_made && !m_made->cutting && !isWorking() ? std::optional(m_made->cutting.error())
                                                      : std::nullopt;
}

bool CuttingWork::isWorking() const
{
    if (m_session.scheduler().whyNot(kAnalysed.name))
        return false;
    return m_isRunning || !m_made || m_made->analysis != m_session.analysisPointer() ||
           m_session.analysedRevision() != m_session.revision() ||
           !areTheSameOptions(m_options, m_optionsOfMade);
}

void CuttingWork::begin()
{
    if (m_isRunning)
        return; // what is newest by then follows when it is done
    const AnalysisPointer analysis = m_session.analysisPointer();
    if (m_session.analysedRevision() != m_session.revision())
        return; // begun when it is there
    if (m_made && m_made->analysis == analysis && areTheSameOptions(m_options, m_optionsOfMade))
        return;
    m_isRunning = true;
    QThreadPool::globalInstance()->start([mail = m_mail, analysis, options = m_options] {
        Result<Cutting> cutting = makeCutting(*analysis, options);
        std::vector<SheetPaths> sheets =
            cutting ? sheetPaths(cutting->drawing) : std::vector<SheetPaths>();
        auto made =
            std::make_shared<const Made>(Made{analysis, std::move(cutting), std::move(sheets)});
        const std::scoped_lock lock(mail->mutex);
        if (CuttingWork *to = mail->to)
            QMetaObject::invokeMethod(
                to, [to, made, options] { to->take(made, options); }, Qt::QueuedConnection);
    });
}

void CuttingWork::take(std::shared_ptr<const Made> made, const CuttingOptions &options)
{
    m_isRunning = false;
    m_made = std::move(made);
    m_optionsOfMade = options;
    begin();
    Q_EMIT changed();
}

} // namespace fff::ui
