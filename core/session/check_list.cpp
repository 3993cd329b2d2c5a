#include "core/session/check_list.h"

#include "core/session/session.h"

namespace fff {

namespace {

// ms. Most answers come sooner than the eye sees a change; saying in between that they are older
// would only flicker.
constexpr int kSeen = 100, kLate = 500;

} // namespace

CheckList::CheckList(const Session &session, QObject *parent)
    : QObject(parent), m_session(session),
      m_job(
          [this](const AnalysisPointer &analysis) -> VerdictsPointer {
              return std::make_shared<const Verdicts>(
                  Verdicts{analysis->model, checks(*analysis, m_caches)});
          },
          [this](std::uint64_t revision, VerdictsPointer verdicts) {
              if (revision != m_session.revision() && m_session.model().sectionCount() == 0)
                  return; // late, on what is gone
              m_verdicts = std::move(verdicts);
              m_revision = revision;
              if (revision == m_session.revision()) {
                  m_becomesOlder.stop();
                  m_becomesLate.stop();
                  m_age = Age::Current;
              }
              Q_EMIT changed();
          })
{
    m_becomesOlder.setSingleShot(true);
    m_becomesOlder.setInterval(kSeen);
    m_becomesLate.setSingleShot(true);
    m_becomesLate.setInterval(kLate);
    connect(&m_becomesOlder, &QTimer::timeout, this, [this] { grow(Age::Older); });
    connect(&m_becomesLate, &QTimer::timeout, this, [this] { grow(Age::Late); });
    connect(&session, &Session::modelChanged, this, &CheckList::modelChanged);
    connect(&session, &Session::analysisChanged, this,
            [this] { m_job.request(m_session.analysedRevision(), m_session.analysisPointer()); });
    m_job.request(session.analysedRevision(), session.analysisPointer());
    if (session.analysedRevision() != session.revision())
        modelChanged();
}

CheckList::~CheckList() = default;

/// The verdicts age from the first change on that they do not know.
void CheckList::modelChanged()
{
    if (m_session.model().sectionCount() == 0) {
        // Nothing follows from nothing.
        m_verdicts = std::make_shared<const Verdicts>();
        m_becomesOlder.stop();
        m_becomesLate.stop();
        m_age = Age::Current;
        Q_EMIT changed();
        return;
    }
    if (m_age != Age::Current || m_becomesOlder.isActive())
        return;
    m_becomesOlder.start();
    m_becomesLate.start();
}

void CheckList::grow(Age age)
{
    m_age = age;
    Q_EMIT changed();
}

void CheckList::finish()
{
    m_job.finish();
}

} // namespace fff
