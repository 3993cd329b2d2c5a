#include "core/session/sheet_nesting.h"

#include "core/session/scheduler.h"
#include "core/session/session.h"

#include <utility>

namespace fff {

namespace {

bool areEqual(const SheetsQuestion &a, const SheetsQuestion &b)
{
    return a.asksForTheSame(b) && a.level == b.level && a.round == b.round && a.times == b.times;
}

} // namespace

SheetNesting::SheetNesting(Session &session, QObject *parent) : QObject(parent), m_session(session)
{
    connect(&session, &Session::replaced, this, [this] {
        m_level = NestLevel::Quick;
        m_isSearching = false;
        m_asked.reset(); // a document that comes in is asked nothing
        m_result.reset();
    });
    connect(&session, &Session::modelChanged, this, &SheetNesting::follow);
    connect(&session.scheduler(), &Scheduler::published, this, &SheetNesting::take);
    connect(&session.scheduler(), &Scheduler::progressed, this, [this] {
        if (m_isSearching)
            Q_EMIT progressed();
    });
}

void SheetNesting::setWanted(const void *who, bool isWanted)
{
    if (isWanted == m_wanting.contains(who))
        return;
    if (isWanted)
        m_wanting.insert(who);
    else
        m_wanting.erase(who);
    if (m_wanting.empty())
        m_isSearching = false;
    ask(NestLevel::Quick);
    Q_EMIT changed();
}

void SheetNesting::setOptions(const NestOptions &options)
{
    NestOptions next = options;
    next.work = 0;
    next.pinned.clear();
    if (next == m_options)
        return;
    m_options = std::move(next);
    m_level = NestLevel::Quick;
    m_isSearching = false;
    ask(NestLevel::Quick);
    Q_EMIT changed();
}

SheetsQuestion SheetNesting::question(NestLevel level) const
{
    SheetsQuestion question;
    question.nesting = m_options;
    question.level = level;
    question.round = level == NestLevel::Best ? m_round : 0;
    question.times = m_times;
    return question;
}

void SheetNesting::ask(NestLevel level)
{
    m_running = level;
    Scheduler &scheduler = m_session.scheduler();
    std::shared_ptr<const SheetsQuestion> next;
    if (isWanted()) {
        next = std::make_shared<const SheetsQuestion>(question(level));
        if (m_asked && m_asked == scheduler.questions().sheets && areEqual(*m_asked, *next))
            return;
        scheduler.want(kNested.name);
    } else if (!scheduler.questions().sheets) {
        return;
    }
    m_asked = next;
    Questions questions = scheduler.questions();
    questions.sheets = std::move(next);
    scheduler.ask(questions);
}

void SheetNesting::nest(NestLevel level)
{
    m_level = level;
    m_round = 0;
    m_isSearching = level != NestLevel::Quick;
    m_since.start();
    if (level == NestLevel::Quick)
        ++m_times;
    ask(isCurrent() ? level : NestLevel::Quick);
    Q_EMIT changed();
}

void SheetNesting::stop()
{
    if (!std::exchange(m_isSearching, false))
        return;
    // The run that is under way ends with what is best so far, which Quick leaves where it is.
    ask(NestLevel::Quick);
    Q_EMIT changed();
}

double SheetNesting::progress() const
{
    return m_running == NestLevel::Good ? m_session.scheduler().progress(kNested.name) : -1.0;
}

double SheetNesting::searchedFor() const
{
    constexpr double kSecond = 1000.0; // ms
    return m_since.isValid() ? static_cast<double>(m_since.elapsed()) / kSecond : 0.0;
}

/// The model is another one.
void SheetNesting::follow()
{
    if (!isWanted())
        return;
    if (!m_isSearching)
        m_level = NestLevel::Quick;
    m_round = 0;
    ask(NestLevel::Quick);
    Q_EMIT changed();
}

void SheetNesting::take(std::string_view stage)
{
    if (stage != kNested.name)
        return;
    if (const auto result = m_session.scheduler().result(kNested); result && result->question)
        m_result = result;
    goOn();
    Q_EMIT changed();
}

/// To the next run of a search, once there is what it begins with.
void SheetNesting::goOn()
{
    if (!m_isSearching || !isCurrent() || m_result->question != m_asked)
        return;
    if (m_running == NestLevel::Quick) {
        ask(m_level);
    } else if (m_result->isStopped) {
        // By another question, of something else: its own run comes.
    } else if (m_running == NestLevel::Best) {
        ++m_round;
        ask(NestLevel::Best);
    } else {
        m_isSearching = false;
        ask(NestLevel::Quick); // leaves it, and what comes is quick
    }
}

bool SheetNesting::isCurrent() const
{
    return m_result && m_result->question->nesting == m_options &&
           m_session.analysedRevision() == m_session.revision() &&
           m_result->analysis == m_session.analysisPointer();
}

std::shared_ptr<const Layout> SheetNesting::layoutOf(const AnalysisPointer &analysis,
                                                     const NestOptions &options) const
{
    NestOptions asked = options;
    asked.work = 0;
    asked.pinned.clear();
    const bool isOfThat =
        m_result && m_result->analysis == analysis && m_result->question->nesting == asked;
    return isOfThat ? m_result->layout : nullptr;
}

} // namespace fff
