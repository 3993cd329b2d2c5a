#include "core/session/session_host.h"

#include "core/analysis/pulling.h"
#include "core/session/message_text.h"
#include "core/session/scheduler.h"

namespace fff {

SessionHost::SessionHost(Session &session, QObject *parent) : QObject(parent), m_session(session) {}

void SessionHost::attach(Interaction &interaction)
{
    connect(&m_session, &Session::modelChanged, this,
            [&interaction] { interaction.modelChanged(); });
    connect(&m_session, &Session::committedChanged, this,
            [&interaction] { interaction.modelChanged(); });
    connect(&m_session, &Session::replaced, this, [&interaction] {
        interaction.select({});
        interaction.forgetViews();
    });
    interaction.modelChanged();
}

const Model &SessionHost::model() const
{
    return m_session.committed();
}

std::shared_ptr<const PulledTemplates> SessionHost::pulled() const
{
    return m_session.scheduler().result(kPulled);
}

void SessionHost::preview(Document document)
{
    m_session.preview(std::move(document));
}

void SessionHost::cancelPreview()
{
    m_session.cancelPreview();
}

void SessionHost::commit(const Step &step, Document document)
{
    m_session.commit(messageText(step.words), std::move(document), step.merges);
}

void SessionHost::chooseProblem(int number, int place)
{
    Q_EMIT problemChosen(number, place);
}

void SessionHost::chooseParameter(OperationId operation, const std::string &key)
{
    Q_EMIT parameterChosen(operation, QString::fromStdString(key));
}

} // namespace fff
